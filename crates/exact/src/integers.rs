//! The coordinates of a scene as integers.
//!
//! Coordinates become integers once, when the scene is prepared, in units of
//! its lowest bit: a query then only subtracts. Numbers are kept modulo a
//! power of two, so that the points may be as far from the origin as they
//! like; only their differences have to fit.
//!
//! Where differences fit in one limb, a coordinate takes as much room as the
//! double that it comes from. Where they need two, a query looks how many bits
//! it really has: most figures are shorter than their scene.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Fixed, Plan};
use predicament_predicates::Vertex;

use crate::integer::BITS;

/// A scene's coordinates: one of the two lists, or none of them if integers
/// are not needed or don't do.
pub(crate) struct Integers<const D: usize> {
    /// Differences have one limb.
    short: Vec<[i64; D]>,
    /// Differences have two limbs.
    long: Vec<[i128; D]>,
}

/// The differences of a query, in two limbs.
pub(crate) struct Rows<const D: usize, const N: usize>([[i128; D]; N]);

impl<const D: usize> Integers<D> {
    /// None: for scenes that don't need them.
    pub const NONE: Integers<D> = Integers { short: Vec::new(), long: Vec::new() };

    pub fn new(plan: &Plan<D>, points: &[[f64; D]]) -> Integers<D> {
        let [one, two] = BITS;
        if !plan.has_finite_differences() || plan.bits() > two {
            Integers::NONE
        } else if plan.bits() <= one {
            Integers { short: plan.low_units(points), long: Vec::new() }
        } else {
            let point = |point: &[f64; D]| point.map(|x| plan.units(x));
            Integers { short: Vec::new(), long: points.iter().map(point).collect() }
        }
    }

    /// The differences to the last of some vertices along some axes, in one
    /// limb; none if the scene has no such integers, or no such vertex.
    #[inline(always)]
    pub fn short<const E: usize, const N: usize>(
        &self,
        axes: [usize; E],
        vertices: [Vertex; N],
    ) -> Option<[[Fixed<1>; E]; N]> {
        let last = self.short.get(vertices[N - 1].index())?;
        let mut rows = [[Fixed::ZERO; E]; N];
        for row in 0..N - 1 {
            let point = self.short.get(vertices[row].index())?;
            for axis in 0..E {
                rows[row][axis] = Fixed::from(point[axes[axis]].wrapping_sub(last[axes[axis]]));
            }
        }
        Some(rows)
    }

    /// The same in two limbs, for scenes that need them.
    #[inline(always)]
    pub fn long<const E: usize, const N: usize>(&self, axes: [usize; E], vertices: [Vertex; N]) -> Option<Rows<E, N>> {
        let last = self.long.get(vertices[N - 1].index())?;
        let mut differences = [[0; E]; N];
        for row in 0..N - 1 {
            let point = self.long.get(vertices[row].index())?;
            for axis in 0..E {
                differences[row][axis] = point[axes[axis]].wrapping_sub(last[axes[axis]]);
            }
        }
        Some(Rows(differences))
    }
}

impl<const D: usize, const N: usize> Rows<D, N> {
    /// The rows in some larger unit and the bits that they have, if one limb is enough.
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
        // At most that many zeros below, and less than two to that in magnitude.
        let low = bits.trailing_zeros() & 127;
        // (One more, since what is negative may be two to that, exactly.)
        let bits = (129 - size.leading_zeros()).saturating_sub(low).cast_signed();
        (bits <= BITS[0]).then(|| (self.shifted(low), bits))
    }

    /// The rows as they are.
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
