//! The published bounds, compared with derived ones.

use predicament_error_calculus::rules::largest_epsilon;
use predicament_error_calculus::{Bound, Enclosure, Quantity, Ring, Root};
use rug::Rational;

use super::algorithms;
use super::coefficient::Tolerance;
use super::published::{Kind, M_SQUARED, Published, QUANTITIES, TOLERANCES};
use super::quantities::{Named, Normalization, Points, plane, space};
use crate::circles::{LIFTED, Lifted};

/// A stated bound and the result of the calculus.
#[derive(Clone, Debug)]
pub struct Derivation {
    /// The section or figure with the bound, or `ours`.
    pub section: &'static str,
    /// The name of the bounded value, such as `E[d²]`.
    pub name: String,
    /// The published number before ε, or before L^p for a magnitude.
    ///
    /// `None` if the bound is ours.
    pub published: Option<u32>,
    /// The quantity that the calculus derives.
    pub quantity: Quantity,
    /// The derived bound of the same kind; `None` if no rule gives one.
    pub derived: Option<Bound>,
    /// True if it bounds the quantity, not the error of the quantity.
    pub is_magnitude: bool,
}

/// The comparison of a derived bound with the published one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// The derived bound is the same whole number.
    Reproduced,
    /// The derived bound is less: the published bound holds.
    Smaller,
    /// The derived bound is more: the published bound can't be derived.
    Larger,
    /// No rule gives a bound.
    Invalid,
    /// The paper has no such bound.
    Ours,
}

impl Verdict {
    /// The verdict's text in tables.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Verdict::Reproduced => "reproduced",
            Verdict::Smaller => "smaller",
            Verdict::Larger => "larger",
            Verdict::Invalid => "invalid",
            Verdict::Ours => "ours",
        }
    }
}

impl Derivation {
    fn new(section: &'static str, symbol: &str, kind: Kind, published: Option<u32>, quantity: Quantity) -> Derivation {
        let (name, derived) = match kind {
            Kind::Absolute => (format!("E[{symbol}]"), quantity.absolute()),
            Kind::Relative => (format!("R[{symbol}]"), quantity.relative()),
        };
        Derivation { section, name, published, quantity, derived, is_magnitude: false }
    }

    /// The derived number in the paper's form: whole, rounded up.
    #[must_use]
    pub fn whole(&self) -> Option<u32> {
        self.derived.as_ref().map(|bound| bound.rounded_up().to_u32().expect("bounds are small"))
    }

    /// The verdict on the derived bound against the published one.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (self.published, self.whole()) {
            (None, _) => Verdict::Ours,
            (Some(_), None) => Verdict::Invalid,
            (Some(published), Some(derived)) => match derived.cmp(&published) {
                std::cmp::Ordering::Less => Verdict::Smaller,
                std::cmp::Ordering::Equal => Verdict::Reproduced,
                std::cmp::Ordering::Greater => Verdict::Larger,
            },
        }
    }
}

fn coordinates<const D: usize>() -> Points<Quantity, D> {
    let axes = ["x", "y", "z"];
    ["A", "B", "C", "D", "P", "Q"]
        .map(|point| std::array::from_fn(|i| Quantity::coordinate(&format!("{point}{}", axes[i]))))
}

fn all(normalization: Normalization) -> Vec<Named<Quantity>> {
    let mut all = plane(&coordinates(), normalization);
    all.extend(space(&coordinates(), normalization));
    all
}

fn find(all: &[Named<Quantity>], section: &str, symbol: &str) -> Quantity {
    let named = all.iter().find(|named| named.section == section && named.symbol == symbol);
    named.unwrap_or_else(|| panic!("{symbol} of {section} is stated and not computed")).value.clone()
}

fn derive(all: &[Named<Quantity>], Published { section, symbol, kind, figure }: Published) -> Derivation {
    Derivation::new(section, symbol, kind, Some(figure), find(all, section, symbol))
}

/// Every bound that the paper states, and our bounds, in the paper's order.
///
/// The order is: bounds of quantities, of L and the tolerances in the text, of the tables.
#[must_use]
pub fn derivations() -> Vec<Derivation> {
    let computed = all(Normalization::Reciprocal);
    let mut derived: Vec<_> = QUANTITIES.into_iter().map(|stated| derive(&computed, stated)).collect();
    derived.push(magnitude(find(&computed, "5.4", "m²")));
    derived.extend(TOLERANCES.into_iter().map(of_tolerances));
    derived.extend(tables());
    for symbol in LIFTED.map(|lifted| lifted.name) {
        derived.push(Derivation::new("ours", symbol, Kind::Absolute, None, find(&computed, "ours", symbol)));
    }
    let rounded = with_rounded_sides().map(|(symbol, relative)| (symbol.to_owned(), relative));
    for (symbol, relative) in rounded.into_iter().chain(band_widths()) {
        derived.push(Derivation::new("ours", &symbol, Kind::Relative, None, relative));
    }
    derived
}

/// The bounds that depend on the normalization of vectors, with true division.
#[must_use]
pub fn other_orders() -> Vec<Derivation> {
    let (ours, other) = (all(Normalization::Reciprocal), all(Normalization::Division));
    let stated = QUANTITIES.into_iter();
    let pairs = stated.map(|stated| (derive(&ours, stated), derive(&other, stated)));
    pairs.filter(|(ours, other)| ours.derived != other.derived).map(|(_, other)| other).collect()
}

fn magnitude(quantity: Quantity) -> Derivation {
    let c = quantity.magnitude().map(|magnitude| magnitude.c.clone());
    Derivation {
        section: "5.4",
        name: "m²".to_owned(),
        published: Some(M_SQUARED),
        derived: c.map(|first| Bound { first, second: Rational::new() }),
        quantity,
        is_magnitude: true,
    }
}

/// The middle values of Figures 1 and 5 as quantities.
fn widths() -> [Vec<(&'static Tolerance, Quantity)>; 2] {
    let (epsilon, length) = (Quantity::epsilon(), Quantity::length());
    [algorithms::plane(&epsilon, &length, Quantity::constant), algorithms::space(&epsilon, &length, Quantity::constant)]
}

fn tables() -> Vec<Derivation> {
    let figures = ["figure 1", "figure 5"].into_iter().zip(widths());
    let rows = figures.flat_map(|(section, rows)| rows.into_iter().map(move |row| (section, row)));
    rows.map(|(section, (tolerance, width))| {
        Derivation::new(section, tolerance.symbol, Kind::Relative, Some(tolerance.printed_relative), width)
    })
    .collect()
}

/// The middle value T of each band of circles and spheres, with its symbol.
fn band_widths() -> [(String, Quantity); 2] {
    let (epsilon, length) = (Quantity::epsilon(), Quantity::length());
    let square = length.clone() * length.clone();
    let fourth = square.clone() * square.clone();
    LIFTED.map(|Lifted { name, band: [_, width, _], degree, .. }| {
        let unit = if degree == 4 { fourth.clone() } else { fourth.clone() * length.clone() };
        let width = Quantity::constant(Rational::from_f64(width).expect("finite"));
        (format!("T {name}"), width * (epsilon.clone() * unit))
    })
}

fn of_tolerances(stated: Published) -> Derivation {
    let [_, space] = widths();
    let value = |symbol: &str| {
        let (_, value) = space.iter().find(|(row, _)| row.symbol == symbol).expect("of figure 5");
        value.clone()
    };
    let quantity = match (stated.section, stated.symbol) {
        ("4.1", _) => length(Quantity::epsilon().sqrt(), side),
        ("5.1", "L̂") => length(Quantity::epsilon().sqrt().sqrt(), side),
        // all lengths of figure 5 have the same form
        ("5.1", "ζ") => value("σ"),
        ("5.1", "ζ²") => value("σ").square(),
        ("5.1", _) => (value("σ").square() - value("τ").square()).sqrt(),
        _ => value("γ").square(),
    };
    Derivation::new(stated.section, stated.symbol, stated.kind, Some(stated.figure), quantity)
}

/// The inputs La and Lb of Algorithms 1 and 6.
fn side(name: &str) -> Quantity {
    Quantity::given(name)
}

/// The inputs La and Lb as rounded differences of coordinates.
fn rounded_side(name: &str) -> Quantity {
    let [high, low] = ["high", "low"].map(|end| Quantity::coordinate(&format!("{name}_{end}")));
    (high - low).nonnegative()
}

/// The length L̂ of 4.1 and 5.1 with sides that are rounded differences.
fn with_rounded_sides() -> [(&'static str, Quantity); 2] {
    let root = Quantity::epsilon().sqrt();
    [
        ("L̂ of 4.1, sides rounded", length(root.clone(), rounded_side)),
        ("L̂ of 5.1, sides rounded", length(root.sqrt(), rounded_side)),
    ]
}

/// The length L̂, with 1 − 7√ε (or 7ε^¼) bounded from below at the largest ε.
fn length(root: Quantity, side: fn(&str) -> Quantity) -> Quantity {
    let magnitude = root.magnitude().expect("a root of ε").clone();
    let quarter = Enclosure::exact(largest_epsilon()).sqrt().sqrt();
    let quarters = u32::try_from(magnitude.epsilon_quarters).expect("a positive power");
    let smallest = Rational::from(1) - quarter.power(quarters).upper * 7;
    algorithms::length([side("La"), side("Lb")], root, Quantity::constant(7), |difference| {
        difference.at_least(&smallest).nonnegative()
    })
}
