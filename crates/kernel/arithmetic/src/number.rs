//! The numbers that the formulas of filters are written over.
//!
//! Filters compute with doubles. The same formulas run on other numbers: on symbols, from which proofs are generated,
//! and on tiny formats, whose every input can be tried. So code and proof share one definition.

use core::ops::{Add, Mul, Sub};

/// Numbers with the operations of filters.
///
/// An implementation for doubles is inlined, and costs nothing.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The number one.
    const ONE: Self;

    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self;
}

impl Number for f64 {
    const ONE: f64 = 1.0;

    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
}
