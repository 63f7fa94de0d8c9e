//! The exact value of a formula, from its syntax tree alone.
//!
//! [`interpret`] evaluates the tree as it is written. It shares no code with the programs, integers and dyadic numbers
//! that backends use.

use predicament_predicates::formula::{Formula, Ring, interpret};
use predicament_predicates::{Derived, Scene, Vertex};
use rug::{Integer, Rational};

use crate::Verdict;

/// A number, and its magnitude: the same expression with the absolute value of every product and difference.
///
/// Both are integers times one power of two, so that nothing is reduced before the end.
#[derive(Clone)]
struct Number {
    value: Integer,
    magnitude: Integer,
    exponent: i32,
    /// True for coordinates and constants: the magnitude of a sum of two of them is its absolute value.
    is_given: bool,
}

impl Number {
    /// A double; `None` if it is not finite.
    fn given(x: f64) -> Option<Number> {
        let (value, denominator) = Rational::from_f64(x)?.into_numer_denom();
        let exponent = 1 - i32::try_from(denominator.significant_bits()).expect("1,075 bits at most");
        Some(Number { magnitude: value.clone().abs(), value, exponent, is_given: true })
    }

    /// The value and the magnitude in units of 2^exponent.
    fn in_units(&self, exponent: i32) -> [Integer; 2] {
        let shift = self.exponent.abs_diff(exponent);
        [&self.value, &self.magnitude].map(|x| Integer::from(x << shift))
    }

    fn verdict(self) -> Verdict {
        let [determinant, permanent] = [self.value, self.magnitude].map(|x| Rational::from(x) << self.exponent);
        Verdict { determinant, permanent }
    }
}

impl Ring for Number {
    fn whole(number: f64) -> Number {
        Number::given(number).unwrap_or_else(|| Number::given(0.0).expect("zero is finite"))
    }

    fn plus(&self, other: &Number, minus: bool) -> Number {
        let exponent = self.exponent.min(other.exponent);
        let [[a, b], [c, d]] = [self, other].map(|number| number.in_units(exponent));
        let value = if minus { a - c } else { a + c };
        let both = self.is_given && other.is_given;
        let magnitude = if both { value.clone().abs() } else { b + d };
        Number { value, magnitude, exponent, is_given: false }
    }

    fn times(&self, other: &Number) -> Number {
        Number {
            value: Integer::from(&self.value * &other.value),
            magnitude: Integer::from(&self.magnitude * &other.magnitude),
            exponent: self.exponent + other.exponent,
            is_given: false,
        }
    }

    fn negated(&self) -> Number {
        Number { value: Integer::from(-&self.value), ..self.clone() }
    }
}

/// The value of a formula at points, as a rational; `None` if a coordinate is not finite or a point is missing.
///
/// If the formula has weights, each point ends with its weight.
#[must_use]
pub fn formula_value(formula: &Formula, points: &[&[f64]]) -> Option<Rational> {
    evaluate(formula, points).map(|number| number.verdict().determinant)
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
    number.expect("a scene's coordinates are finite, and formulas were checked").verdict()
}

fn evaluate(formula: &Formula, points: &[&[f64]]) -> Option<Number> {
    let given = |point: &&[f64]| point.iter().map(|&x| Number::given(x)).collect();
    let points: Vec<Vec<Number>> = points.iter().map(given).collect::<Option<_>>()?;
    interpret(formula, points)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Doubles of all magnitudes: sums and products, and sums of absolute values.
    #[test]
    fn numbers_of_any_units_are_those_of_rationals() {
        let numbers = [0.0, 1.0, -0.75, 1e300, f64::MIN_POSITIVE, -f64::from_bits(3), 0.1];
        for a in numbers {
            for b in numbers {
                let [x, y] = [a, b].map(crate::rational);
                let [p, q] = [a, b].map(|number| Number::given(number).expect("finite"));
                let (product, sum) = (Rational::from(&x * &y), Rational::from(&x + &y));
                let found = p.times(&q).plus(&p, true).verdict();
                assert_eq!(found.determinant, Rational::from(&product - &x), "{a} {b}");
                assert_eq!(found.permanent, product.abs() + Rational::from(x.abs_ref()), "{a} {b}");
                let found = p.negated().plus(&q.negated(), false).verdict();
                assert_eq!((found.determinant, found.permanent), (-sum.clone(), sum.abs()), "{a} {b}");
            }
        }
    }
}
