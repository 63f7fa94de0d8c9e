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

use predicament_arithmetic::{Fixed, Plan};
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
}
