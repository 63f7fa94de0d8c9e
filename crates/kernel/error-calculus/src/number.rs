//! The operations of numbers that generic code is written over.
//!
//! Three traits, by what rationals can follow: they are a [`Field`], and have
//! no square root. Nothing compares: a formula that branches is not one
//! quantity but several.

use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::{Integer, Rational};

/// Sums, differences and products.
pub trait Ring:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + Sized
{
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// The product with itself. The error calculus knows that it isn't negative.
    #[must_use]
    fn square(self) -> Self {
        self.clone() * self
    }
}

/// Quotients as well.
pub trait Field: Ring + Div<Output = Self> {
    /// One, without an error.
    #[must_use]
    fn one() -> Self;
}

/// Square roots as well.
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
