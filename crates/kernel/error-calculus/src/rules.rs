//! The columns a and b of rules A to H, as functions of numbers.
//!
//! An [`Error`] says that a computed value is off by at most aε + bε² of what it
//! is relative to, for every ε < 10⁻⁵. In each rule a is the sum of the
//! first-order terms; b is those of second order, and a 1 more that pays for all
//! the higher ones. That is enough while they are small: where b passes some
//! 10⁵ it is not. So b here is the larger of the paper's and of what is needed
//! at the largest ε: everywhere that the paper's is right it is the paper's, and
//! elsewhere it is right. All of it is exact, in rationals.
//!
//! Rules A and I change nothing, J and K start with [`Error::none`].
//!
//! # What is not as printed
//! B and D: the 1 stands outside the fraction, 1 + (c₁(a₁+b₁) + c₂(a₂+b₂))/(c₁+c₂).
//! The printed form is in [`as_printed`].
//!
//! # What is ours
//! * A product with a power of two rounds nothing ([`Quantity`](crate::Quantity)).
//! * A sum or difference that is known to be large enough is off by its own rounding,
//!   which is relative to it, and by what its operands bring ([`bounded_below`]).

use rug::Rational;

/// ε is less than this, section 2. All that is said holds up to it.
#[must_use]
pub fn largest_epsilon() -> Rational {
    Rational::from((1, 100_000))
}

/// The error aε + bε².
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Error {
    /// Of first order.
    pub a: Rational,
    /// Of second order.
    pub b: Rational,
}

impl Error {
    /// No error.
    #[must_use]
    pub fn none() -> Error {
        Error { a: Rational::new(), b: Rational::new() }
    }

    /// aε + bε².
    #[must_use]
    pub fn at(&self, epsilon: &Rational) -> Rational {
        (Rational::from(&self.b * epsilon) + &self.a) * epsilon
    }

    /// Whether nothing is lost.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.a == 0 && self.b == 0
    }
}

/// a, and b: the larger of the paper's and what keeps aε + bε² above the
/// `deviation` at the largest ε.
///
/// Right for a deviation that is a power series in ε with no negative
/// coefficient after the first order: then (deviation − aε)/ε² never decreases.
fn second_order(a: Rational, papers: Rational, deviation: &Rational) -> Error {
    let epsilon = largest_epsilon();
    let needed = (deviation - Rational::from(&a * &epsilon)) / epsilon.square();
    Error { a, b: papers.max(needed) }
}

/// The weighted mean of the errors, with weights that are magnitudes; plain
/// where both are zero, as there is nothing to be relative to.
fn mean(c1: &Rational, x1: &Rational, c2: &Rational, x2: &Rational) -> Rational {
    let sum = Rational::from(c1 + c2);
    if sum == 0 { Rational::from(x1.max(x2)) } else { (Rational::from(c1 * x1) + Rational::from(c2 * x2)) / sum }
}

/// 1 + x with one more rounding: (1 + x)(1 + ε) − 1.
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

/// What a sum or difference has from its operands, without its own rounding:
/// relative to c₁ + c₂.
#[must_use]
pub fn inherited(c1: &Rational, e1: &Error, c2: &Rational, e2: &Error) -> Error {
    Error { a: mean(c1, &e1.a, c2, &e2.a), b: mean(c1, &e1.b, c2, &e2.b) }
}

/// A sum or difference that is at least 1/`factor` of what its inherited error is
/// relative to, relative to itself.
///
/// Its own rounding is relative to it already. Only what is inherited grows by the
/// factor, so that a number near 1 is little worse than rounded.
#[must_use]
pub fn bounded_below(inherited: &Error, factor: &Rational) -> Error {
    let [a, b] = [&inherited.a, &inherited.b].map(|x| Rational::from(x * factor));
    let grown = Error { a, b };
    let b = Rational::from(&grown.a + &grown.b) + 1;
    second_order(Rational::from(&grown.a + 1), b, &rounded(grown.at(&largest_epsilon())))
}

/// Rule C: a sum of two that aren't negative, relative to itself.
#[must_use]
pub fn sum_of_same_sign(e1: &Error, e2: &Error) -> Error {
    let epsilon = largest_epsilon();
    let a = Rational::from((&e1.a).max(&e2.a)) + 1;
    let b = Rational::from(&e1.a + &e1.b).max(Rational::from(&e2.a + &e2.b)) + 1;
    second_order(a, b, &rounded(e1.at(&epsilon).max(e2.at(&epsilon))))
}

/// Whether a number is 2^k with a whole k, or minus that.
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

/// Rule G: a quotient, both relative to themselves; none where the divisor's
/// error may be all of it.
#[must_use]
pub fn quotient(e1: &Error, e2: &Error) -> Option<Error> {
    let epsilon = largest_epsilon();
    let smallest = 1 - e2.at(&epsilon);
    (smallest > 0).then(|| {
        let b = product_b(e1, e2) + Rational::from(e2.a.square_ref());
        second_order(product_a(e1, e2), b, &rounded((e1.at(&epsilon) + 1) / smallest - 1))
    })
}

/// Rule H: a square root, relative to itself; none where the operand's error may
/// be all of it.
///
/// Its b is 1 + b₁/2 + |a₁/2 − a₁²/8|: a value that is too large needs a₁/2 − a₁²/8
/// of the last, one that is too small a₁²/8 − a₁/2.
///
/// Above: √(1 + x) ≤ 1 + x/2 − x²/8 + x³/16. Below: 1 − √(1 − x) ≤ x/2 + x²/8 +
/// x³/(16(1 − x)), of which (1 − ε) is left.
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
        // terms of third order and more, without those that are negative
        let above = Rational::from(&half_b * &epsilon) + (&cube * Rational::from(&epsilon + 1)) / &square;
        let above = Rational::from(&half_b + &half_a) - &eighth + above;
        let below = Rational::from(&e.a * &e.b) * &epsilon / 4
            + Rational::from(e.b.square_ref()) * &square / 8
            + cube / left / &square;
        let below = half_b + eighth - half_a + below;
        Error { a, b: Rational::max(papers, above).max(below) }
    })
}

/// The column as the paper prints it, where that is not sound.
pub mod as_printed {
    use rug::Rational;

    use super::Error;

    /// Rules B and D: the 1 is in the fraction.
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
