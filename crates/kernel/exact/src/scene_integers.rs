//! The coordinates of a scene as integers.
//!
//! If differences fit in one limb, coordinates scaled by one power of two for the scene usually fit as well: a query
//! converts the points that its filters have just read, and needs no other memory. If coordinates are too far from the
//! origin for that, but their differences are not, they are stored as integers modulo 2^64, 8 bytes each.
//!
//! Scenes that need more bits store none: each query tries a [unit of its own](crate::common_unit).

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use alloc::vec::Vec;

use predicament_arithmetic::{Fixed, Plan, units};
use predicament_predicates::Vertex;

use crate::determinant::BITS;
use crate::truncate::to_integer;

/// The stored integer coordinates of a scene, if any.
pub(crate) enum Integers<const D: usize> {
    /// No integers are stored.
    ///
    /// Doubles suffice for all predicates, points are scaled per query, or differences have too many bits.
    None,
    /// Values in units of the scene, modulo 2^64.
    Units(Vec<[i64; D]>),
}

/// The differences to the last point, as integers.
///
/// All coordinates times `scale` must be integers less than 2^63 in magnitude.
#[inline(always)]
pub(crate) fn scaled<const D: usize, const N: usize>(points: &[[f64; D]; N], scale: f64) -> [[Fixed<1>; D]; N] {
    let mut rows = [[Fixed::ZERO; D]; N];
    for axis in 0..D {
        let last = to_integer(points[N - 1][axis] * scale);
        for row in 0..N - 1 {
            rows[row][axis] = Fixed::from(to_integer(points[row][axis] * scale).wrapping_sub(last));
        }
    }
    rows
}

impl<const D: usize> Integers<D> {
    /// The integers of coordinates that are too far from the origin to be scaled, while their differences are not.
    pub fn new(plan: &Plan<D>, points: &[[f64; D]]) -> Integers<D> {
        let is_far = plan.has_finite_differences() && plan.bits() <= BITS[0] && plan.scale().is_none();
        if is_far { Integers::Units(plan.low_units(points)) } else { Integers::None }
    }

    /// The differences to the last of some vertices along some axes, in units of the scene.
    ///
    /// `None` if these integers are not stored.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline(always)]
    pub fn of_scene<const E: usize, const N: usize>(
        &self,
        axes: [usize; E],
        vertices: [Vertex; N],
    ) -> Option<[[Fixed<1>; E]; N]> {
        let Integers::Units(units) = self else { return None };
        let last = &units[vertices[N - 1].index()];
        let mut rows = [[Fixed::ZERO; E]; N];
        for row in 0..N - 1 {
            let point = &units[vertices[row].index()];
            for axis in 0..E {
                rows[row][axis] = Fixed::from(point[axes[axis]].wrapping_sub(last[axes[axis]]));
            }
        }
        Some(rows)
    }
}

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
    fn what_is_far_from_the_origin_is_kept_modulo_a_limb() {
        // Along x about 2^70, in steps of 2^18; along y integers, whose unit is that of the scene.
        let x = |step: f64| 2f64.powi(70) + 2f64.powi(18) * step;
        let points = [[x(0.0), -3.0], [x(5.0), 0.0], [x(-2.0), 8.0], [x(9.0), 1.0]];
        let kept = Integers::new(&Plan::of(&points), &points);
        let rows = kept.of_scene([1, 0], [2, 0, 3].map(Vertex::input)).expect("kept");
        let whole = [[7, -11 << 18], [-4, -9 << 18], [0, 0]];
        assert_eq!(rows, whole.map(|row| row.map(|x: i64| Fixed::from(x))));
        // Near the origin they are scaled per query, and with long differences they have no unit.
        for points in
            [[[1.0, 2.0], [3.0, 5.0]], [[1.0, 2f64.powi(70)], [3.0, 5.0]], [[1.0, f64::MAX], [1.0, -f64::MAX]]]
        {
            let kept = Integers::new(&Plan::of(&points), &points);
            assert!(kept.of_scene([0], [0, 1].map(Vertex::input)).is_none(), "{points:?}");
        }
    }

    #[test]
    fn scaled_differences_are_those_of_the_coordinates() {
        let points = [[0.75, -2.0, 1.0], [-3.5, 0.25, 0.0], [1.0, 1.0, 1.0]];
        let rows = scaled(&points, 4.0);
        let expected = [[-1, -12, 0], [-18, -3, -4], [0, 0, 0]];
        assert_eq!(rows, expected.map(|row| row.map(|x: i64| Fixed::from(x))));
    }

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
