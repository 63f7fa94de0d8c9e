//! The size of the determinants of a proof.
//!
//! Let coordinates be at most M in magnitude, plus an infinitesimal: M counts both. Weights of input vertices are at
//! most one. The size of a series is the sum of its coefficients' magnitudes; the size of a product is at most the
//! product of the sizes. An exterior product of k factors has sums of k! products, so by the degrees of its entries:
//!
//! | | coordinates | weight | how |
//! |---|---|---|---|
//! | an input vertex | M | 1 | |
//! | a share p/q of a segment | 2·2^53·M | 2^53 | \|p\|, \|q − p\| and q are at most 2^53 |
//! | two lines | 8·M³ | 8·M² | a line has entries of 2·M or 2·M²; 2! products of two |
//! | a line and a plane | 36·M⁴ | 36·M³ | three products of an entry of the line, 2·M², and of the plane, 3!·M³ |
//! | three planes | 1296·M⁷ | 1296·M⁶ | 3! products of three entries of planes |
//!
//! A determinant of n rows has n! products. A free vertex stands for unit vectors, for itself with zeros, and for
//! points of small whole numbers: M counts these too.

use predicament_predicates::Construction;

use super::Moving;
use crate::constructed::place::Place;

impl Moving<'_> {
    /// The number of bits that hold every determinant of the proof; `None` if it is too large to count.
    pub(in crate::constructed) fn bits(&self, coordinates: &[(i64, u32)]) -> Option<u32> {
        // A magnitude below 2^b is below 2^b with an infinitesimal too, or it is 2^b − 1, and the size is 2^b.
        let length = |&(m, k): &(i64, u32)| if m == 0 { 0 } else { u64::BITS - m.unsigned_abs().leading_zeros() + k };
        // No position has coordinates above the number of occurrences, which is below 2^4.
        let least = if self.active > 0 { 4 } else { 0 };
        let bits = coordinates.iter().map(length).max().unwrap_or(0).max(least);
        let (mut factor, mut degree) = (24_u64, 0);
        for place in &self.matrix.places {
            let (of_place, of_weight) = match place {
                Place::Input(_) => (1, 0),
                Place::Meet(Construction::Ratio { .. }) => (1 << 54, 0),
                Place::Meet(Construction::Ssi(_)) => (8, 2),
                Place::Meet(Construction::Lpi { .. }) => (36, 3),
                Place::Meet(Construction::Tpi(_)) => (1296, 6),
            };
            (factor, degree) = (factor.saturating_mul(of_place), degree + of_weight);
        }
        // Each product has one entry of each column.
        degree += self.matrix.columns.iter().fold(0, |sum, &column| sum + u32::from(column < self.dimension));
        bits.checked_mul(degree)?.checked_add(u64::BITS - factor.leading_zeros()).filter(|_| factor < u64::MAX)
    }
}
