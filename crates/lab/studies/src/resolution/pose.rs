//! Features in any position: rotated at random, then rounded to the precision of the backend.

use predicament_corpus::Random;

use crate::Precision;

/// A random rotation of space, or of its first two coordinates.
pub(super) struct Pose([[f64; 3]; 3]);

impl Pose {
    /// A random rotation of the plane.
    pub(super) fn of_plane(random: &mut Random) -> Pose {
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        Pose([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    }

    /// A uniformly random rotation of space: from a random unit quaternion, by rejection.
    pub(super) fn of_space(random: &mut Random) -> Pose {
        let [w, x, y, z] = loop {
            let q: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
            let square: f64 = q.iter().map(|c| c * c).sum();
            if (0.01..=1.0).contains(&square) {
                break q.map(|c| c / square.sqrt());
            }
        };
        Pose([
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
            [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
            [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
        ])
    }

    /// A point, rotated and rounded.
    pub(super) fn turn(&self, [x, y, z]: [f64; 3], precision: Precision) -> [f64; 3] {
        self.0.map(|[a, b, c]| {
            let turned = a * x + b * y + c * z;
            #[allow(clippy::cast_possible_truncation)] // rounded on purpose
            match precision {
                Precision::Single => f64::from(turned as f32),
                Precision::Double => turned,
            }
        })
    }
}
