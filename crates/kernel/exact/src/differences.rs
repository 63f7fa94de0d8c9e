//! Differences of integers to the last point, for determinants of a fixed size.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Fixed, units};

use crate::determinant::BITS;

/// Differences of a query in two limbs.
pub(crate) struct Rows<const D: usize, const N: usize>([[i128; D]; N]);

impl<const D: usize, const N: usize> Rows<D, N> {
    /// The differences to the last of some points whose plan allows two limbs.
    #[inline(always)]
    pub fn new(points: &[[f64; D]; N], lowest: i32) -> Rows<D, N> {
        let mut rows = [[0; D]; N];
        for axis in 0..D {
            let last = units(points[N - 1][axis], lowest);
            for row in 0..N - 1 {
                rows[row][axis] = units(points[row][axis], lowest).wrapping_sub(last);
            }
        }
        Rows(rows)
    }

    /// The differences to the last of some points of integers.
    #[inline(always)]
    pub fn of_integers(points: &[[i64; D]; N]) -> Rows<D, N> {
        let mut rows = [[0; D]; N];
        for axis in 0..D {
            for row in 0..N - 1 {
                rows[row][axis] = i128::from(points[row][axis]) - i128::from(points[N - 1][axis]);
            }
        }
        Rows(rows)
    }

    /// The rows in some larger unit and their bit length, if one limb is enough.
    #[inline(always)]
    pub fn shortened(&self) -> Option<([[Fixed<1>; D]; N], i32)> {
        let (mut bits, mut size) = (0, 0);
        for row in 0..N - 1 {
            for axis in 0..D {
                let x = self.0[row][axis];
                bits |= x;
                // The bits of |x|, or of |x| - 1.
                size |= x ^ (x >> 127);
            }
        }
        // At most that many trailing zeros, and a magnitude of at most two to that power.
        let low = bits.trailing_zeros() & 127;
        let bits = (129 - size.leading_zeros()).saturating_sub(low).cast_signed();
        (bits <= BITS[0]).then(|| (self.shifted(low), bits))
    }

    /// The rows with two limbs.
    #[inline(always)]
    pub fn whole(&self) -> [[Fixed<2>; D]; N] {
        let mut rows = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                rows[row][axis] = Fixed::from(self.0[row][axis]);
            }
        }
        rows
    }

    /// The low limbs of the rows, shifted to the right.
    #[inline(always)]
    fn shifted(&self, by: u32) -> [[Fixed<1>; D]; N] {
        let mut shorter = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                #[allow(clippy::cast_possible_truncation)] // 62 bits
                let x = (self.0[row][axis] >> by) as i64;
                shorter[row][axis] = Fixed::from(x);
            }
        }
        shorter
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_shortened_by_what_all_have_below() {
        let of = |x: f64, y: f64| Rows::new(&[[x, y], [0.0, 0.0]], 0);
        let one = |x: i64| Fixed::<1>::from(x);
        let (large, long) = (2f64.powi(70), 2f64.powi(70) + 2f64.powi(20));
        let (rows, bits) = of(large, -3.0 * large).shortened().expect("two bits and a sign");
        assert_eq!((rows[0], bits), ([one(1), one(-3)], 3));
        let (rows, bits) = of(long, -2f64.powi(21)).shortened().expect("51 bits");
        assert_eq!((rows[0], bits), ([one((1 << 50) + 1), one(-2)], 52));
        assert!(of(large, 1.0).shortened().is_none(), "71 bits");
        let most = 2f64.powi(BITS[0] - 1) - 2f64.powi(BITS[0] - 54);
        let shift = BITS[0] - 54;
        let (rows, bits) = of(most, 2f64.powi(shift)).shortened().expect("as many as fit");
        assert_eq!((rows[0], bits), ([one((1 << 53) - 1), one(1)], 54));
        let whole = of(large, -1.0).whole()[0];
        assert_eq!(whole.map(|x| (x.limbs()[0], x.limbs()[1])), [(0, 64), (u64::MAX, u64::MAX)]);
        assert_eq!(of(0.0, 0.0).shortened().map(|(rows, _)| rows[0]), Some([one(0); 2]));
    }
}
