//! Figures 1 and 5 of the paper, entered for the audit alone.
//!
//! Checking a backend against the bands that it claims itself proves nothing: if a constant is doubled, claim and
//! answer change together. So the bands of a backend of tolerances are taken from here. The backend only contributes
//! its precision: of two values of ε that are far apart, the one whose σ₊ is nearer to the claimed σ₊.
//!
//! All tolerances are stored as squares, since the exact quantities are compared as squares. An irrational root is
//! rounded outward from T, so that no promise is stricter than the paper's.

mod formula;

use predicament_arithmetic::difference_up;
use predicament_error_calculus::Enclosure;
use predicament_predicates::{Axis, Band, Dimension, Plane, Predicates, Question, Scene};
use rug::{Integer, Rational};

pub use formula::units;

/// A tolerance of the paper, by its symbol in the paper.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symbol {
    /// σ, vertex-vertex.
    Sigma,
    /// τ, edge-vertex.
    Tau,
    /// δ, triangle-vertex in space.
    Delta,
    /// γ, edge-edge in space.
    Gamma,
    /// σ̂, the smallest length of an edge that is used as a divisor.
    SigmaHat,
    /// κ, areas in the plane.
    Kappa,
    /// λ, the squared area of two edges.
    Lambda,
    /// φ, the weights of two edges.
    Phi,
    /// ν, the squared area of a triangle.
    Nu,
    /// ζ, the weights of a triangle.
    Zeta,
    /// μ, volumes of an edge with the edges of a triangle.
    Mu,
    /// ξ, volumes of a triangle with the ends of an edge.
    Xi,
    /// ρ, volumes of a vertex with the faces of a tetrahedron.
    Rho,
}

/// The squares of T₋, T and T₊: c², as a multiple of 1 or 3, over some denominator.
struct Row {
    symbol: Symbol,
    /// Four times the numbers of the figure, which are all quarters; the last is divided by √3 if it is irrational.
    quarters: [u32; 3],
    /// True if T₊ has the factor √3.
    root3: bool,
    /// The exponent of ε in quarters: 4e, for ε^e.
    epsilon_quarters: u32,
    /// The exponent of L: p, for L^p.
    power: u32,
}

const fn row(symbol: Symbol, quarters: [u32; 3], epsilon_quarters: u32, power: u32) -> Row {
    Row { symbol, quarters, root3: false, epsilon_quarters, power }
}

/// A row with T₊ a multiple of √3, where the figure has a rounded number: the constraint that defines it.
const fn root3(symbol: Symbol, quarters: [u32; 3], epsilon_quarters: u32, power: u32) -> Row {
    Row { symbol, quarters, root3: true, epsilon_quarters, power }
}

/// The rows of Figure 1.
const FIGURE_1: [Row; 4] = [
    row(Symbol::Sigma, [24, 26, 28], 2, 1),
    row(Symbol::Tau, [16, 18, 20], 2, 1),
    row(Symbol::SigmaHat, [20, 22, 24], 2, 1),
    row(Symbol::Kappa, [40, 84, 128], 4, 2),
];

/// The rows of Figure 5. ζ₊ = 12√3 (16 − 6.25)², ξ₊ = ρ₊ = 48√3.
const FIGURE_5: [Row; 12] = [
    row(Symbol::Sigma, [24, 26, 28], 1, 1),
    row(Symbol::Tau, [16, 18, 20], 1, 1),
    row(Symbol::Delta, [8, 9, 10], 1, 1),
    row(Symbol::Gamma, [8, 9, 10], 1, 1),
    row(Symbol::SigmaHat, [20, 22, 24], 1, 1),
    row(Symbol::Lambda, [3640, 4860, 6084], 4, 4),
    row(Symbol::Phi, [600, 1880, 3042], 4, 4),
    row(Symbol::Nu, [13_689, 27_378, 41_067], 4, 4),
    root3(Symbol::Zeta, [2632, 5268, 4563], 4, 4),
    row(Symbol::Mu, [64, 96, 128], 3, 3),
    root3(Symbol::Xi, [112, 224, 192], 3, 3),
    root3(Symbol::Rho, [112, 224, 192], 3, 3),
];

/// The rows of a dimension.
const fn figure(dimension: Dimension) -> &'static [Row] {
    match dimension {
        Dimension::Two => &FIGURE_1,
        Dimension::Three => &FIGURE_5,
    }
}

impl Row {
    /// The squares T₋², T² and T₊² for √ε and L.
    fn squares(&self, half: &Enclosure, length: &Enclosure) -> [Rational; 3] {
        // (ε^e)²; e is in quarters, so this is √ε to the same power.
        let unit = half.power(self.epsilon_quarters) * length.power(2 * self.power);
        let [lower, width, upper] = self.quarters.map(|c| Rational::from((Integer::from(c).square(), 16)));
        let factor = if self.root3 { 3 } else { 1 };
        [lower * &unit.lower, width * &unit.lower, upper * factor * unit.upper]
    }
}

/// Our bands of the circle predicates, in units of ε L⁴ and ε L⁵: the error bounds 129 and 1129 in steps of one more.
const INCIRCLE: [u32; 3] = [130, 260, 390];
const INSPHERE: [u32; 3] = [1130, 2260, 3390];

/// The exponents k of the machine epsilons 2⁻ᵏ that backends compute with, double and single precision.
const HALVINGS: [u32; 2] = [52, 23];

impl Symbol {
    /// All symbols, lengths first.
    pub const ALL: [Symbol; 13] = [
        Symbol::Sigma,
        Symbol::Tau,
        Symbol::Delta,
        Symbol::Gamma,
        Symbol::SigmaHat,
        Symbol::Kappa,
        Symbol::Lambda,
        Symbol::Phi,
        Symbol::Nu,
        Symbol::Zeta,
        Symbol::Mu,
        Symbol::Xi,
        Symbol::Rho,
    ];

    /// The symbol as the paper writes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Symbol::Sigma => "σ",
            Symbol::Tau => "τ",
            Symbol::Delta => "δ",
            Symbol::Gamma => "γ",
            Symbol::SigmaHat => "σ̂",
            Symbol::Kappa => "κ",
            Symbol::Lambda => "λ",
            Symbol::Phi => "φ",
            Symbol::Nu => "ν",
            Symbol::Zeta => "ζ",
            Symbol::Mu => "μ",
            Symbol::Xi => "ξ",
            Symbol::Rho => "ρ",
        }
    }
}

/// The published tolerances of one dimension for one ε and one L.
#[derive(Clone, Debug)]
pub struct Published {
    dimension: Dimension,
    /// The squares T₋², T² and T₊² by symbol.
    squares: Vec<(Symbol, [Rational; 3])>,
    /// The squared unit (εL)².
    pub unit_squared: Rational,
}

impl Published {
    /// The tolerances for ε = 2^−`halvings` and L.
    #[must_use]
    pub fn new(dimension: Dimension, halvings: u32, length: &Enclosure) -> Published {
        let epsilon = Enclosure::exact(Rational::from(1) >> halvings);
        let half = epsilon.sqrt();
        let squares = figure(dimension).iter().map(|row| (row.symbol, row.squares(&half, length))).collect();
        let unit_squared = (epsilon.power(2) * length.power(2)).lower;
        Published { dimension, squares, unit_squared }
    }

    /// The tolerances for ε = 2^−`halvings` and the largest bounding-box edges of a primitive of each complex.
    #[must_use]
    pub fn for_lengths(dimension: Dimension, lengths: [f64; 2], halvings: u32) -> Published {
        Published::new(dimension, halvings, &contact_length(dimension, lengths, halvings))
    }

    /// The tolerances that a session's contacts must satisfy; `None` if it claims no band for contacts.
    ///
    /// L is that of the lengths in the scene, (1 + 5ε)/(1 − 7√ε)(La + Lb) in the plane and with ε^¼ in space.
    #[must_use]
    pub fn of<S: Predicates + ?Sized>(session: &S) -> Option<Published> {
        let claimed = session.contact_band([0, 0])?;
        let (dimension, lengths) = (session.scene().dimension(), session.scene().primitive_lengths()?);
        let all = HALVINGS.map(|k| Published::for_lengths(dimension, lengths, k));
        Some(nearest(claimed.upper, all, |published| root(&published.limits(Symbol::Sigma)[2])))
    }

    /// The dimension of the tolerances.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The squares T₋², T² and T₊² of a tolerance.
    ///
    /// # Panics
    /// If the dimension has no such tolerance.
    #[must_use]
    pub fn limits(&self, symbol: Symbol) -> &[Rational; 3] {
        let found = self.squares.iter().find(|(of, _)| *of == symbol);
        &found.unwrap_or_else(|| panic!("{} is no tolerance of {:?}", symbol.name(), self.dimension)).1
    }

    /// T₋, T and T₊, rounded; precise enough for generators.
    ///
    /// # Panics
    /// If the dimension has no such tolerance.
    #[must_use]
    pub fn rounded(&self, symbol: Symbol) -> [f64; 3] {
        self.limits(symbol).each_ref().map(root)
    }

    /// The symbol of the distance tolerance for a pair of these ranks, the higher rank first.
    #[must_use]
    pub fn distance(&self, ranks: [u8; 2]) -> Option<Symbol> {
        match (self.dimension, ranks) {
            (_, [0, 0]) => Some(Symbol::Sigma),
            (_, [1, 0]) => Some(Symbol::Tau),
            (Dimension::Three, [1, 1]) => Some(Symbol::Gamma),
            (Dimension::Three, [2, 0]) => Some(Symbol::Delta),
            _ => None,
        }
    }
}

/// The band that a sign must satisfy: κ, ξ and our own of the circles, with L the largest extent of all points, and for
/// a formula the band that its program and the scene give. `None` if the session claims no band.
///
/// The claim decides only whether the band is of single precision: it is if the claim is within a factor of two of it.
/// A comparison has no published band, so the claim holds for it.
#[must_use]
pub fn band<S: Predicates + ?Sized>(session: &S, question: Question) -> Option<Band> {
    let claimed = session.band(question)?;
    let scene = session.scene();
    let plane = |plane: Plane| extent(scene, &plane.axes());
    let of = |halvings: u32| {
        let exact = |length: f64| Enclosure::exact(Rational::from_f64(length).unwrap_or_default());
        let figure = |dimension, symbol, length: f64| {
            let half = Enclosure::exact(Rational::from(1) >> halvings).sqrt();
            let row = figure(dimension).iter().find(|row| row.symbol == symbol).expect("a tolerance of the dimension");
            let [lower, width, upper] = row.squares(&half, &exact(length)).each_ref().map(root);
            Band { lower, width, upper }
        };
        let ours = |numbers: [u32; 3], power: u32, length: f64| {
            let unit = exact(length).power(power).lower >> halvings;
            let [lower, width, upper] = numbers.map(|c| Rational::from(&unit * c).to_f64());
            Band { lower, width, upper }
        };
        match question {
            Question::Orient2d(of) => figure(Dimension::Two, Symbol::Kappa, plane(of)),
            Question::Orient3d => figure(Dimension::Three, Symbol::Xi, extent(scene, &[Axis::X, Axis::Y, Axis::Z])),
            Question::Incircle => ours(INCIRCLE, 4, plane(Plane::Xy)),
            Question::Insphere => ours(INSPHERE, 5, extent(scene, &[Axis::X, Axis::Y, Axis::Z])),
            Question::Derived(derived) => formula::band(scene, derived, halvings),
            Question::Compare(_) => claimed,
        }
    };
    let [double, single] = HALVINGS.map(of);
    let is_single = (0.5..=2.0).contains(&(claimed.upper / single.upper));
    Some(if is_single { single } else { double })
}

/// The length L of Algorithm 1 or 6.
fn contact_length(dimension: Dimension, lengths: [f64; 2], halvings: u32) -> Enclosure {
    let epsilon = Enclosure::exact(Rational::from(1) >> halvings);
    let root = match dimension {
        Dimension::Two => epsilon.sqrt(),
        Dimension::Three => epsilon.sqrt().sqrt(),
    };
    let number = |n: i32| Enclosure::exact(n.into());
    let sum: Rational = lengths.iter().map(|&x| Rational::from_f64(x).unwrap_or_default()).sum();
    (number(1) + number(5) * epsilon) * Enclosure::exact(sum) * (number(1) - number(7) * root).reciprocal()
}

/// The largest extent of a scene along these axes, rounded up.
fn extent(scene: &Scene, axes: &[Axis]) -> f64 {
    let along = |&axis: &Axis| {
        let coordinates = || scene.vertices().map(|v| scene.coordinate(axis, v));
        let low = coordinates().fold(f64::INFINITY, f64::min);
        let high = coordinates().fold(f64::NEG_INFINITY, f64::max);
        if scene.is_empty() { 0.0 } else { difference_up(high, low) }
    };
    axes.iter().map(along).fold(0.0, f64::max)
}

/// The one of two items whose value is nearer to the claimed value, by their quotient. The two values must be far
/// apart.
fn nearest<T>(claimed: f64, [first, second]: [T; 2], value: impl Fn(&T) -> f64) -> T {
    let off = |value: f64| (claimed / value).ln().abs();
    if off(value(&second)) < off(value(&first)) { second } else { first }
}

/// The square root, rounded. The square must be within the powers that doubles hold, as all tolerances of a scene are.
fn root(square: &Rational) -> f64 {
    Enclosure::exact(square.clone()).sqrt().lower.to_f64()
}
