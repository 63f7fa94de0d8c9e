//! The number traits that generic code is written over.
//!
//! There are three traits because rationals are a [`Field`] without square roots. The traits have no comparison: a
//! formula that branches is not one quantity but several.

use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::{Integer, Rational};

/// Numbers with sums, differences and products.
pub trait Ring:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + Sized
{
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// The product of the number with itself, which the error calculus knows to be nonnegative.
    #[must_use]
    fn square(self) -> Self {
        self.clone() * self
    }
}

/// Ring numbers with quotients.
pub trait Field: Ring + Div<Output = Self> {
    /// The number one, without an error.
    #[must_use]
    fn one() -> Self;
}

/// Field numbers with square roots.
pub trait Root: Field {
    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;
}

macro_rules! float {
    ($float:ty) => {
        impl Ring for $float {
            #[inline]
            fn abs(self) -> Self {
                <$float>::abs(self)
            }
        }

        impl Field for $float {
            #[inline]
            fn one() -> Self {
                1.0
            }
        }

        impl Root for $float {
            #[inline]
            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }
        }
    };
}

float!(f32);
float!(f64);

impl Ring for Integer {
    fn abs(self) -> Self {
        Integer::abs(self)
    }
}

impl Ring for Rational {
    fn abs(self) -> Self {
        Rational::abs(self)
    }
}

impl Field for Rational {
    fn one() -> Self {
        Rational::from(1)
    }
}
