//! Rays that miss a triangle by far, in floating point.
//!
//! A line misses a triangle if it passes two sides of it in opposite directions. For corners a and b relative to a
//! point of the line, the direction's product with a × b has the sign of that passing.
//!
//! # Bounds
//! Let M be the largest magnitude of a coordinate of the corners and of the point, D the largest computed difference of
//! these, and L the largest component of the direction, which is exact. The point is rounded by 2^-52 of itself at
//! most, so a difference is off by e = 2^-50·M. Each passing has six products of three: each is off by L·(2De + e²),
//! and goes through five roundings at most, 2^-53·L·(D + e)² each. All of it is below
//! L·(2^4·(De + e²) + 2^-47·D²).
//!
//! A product that underflows is off by 2^-1074·L at most. That is far less than a bound above 2^-900·L. If a bound is
//! less or not a number, nothing is said.

use std::cmp::Ordering;

/// The rounding of a difference, over the largest coordinate: 2^-50.
const DIFFERENCE: f64 = 4.0 * f64::EPSILON;
/// A bound that underflow cannot matter for: 2^-900.
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);

type Double = [f64; 3];

/// A ray from a rounded point, in an exact direction.
pub(super) struct Ray {
    pub(super) from: Double,
    pub(super) direction: Double,
}

impl Ray {
    /// True if the line of the ray surely has no point in common with a triangle that has an area.
    pub(super) fn misses(&self, corners: [Double; 3]) -> bool {
        let largest = |of: &[Double]| of.as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let by = corners.map(|p| [0, 1, 2].map(|i| p[i] - self.from[i]));
        let d = largest(&by);
        let e = DIFFERENCE * largest(&corners).max(largest(&[self.from]));
        let bound = 16.0 * (d * e + e * e) + 32.0 * f64::EPSILON * d * d;
        let limit = largest(&[self.direction]) * bound;
        let [x, y, z] = self.direction;
        let passing = |p: Double, q: Double| {
            let side =
                x * (p[1] * q[2] - p[2] * q[1]) + y * (p[2] * q[0] - p[0] * q[2]) + z * (p[0] * q[1] - p[1] * q[0]);
            (bound > LEAST && side.abs() > limit).then(|| side.total_cmp(&0.0))
        };
        let [a, b, c] = by;
        let passings = [passing(a, b), passing(b, c), passing(c, a)];
        passings.contains(&Some(Ordering::Less)) && passings.contains(&Some(Ordering::Greater))
    }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Scene, Vertex};
    use rug::Rational;

    use super::super::{Materials, Meeting};
    use super::*;

    /// Triangles with many bits, at the origin or far from it, and rays through their middles, sides or corners, or
    /// beside these by a little: no ray is missed that rationals meet, and some are not certain.
    #[test]
    fn what_is_missed_surely_is_missed() {
        let mut state = 5_u64;
        let mut next = |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u32::try_from(state >> 33).expect("31 bits") % bound
        };
        let mut counts = [0; 2];
        for round in 0..3000 {
            let far = [0.0, 2.0_f64.powi(40)][round % 2];
            let corners: [Double; 3] =
                [(); 3].map(|()| [(); 3].map(|()| far + f64::from(next(1 << 20)) / f64::from(next(999) + 1)));
            let of = next(3) as usize + 1;
            let off = Rational::from((u64::from(next(3)) << 20, 1_u64 << (next(63) + 1)));
            let direction = [(); 3].map(|()| i32::try_from(next(200)).expect("below 200") - 100);
            if direction == [0; 3] {
                continue;
            }
            let steps = Rational::from(next(50));
            let q = [0, 1, 2].map(|i: usize| {
                let sum: Rational = corners[..of].iter().map(|p| crate::rational(p[i])).sum();
                sum / Rational::from(of) + &off * Rational::from(i + 1) - &steps * Rational::from(direction[i])
            });
            let ray = Ray { from: q.each_ref().map(Rational::to_f64), direction: direction.map(f64::from) };
            let scene = Scene::from_points3(&corners).expect("finite points");
            let triangle = [0, 1, 2].map(Vertex::input);
            let materials = Materials::new(&scene, &[], &[]);
            let met = materials.along(triangle, &q, &direction.map(Rational::from));
            let is_missed = ray.misses(corners);
            assert!(!is_missed || matches!(met, Some(Meeting::Missed)), "{corners:?} {direction:?}");
            counts[usize::from(is_missed)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
    }

    #[test]
    fn nothing_is_said_out_of_range() {
        for unit in [2.0_f64.powi(-500), 2.0_f64.powi(700)] {
            let ray = Ray { from: [3.0 * unit; 3], direction: [0.0, 0.0, 1.0] };
            assert!(!ray.misses([[0.0; 3], [unit, 0.0, 0.0], [0.0, unit, 0.0]]));
        }
    }
}
