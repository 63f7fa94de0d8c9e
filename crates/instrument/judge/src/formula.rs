//! The value of a formula in rationals, from its syntax tree alone.
//!
//! [`interpret`] evaluates the tree as it is written. It shares no code with the programs, integers and dyadic numbers
//! that backends use.

use predicament_predicates::formula::{Formula, Ring, interpret};
use predicament_predicates::{Derived, Scene, Vertex};
use rug::Rational;

use crate::Verdict;

/// A number, and its magnitude: the same expression with the absolute value of every product and difference.
#[derive(Clone)]
struct Number {
    value: Rational,
    magnitude: Rational,
    /// True for coordinates and constants: the magnitude of a sum of two of them is its absolute value.
    is_given: bool,
}

impl Number {
    fn given(value: Rational) -> Number {
        Number { magnitude: value.clone().abs(), value, is_given: true }
    }
}

impl Ring for Number {
    fn whole(number: f64) -> Number {
        Number::given(Rational::from_f64(number).unwrap_or_default())
    }

    fn plus(&self, other: &Number, minus: bool) -> Number {
        let value =
            if minus { Rational::from(&self.value - &other.value) } else { Rational::from(&self.value + &other.value) };
        let both = self.is_given && other.is_given;
        let magnitude = if both { value.clone().abs() } else { Rational::from(&self.magnitude + &other.magnitude) };
        Number { value, magnitude, is_given: false }
    }

    fn times(&self, other: &Number) -> Number {
        Number {
            value: Rational::from(&self.value * &other.value),
            magnitude: Rational::from(&self.magnitude * &other.magnitude),
            is_given: false,
        }
    }

    fn negated(&self) -> Number {
        Number { value: Rational::from(-&self.value), ..self.clone() }
    }
}

/// The value of a formula at points, as a rational; `None` if a coordinate is not finite or a point is missing.
///
/// If the formula has weights, each point ends with its weight.
#[must_use]
pub fn formula_value(formula: &Formula, points: &[&[f64]]) -> Option<Rational> {
    evaluate(formula, points).map(|number| number.value)
}

/// The value at vertices of a scene.
///
/// # Panics
/// If a vertex is constructed or out of range, or the number of vertices is not the formula's.
pub(crate) fn value(scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Rational {
    verdict(scene, derived, vertices).determinant
}

/// The value and its magnitude at vertices of a scene; panics as [`value`].
pub(crate) fn verdict(scene: &Scene, derived: Derived, vertices: &[Vertex]) -> Verdict {
    let formula = derived.formula();
    assert_eq!(vertices.len(), formula.arity(), "{} has its number of vertices", formula.name());
    let number = derived.with_points(scene, vertices, |points| evaluate(formula, points));
    let number = number.expect("a scene's coordinates are finite, and formulas were checked");
    Verdict { determinant: number.value, permanent: number.magnitude }
}

fn evaluate(formula: &Formula, points: &[&[f64]]) -> Option<Number> {
    let given = |point: &&[f64]| point.iter().map(|&x| Rational::from_f64(x).map(Number::given)).collect();
    let points: Vec<Vec<Number>> = points.iter().map(given).collect::<Option<_>>()?;
    interpret(formula, points)
}
