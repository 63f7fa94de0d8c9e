//! The predicates from formulas: where the nearest points of two features are, and which of two pairs is nearer.
//!
//! The squared distance of the lines or planes of a pair is a quotient n/d of polynomials with d > 0. So n₁/d₁ is
//! compared with n₂/d₂ by the sign of n₁·d₂ − n₂·d₁, a polynomial of degree 10 at most.

use std::sync::OnceLock;

use predicament_predicates::formula::{Definition, Formula};
use predicament_predicates::{Derived, Dimension};

/// The dimensions of the features of a pair, the smaller first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Ranks {
    VertexVertex,
    VertexEdge,
    VertexFace,
    EdgeEdge,
}

impl Ranks {
    /// The pairs of a dimension.
    pub(super) const fn all(dimension: Dimension) -> &'static [Ranks] {
        const ALL: [Ranks; 4] = [Ranks::VertexVertex, Ranks::VertexEdge, Ranks::VertexFace, Ranks::EdgeEdge];
        match dimension {
            Dimension::Two => ALL.split_at(2).0,
            Dimension::Three => &ALL,
        }
    }

    /// The number of vertices of a pair.
    const fn arity(self) -> usize {
        match self {
            Ranks::VertexVertex => 2,
            Ranks::VertexEdge => 3,
            Ranks::VertexFace | Ranks::EdgeEdge => 4,
        }
    }

    /// Numerator and denominator of the squared distance of points with these names, the smaller feature first.
    fn squared(self, dimension: Dimension, names: &[String]) -> [String; 2] {
        let of = |at: usize| names[at].as_str();
        match self {
            Ranks::VertexVertex => [format!("sq({} - {})", of(1), of(0)), String::new()],
            Ranks::VertexEdge => {
                let [p, a, b] = [of(0), of(1), of(2)];
                let cross = format!("cross({b} - {a}, {p} - {a})");
                let numerator = match dimension {
                    Dimension::Two => format!("({cross})^2"),
                    Dimension::Three => format!("sq({cross})"),
                };
                [numerator, format!("sq({b} - {a})")]
            }
            Ranks::VertexFace => {
                let [p, a, b, c] = [of(0), of(1), of(2), of(3)];
                let [u, v] = [format!("{b} - {a}"), format!("{c} - {a}")];
                [format!("(det({u}, {v}, {p} - {a}))^2"), format!("sq(cross({u}, {v}))")]
            }
            Ranks::EdgeEdge => {
                let [a, b, c, d] = [of(0), of(1), of(2), of(3)];
                let [u, v] = [format!("{b} - {a}"), format!("{d} - {c}")];
                [format!("(det({u}, {v}, {c} - {a}))^2"), format!("sq(cross({u}, {v}))")]
            }
        }
    }
}

/// The predicates of one dimension.
pub(super) struct Formulas {
    /// Positive if p is ahead of a, on the way to b: (b − a)·(p − a).
    pub(super) ahead: Derived,
    /// Positive if p, projected into the plane of a, b, c, is on c's side of the line a b.
    pub(super) within: Option<Derived>,
    /// Positive if the point of the line a b that is nearest to the line c d is ahead of a. Zero for parallel lines.
    pub(super) foot: Option<Derived>,
    /// The comparison of squared distances of two pairs, by ranks; those of the second pair are not smaller.
    comparisons: Vec<(Ranks, Ranks, Derived)>,
}

fn derived(name: &str, about: &str, dimension: Dimension, text: String, points: Vec<String>) -> Derived {
    let definition =
        Definition { name: name.to_owned(), about: about.to_owned(), text, points, dimension: Some(dimension.count()) };
    let formula = Formula::new(definition).unwrap_or_else(|error| panic!("{name}: {error}"));
    Derived::new(formula).unwrap_or_else(|reason| panic!("{name}: {reason}"))
}

impl Formulas {
    fn new(dimension: Dimension) -> Formulas {
        let named = |name: &str, about: &str, text: &str, points: &str| {
            let points = points.split(' ').map(ToOwned::to_owned).collect();
            derived(name, about, dimension, text.to_owned(), points)
        };
        let in_space = |make: &dyn Fn() -> Derived| (dimension == Dimension::Three).then(make);
        let mut comparisons = Vec::new();
        let all = Ranks::all(dimension);
        for (at, &first) in all.iter().enumerate() {
            for &second in &all[at..] {
                let names = |letter: char, ranks: Ranks| -> Vec<String> {
                    (0..ranks.arity()).map(|at| format!("{letter}{at}")).collect()
                };
                let (of_first, of_second) = (names('a', first), names('b', second));
                let [n, d] = first.squared(dimension, &of_first);
                let [m, e] = second.squared(dimension, &of_second);
                let times = |n: &str, e: &str| if e.is_empty() { n.to_owned() } else { format!("{n} * {e}") };
                let text = format!("{} - {}", times(&n, &e), times(&m, &d));
                let (name, about) = ("compare_pairs", "the squared distance of one pair minus that of another pair");
                let derived = derived(name, about, dimension, text, [of_first, of_second].concat());
                comparisons.push((first, second, derived));
            }
        }
        Formulas {
            ahead: named("ahead", "(b − a)·(p − a)", "dot(b - a, p - a)", "a b p"),
            within: in_space(&|| {
                let text = "u = b - a; dot(cross(cross(u, c - a), u), p - a)";
                named("within", "the side of a b, in the plane of a b c, to which p projects", text, "a b c p")
            }),
            foot: in_space(&|| {
                let text = "u = b - a; v = d - c; w = c - a; dot(u, w) * sq(v) - dot(u, v) * dot(v, w)";
                named("foot", "the place on a b that is nearest to the line c d", text, "a b c d")
            }),
            comparisons,
        }
    }

    /// The predicates of a dimension, made once.
    pub(super) fn of(dimension: Dimension) -> &'static Formulas {
        static PLANE: OnceLock<Formulas> = OnceLock::new();
        static SPACE: OnceLock<Formulas> = OnceLock::new();
        match dimension {
            Dimension::Two => PLANE.get_or_init(|| Formulas::new(dimension)),
            Dimension::Three => SPACE.get_or_init(|| Formulas::new(dimension)),
        }
    }

    /// All predicates.
    pub(super) fn all(&self) -> impl Iterator<Item = Derived> {
        let comparisons = self.comparisons.iter().map(|(.., derived)| *derived);
        comparisons.chain([self.ahead]).chain(self.within).chain(self.foot)
    }

    /// The comparison of pairs of these dimensions, the smaller first; `None` if they are not pairs of this dimension.
    pub(super) fn comparison(&self, first: Ranks, second: Ranks) -> Option<Derived> {
        self.comparisons.iter().find(|(one, other, _)| (*one, *other) == (first, second)).map(|(.., derived)| *derived)
    }
}
