//! Rational numbers, and intervals of them for irrational roots.

use std::ops::{Add, Mul, Sub};

use rug::{Integer, Rational};

/// The number of binary digits of a root after the point.
const DIGITS: u32 = 192;

/// An interval with rational ends that contains a number.
///
/// Only [`Enclosure::sqrt`] rounds, and it rounds outward. A decision about the whole interval holds for the number in
/// it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Enclosure {
    /// A lower bound of the number.
    pub lower: Rational,
    /// An upper bound of the number.
    pub upper: Rational,
}

impl Enclosure {
    /// The enclosure of a rational number, without width.
    #[must_use]
    pub fn exact(value: Rational) -> Enclosure {
        Enclosure { lower: value.clone(), upper: value }
    }

    /// The square root: exact if it is rational, else enclosed to 2⁻¹⁹².
    ///
    /// # Panics
    /// If the number may be negative.
    #[must_use]
    pub fn sqrt(&self) -> Enclosure {
        Enclosure { lower: root(&self.lower).0, upper: root(&self.upper).1 }
    }

    /// The number to a power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Enclosure {
        (0..exponent).fold(Enclosure::exact(1.into()), |power, _| power * self.clone())
    }

    /// One over the number.
    ///
    /// # Panics
    /// If the number may be zero or negative.
    #[must_use]
    pub fn reciprocal(&self) -> Enclosure {
        assert!(self.lower > 0, "no reciprocal of what may not be positive");
        Enclosure { lower: self.upper.clone().recip(), upper: self.lower.clone().recip() }
    }

    /// The smaller of two numbers.
    #[must_use]
    pub fn min(self, other: Enclosure) -> Enclosure {
        Enclosure { lower: self.lower.min(other.lower), upper: self.upper.min(other.upper) }
    }
}

impl From<Rational> for Enclosure {
    fn from(value: Rational) -> Self {
        Enclosure::exact(value)
    }
}

impl Add for Enclosure {
    type Output = Enclosure;

    fn add(self, other: Enclosure) -> Enclosure {
        Enclosure { lower: self.lower + other.lower, upper: self.upper + other.upper }
    }
}

impl Sub for Enclosure {
    type Output = Enclosure;

    fn sub(self, other: Enclosure) -> Enclosure {
        Enclosure { lower: self.lower - other.upper, upper: self.upper - other.lower }
    }
}

impl Mul for Enclosure {
    type Output = Enclosure;

    fn mul(self, other: Enclosure) -> Enclosure {
        let ends = [&self.lower, &self.upper];
        let products: Vec<Rational> =
            ends.iter().flat_map(|&x| [&other.lower, &other.upper].map(|y| Rational::from(x * y))).collect();
        let lower = products.iter().min().expect("four").clone();
        let upper = products.into_iter().max().expect("four");
        Enclosure { lower, upper }
    }
}

/// Two rationals with √x between them, equal if √x is rational.
fn root(x: &Rational) -> (Rational, Rational) {
    assert!(x.cmp0() != std::cmp::Ordering::Less, "no real root of {x}");
    let (numerator, denominator) = (x.numer(), x.denom());
    if numerator.is_perfect_square() && denominator.is_perfect_square() {
        let root = Rational::from((numerator.clone().sqrt(), denominator.clone().sqrt()));
        return (root.clone(), root);
    }
    // √(n/d) = √(n d 4^k)/(d 2^k)
    let scale = Integer::from(denominator << DIGITS);
    let below = (Integer::from(numerator * denominator) << (2 * DIGITS)).sqrt();
    let above = Integer::from(&below + 1);
    (Rational::from((below, scale.clone())), Rational::from((above, scale)))
}

/// A rational upper bound of √x, equal to √x if it is rational.
pub(crate) fn root_up(x: &Rational) -> Rational {
    root(x).1
}

/// A rational lower bound of √x, equal to √x if it is rational.
#[cfg(test)]
fn root_down(x: &Rational) -> Rational {
    root(x).0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_exact_or_enclosed() {
        for (n, d) in [(2, 1), (1, 3), (910, 7), (1, 100_000)] {
            let x = Rational::from((n, d));
            let (low, high) = (root_down(&x), root_up(&x));
            assert!(Rational::from(low.square_ref()) < x && x < Rational::from(high.square_ref()));
            assert!(Rational::from(&high - &low) <= Rational::from((1, Integer::from(1) << DIGITS)));
        }
        let x = Rational::from((9, 4));
        assert_eq!((root_down(&x), root_up(&x)), ((3, 2).into(), (3, 2).into()));
        assert_eq!(root_up(&Rational::new()), 0);
    }

    #[test]
    fn products_take_the_outermost_ends() {
        let interval = |lower: i32, upper: i32| Enclosure { lower: lower.into(), upper: upper.into() };
        assert_eq!(interval(-2, 3) * interval(-5, 1), interval(-15, 10));
        assert_eq!(interval(-2, 3) - interval(-5, 1), interval(-3, 8));
        assert_eq!(interval(-2, 3).min(interval(-5, 1)), interval(-5, 1));
        let reciprocal = Enclosure { lower: (1, 4).into(), upper: (1, 2).into() };
        assert_eq!(interval(2, 4).reciprocal(), reciprocal);
    }
}
