//! The columns a and b of rules A to H, as functions of numbers.
//!
//! An [`Error`] says that a computed value is off by at most aε + bε² of a reference magnitude, for every ε < 10⁻⁵. In
//! each rule a is the sum of the first-order terms. b is the sum of the second-order terms, plus 1 to cover all higher
//! orders. That 1 suffices while the terms are small, but not if b exceeds about 10⁵. So b here is the larger of the
//! paper's b and the b needed at the largest ε: it equals the paper's b everywhere that the paper's is right, and
//! elsewhere it is right. Everything is exact, in rationals.
//!
//! Rules A and I change nothing, J and K start with [`Error::none`].
//!
//! # What is not as printed
//! B and D: the 1 stands outside the fraction, 1 + (c₁(a₁+b₁) + c₂(a₂+b₂))/(c₁+c₂). The printed form is in
//! [`as_printed`].
//!
//! # What is ours
//! * A product with a power of two has no rounding error ([`Quantity`](crate::Quantity)).
//! * A sum or difference with a known lower bound is off by its own rounding error, which is relative to it, and by the
//!   errors of its operands ([`bounded_below`]).

use rug::Rational;

/// The upper limit of ε, section 2; all statements hold up to it.
#[must_use]
pub fn largest_epsilon() -> Rational {
    Rational::from((1, 100_000))
}

/// The error aε + bε².
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Error {
    /// The first-order coefficient.
    pub a: Rational,
    /// The second-order coefficient.
    pub b: Rational,
}

impl Error {
    /// No error.
    #[must_use]
    pub fn none() -> Error {
        Error { a: Rational::new(), b: Rational::new() }
    }

    /// The value aε + bε².
    #[must_use]
    pub fn at(&self, epsilon: &Rational) -> Rational {
        (Rational::from(&self.b * epsilon) + &self.a) * epsilon
    }

    /// Returns true if the error is zero.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.a == 0 && self.b == 0
    }
}

/// An error with this a, and with the larger of the paper's b and the b needed at the largest ε.
///
/// The needed b keeps aε + bε² above the `deviation` at the largest ε. This is right for a deviation that is a power
/// series in ε with no negative coefficient after the first order: then (deviation − aε)/ε² never decreases.
fn second_order(a: Rational, papers: Rational, deviation: &Rational) -> Error {
    let epsilon = largest_epsilon();
    let needed = (deviation - Rational::from(&a * &epsilon)) / epsilon.square();
    Error { a, b: papers.max(needed) }
}

/// The mean of the errors, weighted by magnitudes.
///
/// It is unweighted if both magnitudes are zero, as there is nothing to be relative to.
fn mean(c1: &Rational, x1: &Rational, c2: &Rational, x2: &Rational) -> Rational {
    let sum = Rational::from(c1 + c2);
    if sum == 0 { Rational::from(x1.max(x2)) } else { (Rational::from(c1 * x1) + Rational::from(c2 * x2)) / sum }
}

/// The error of 1 + x with one more rounding: (1 + x)(1 + ε) − 1.
fn rounded(x: Rational) -> Rational {
    let epsilon = largest_epsilon();
    Rational::from(&x * &epsilon) + x + epsilon
}

/// Rules B and D: a sum or difference of values up to c₁ and c₂, relative to c₁ + c₂.
#[must_use]
pub fn sum(c1: &Rational, e1: &Error, c2: &Rational, e2: &Error) -> Error {
    let epsilon = largest_epsilon();
    let inherited = inherited(c1, e1, c2, e2);
    let a = Rational::from(&inherited.a + 1);
    let b = Rational::from(&inherited.a + &inherited.b) + 1;
    second_order(a, b, &rounded(inherited.at(&epsilon)))
}

/// The error that a sum or difference inherits from its operands, without its own rounding: relative to c₁ + c₂.
#[must_use]
pub fn inherited(c1: &Rational, e1: &Error, c2: &Rational, e2: &Error) -> Error {
    Error { a: mean(c1, &e1.a, c2, &e2.a), b: mean(c1, &e1.b, c2, &e2.b) }
}

/// The error, relative to itself, of a sum or difference with a lower bound.
///
/// The bound is 1/`factor` of the magnitude that the inherited error is relative to. Its own rounding error is relative
/// to it already. Only the inherited error grows by the factor, so a number near 1 is little worse than rounded.
#[must_use]
pub fn bounded_below(inherited: &Error, factor: &Rational) -> Error {
    let [a, b] = [&inherited.a, &inherited.b].map(|x| Rational::from(x * factor));
    let grown = Error { a, b };
    let b = Rational::from(&grown.a + &grown.b) + 1;
    second_order(Rational::from(&grown.a + 1), b, &rounded(grown.at(&largest_epsilon())))
}

/// Rule C: a sum of two nonnegative values, relative to itself.
#[must_use]
pub fn sum_of_same_sign(e1: &Error, e2: &Error) -> Error {
    let epsilon = largest_epsilon();
    let a = Rational::from((&e1.a).max(&e2.a)) + 1;
    let b = Rational::from(&e1.a + &e1.b).max(Rational::from(&e2.a + &e2.b)) + 1;
    second_order(a, b, &rounded(e1.at(&epsilon).max(e2.at(&epsilon))))
}

/// Returns true for ±2^k with an integer k.
#[must_use]
pub fn is_power_of_two(x: &Rational) -> bool {
    x.numer().clone().abs().is_power_of_two() && x.denom().is_power_of_two()
}

/// Rule E: a difference of two exact values, relative to itself.
#[must_use]
pub fn exact_difference() -> Error {
    Error { a: 1.into(), b: 0.into() }
}

/// Rule F: a product.
#[must_use]
pub fn product(e1: &Error, e2: &Error) -> Error {
    let epsilon = largest_epsilon();
    let [f1, f2] = [e1, e2].map(|e| e.at(&epsilon) + 1);
    second_order(product_a(e1, e2), product_b(e1, e2), &rounded(f1 * f2 - 1))
}

fn product_a(e1: &Error, e2: &Error) -> Rational {
    Rational::from(&e1.a + &e2.a) + 1
}

fn product_b(e1: &Error, e2: &Error) -> Rational {
    Rational::from(&e1.a + 1) * Rational::from(&e2.a + 1) + &e1.b + &e2.b
}

/// Rule G: a quotient, relative to itself, of relative errors; `None` if the divisor's relative error may reach 1.
#[must_use]
pub fn quotient(e1: &Error, e2: &Error) -> Option<Error> {
    let epsilon = largest_epsilon();
    let smallest = 1 - e2.at(&epsilon);
    (smallest > 0).then(|| {
        let b = product_b(e1, e2) + Rational::from(e2.a.square_ref());
        second_order(product_a(e1, e2), b, &rounded((e1.at(&epsilon) + 1) / smallest - 1))
    })
}

/// Rule H: a square root, relative to itself; `None` if the operand's relative error may reach 1.
///
/// Its b is 1 + b₁/2 + |a₁/2 − a₁²/8|: a value that is too large needs a₁/2 − a₁²/8 of the last term, a value that is
/// too small needs a₁²/8 − a₁/2.
///
/// Above: √(1 + x) ≤ 1 + x/2 − x²/8 + x³/16. Below: 1 − √(1 − x) ≤ x/2 + x²/8 + x³/(16(1 − x)), of which (1 − ε) is
/// left.
#[must_use]
pub fn root(e: &Error) -> Option<Error> {
    let epsilon = largest_epsilon();
    let x = e.at(&epsilon);
    let left = Rational::from(1 - &x);
    (left > 0).then(|| {
        let a = Rational::from(&e.a / 2) + 1;
        let cube = Rational::from(x.square_ref()) * &x / 16;
        let (half_b, half_a) = (Rational::from(&e.b / 2), Rational::from(&e.a / 2));
        let eighth = Rational::from(e.a.square_ref()) / 8;
        let bars = Rational::from(&half_a - &eighth).abs();
        let papers = Rational::from(&half_b + &bars) + 1;
        let square = Rational::from(epsilon.square_ref());
        // terms of third order and higher, without the negative ones
        let above = Rational::from(&half_b * &epsilon) + (&cube * Rational::from(&epsilon + 1)) / &square;
        let above = Rational::from(&half_b + &half_a) - &eighth + above;
        let below = Rational::from(&e.a * &e.b) * &epsilon / 4
            + Rational::from(e.b.square_ref()) * &square / 8
            + cube / left / &square;
        let below = half_b + eighth - half_a + below;
        Error { a, b: Rational::max(papers, above).max(below) }
    })
}

/// The columns as the paper prints them, where the printed form is not sound.
pub mod as_printed {
    use rug::Rational;

    use super::Error;

    /// Rules B and D as printed: the 1 is inside the fraction.
    #[must_use]
    pub fn sum(c1: &Rational, e1: &Error, c2: &Rational, e2: &Error) -> Error {
        let weighted = |x1: Rational, x2: Rational| (c1 * x1) + (c2 * x2);
        let c = Rational::from(c1 + c2);
        Error {
            a: weighted(e1.a.clone(), e2.a.clone()) / &c + 1,
            b: (weighted(Rational::from(&e1.a + &e1.b), Rational::from(&e2.a + &e2.b)) + 1) / &c,
        }
    }
}
