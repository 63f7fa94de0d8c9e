//! Areas of triangles on a loop, in doubles.
//!
//! Differences of coordinates are scaled by one power of two, so that the largest is about 1: products do not overflow.
//!
//! # Error
//! Let u = 2^-53, and D the largest distance of two points of the loop. Each component of a difference has a relative
//! error of u. Each component of the cross product of two edges has an error of at most 4u(|x₁y₂| + |x₂y₁|), so the
//! product has one of at most 7uD². Its length adds 4u of it. So twice the area of a triangle has an error of at most
//! 12uD². The n − 2 terms of a cover take part in at most 2(n − 2) additions each. So twice the area of a cover has an
//! error of at most 2(n − 2)(n + 4)uD².

use predicament_formats::bits::{power_of_two, scale, top_exponent};
use predicament_predicates::{Scene, Vertex};

/// The points of a loop, and the factors that scale their differences.
pub(super) struct Areas {
    points: Vec<[f64; 3]>,
    factors: [f64; 2],
}

impl Areas {
    pub(super) fn new(scene: &Scene, around: &[Vertex]) -> Areas {
        let mut points: Vec<[f64; 3]> = around.iter().map(|&v| scene.point3(v)).collect();
        // Half of a difference of doubles is finite.
        let extent = |axis: usize| {
            let range = points
                .iter()
                .map(|p| p[axis])
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
            let [low, high] = range;
            if (high - low).is_finite() { top_exponent(high - low) } else { top_exponent(high / 2.0 - low / 2.0) }
        };
        let exponent = (0..3).filter_map(extent).max().unwrap_or_default();
        if exponent > 0 {
            // The difference of large points may overflow, so the points are scaled.
            points.as_flattened_mut().iter_mut().for_each(|x| *x = scale(*x, -exponent));
            return Areas { points, factors: [1.0; 2] };
        }
        // The inverse of the smallest double is not a double.
        let half = -exponent / 2;
        Areas { points, factors: [power_of_two(half), power_of_two(-exponent - half)] }
    }

    /// Twice the area of the triangle at these places of the loop.
    pub(super) fn twice(&self, [a, b, c]: [usize; 3]) -> f64 {
        let [u, v] = [b, c].map(|end| self.difference(a, end));
        let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let [x, y, z] = [minor(1, 2), minor(2, 0), minor(0, 1)];
        (x * x + y * y + z * z).sqrt()
    }

    /// The difference of two points, scaled.
    fn difference(&self, from: usize, to: usize) -> [f64; 3] {
        let ([p, q], [first, second]) = ([from, to].map(|at| self.points[at]), self.factors);
        std::array::from_fn(|axis| (q[axis] - p[axis]) * first * second)
    }
}
