//! Exact values of the determinants, in integers of GMP: the truth for tests and benches.
//!
//! The coordinates of a query are integers times one power of two. The determinant is computed in those integers, and
//! scaled back only if its value is needed. No exponent is too wide: doubles span 2100 bits.
//!
//! Coordinates must be finite, as those of a scene are; the functions panic otherwise.

#![allow(dead_code)] // each test uses some of the functions

use std::cmp::Ordering;

use predicament_arithmetic::Scaled;
use predicament_predicates::Sign;
use rug::{Integer, Rational};

/// A determinant's exact value: an integer over a power of two.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Value {
    integer: Integer,
    exponent: i32,
}

impl Value {
    /// The sign of the value.
    #[must_use]
    pub fn sign(&self) -> Sign {
        Sign::from(self.integer.cmp0())
    }

    /// The value as a rational.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        Rational::from(&self.integer) << self.exponent
    }

    /// The binary logarithm of the magnitude, within 2^-38; negative infinity for zero.
    ///
    /// It is for plots: it is finite for every nonzero determinant, also if the determinant is not a double.
    #[must_use]
    pub fn log2(&self) -> f64 {
        let (mantissa, exponent) = self.integer.to_f64_exp();
        match self.integer.cmp0() {
            Ordering::Equal => f64::NEG_INFINITY,
            _ => mantissa.abs().log2() + (f64::from(exponent) + f64::from(self.exponent)),
        }
    }
}

/// The exact value of (a − c) × (b − c).
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Value {
    let ([a, b, c], exponent) = scale([a, b, c]);
    value(cross(&minus(&a, &c), &minus(&b, &c)), 2, exponent)
}

/// The exact value of det(a − d, b − d, c − d).
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Value {
    let ([a, b, c, d], exponent) = scale([a, b, c, d]);
    value(triple(&minus(&a, &d), &minus(&b, &d), &minus(&c, &d)), 3, exponent)
}

/// The exact value of the 3 × 3 determinant of a − d, b − d, c − d, each with its squared length.
#[must_use]
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Value {
    let ([a, b, c, d], exponent) = scale([a, b, c, d]);
    let lifted = |p: &[Integer; 2]| {
        let [x, y] = minus(p, &d);
        let lift = square(&x) + square(&y);
        [x, y, lift]
    };
    value(triple(&lifted(&a), &lifted(&b), &lifted(&c)), 4, exponent)
}

/// The exact value of the 4 × 4 determinant of a − e, b − e, c − e, d − e, each with its squared length.
#[must_use]
pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Value {
    let ([a, b, c, d, e], exponent) = scale([a, b, c, d, e]);
    let [a, b, c, d] = [a, b, c, d].map(|p| minus(&p, &e));
    let term = |p: &[Integer; 3], minor: Integer| (square(&p[0]) + square(&p[1]) + square(&p[2])) * minor;
    let even = term(&d, triple(&a, &b, &c)) + term(&b, triple(&a, &c, &d));
    let odd = term(&c, triple(&a, &b, &d)) + term(&a, triple(&b, &c, &d));
    value(even - odd, 5, exponent)
}

fn value(integer: Integer, degree: i32, exponent: i32) -> Value {
    Value { integer, exponent: degree * exponent }
}

fn scale<const D: usize, const N: usize>(points: [[f64; D]; N]) -> ([[Integer; D]; N], i32) {
    let scaled = Scaled::new(points).expect("the coordinates of a scene are finite");
    (scaled.integers, scaled.exponent)
}

fn minus<const D: usize>(p: &[Integer; D], q: &[Integer; D]) -> [Integer; D] {
    std::array::from_fn(|i| Integer::from(&p[i] - &q[i]))
}

fn square(x: &Integer) -> Integer {
    Integer::from(x.square_ref())
}

fn cross<const D: usize>(p: &[Integer; D], q: &[Integer; D]) -> Integer {
    Integer::from(&p[0] * &q[1]) - Integer::from(&p[1] * &q[0])
}

fn triple(p: &[Integer; 3], q: &[Integer; 3], r: &[Integer; 3]) -> Integer {
    &p[2] * cross(q, r) + &q[2] * cross(r, p) + &r[2] * cross(p, q)
}
