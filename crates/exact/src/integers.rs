//! The coordinates of a scene as integers, for scenes whose differences are no doubles.
//!
//! Where differences are doubles, they become integers when a query needs
//! them. Where they are not, both coordinates would have to be converted, each
//! time; so it is done once, in units of the scene's lowest bit. A query then
//! subtracts, and looks how many bits it really has: most figures are shorter
//! than their scene.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Fixed, Plan};

use crate::integer::BITS;

/// A scene's coordinates, or nothing if they are not needed, or too long.
pub(crate) struct Integers<const D: usize> {
    points: Vec<[i128; D]>,
    /// Whether no difference needs more than a limb.
    is_short: bool,
}

/// The differences of a query.
pub(crate) struct Rows<const D: usize, const N: usize> {
    differences: [[i128; D]; N],
    is_short: bool,
}

impl<const D: usize> Integers<D> {
    pub fn new(plan: &Plan<D>, points: &[[f64; D]]) -> Integers<D> {
        let are_needed = !plan.has_exact_differences() && plan.bits() <= BITS[1] && plan.has_finite_differences();
        let point = |point: &[f64; D]| point.map(|x| plan.units(x));
        let points = if are_needed { points.iter().map(point).collect() } else { Vec::new() };
        Integers { points, is_short: plan.bits() <= BITS[0] }
    }

    /// The differences to the last of some points along some axes; none if the
    /// scene has no integers.
    #[inline(always)]
    pub fn rows<const E: usize, const N: usize>(&self, axes: [usize; E], points: [usize; N]) -> Option<Rows<E, N>> {
        let last = self.points.get(points[N - 1])?;
        let mut differences = [[0; E]; N];
        for row in 0..N - 1 {
            let point = &self.points[points[row]];
            for axis in 0..E {
                differences[row][axis] = point[axes[axis]].wrapping_sub(last[axes[axis]]);
            }
        }
        Some(Rows { differences, is_short: self.is_short })
    }
}

impl<const D: usize, const N: usize> Rows<D, N> {
    /// The rows in one limb, where that is known to be enough.
    #[inline(always)]
    pub fn short(&self) -> Option<[[Fixed<1>; D]; N]> {
        self.is_short.then(|| shifted(&self.differences, 0))
    }

    /// The rows in some larger unit, if one limb is enough.
    #[inline(always)]
    pub fn shortened(&self) -> Option<[[Fixed<1>; D]; N]> {
        let (mut bits, mut size) = (0, 0);
        for row in 0..N - 1 {
            for axis in 0..D {
                let x = self.differences[row][axis];
                bits |= x;
                // The bits of |x|, or of |x| - 1.
                size |= x ^ (x >> 127);
            }
        }
        // At most that many zeros below, and less than two to that in magnitude.
        let low = bits.trailing_zeros() & 127;
        let is_short = (128 - size.leading_zeros()).saturating_sub(low) < BITS[0].unsigned_abs();
        is_short.then(|| shifted(&self.differences, low))
    }

    /// The rows as they are.
    #[inline(always)]
    pub fn long(&self) -> [[Fixed<2>; D]; N] {
        let mut longer = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                longer[row][axis] = Fixed::from(self.differences[row][axis]);
            }
        }
        longer
    }
}

/// The low limbs of the rows, shifted to the right.
#[inline(always)]
fn shifted<const D: usize, const N: usize>(rows: &[[i128; D]; N], by: u32) -> [[Fixed<1>; D]; N] {
    let mut shorter = [[Fixed::ZERO; D]; N];
    for row in 0..N - 1 {
        for axis in 0..D {
            #[allow(clippy::cast_possible_truncation)] // 62 bits
            let x = (rows[row][axis] >> by) as i64;
            shorter[row][axis] = Fixed::from(x);
        }
    }
    shorter
}
