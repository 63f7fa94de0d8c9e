//! The shift of a scene whose coordinates a format does not hold, but whose extents it does.
//!
//! The paper computes intersections of shifted meshes. A shift changes no difference of coordinates, and every quantity
//! of Algorithms 2 to 12 begins with differences. Tolerances follow from L, a difference as well. So an *exact* shift
//! changes no answer, no band and no proof: rule E of the calculus, about differences of coordinates without an error,
//! holds as before.
//!
//! A subtraction that rounds would move the points, and the bands are not made for that. So a scene is shifted only if
//! every subtraction is exact and the format holds every result. Along each axis the origin is the coordinate nearest
//! to the middle. Where coordinates are multiples of one unit, no other coordinate has results of fewer bits. (Other
//! scenes may be declined although another origin would do.)
//!
//! A shift cannot help in doubles, which hold all coordinates: whether they decline a scene depends on L alone.

use predicament_predicates::Scene;

use crate::Float;

/// The scene in coordinates relative to one of its own along each axis; `None` if one of these is not a number of `F`.
pub(crate) fn shifted<F: Float>(scene: &Scene) -> Option<Scene> {
    let stride = scene.dimension().count();
    let mut coordinates = scene.coordinates().to_vec();
    for axis in 0..stride {
        let column = || scene.coordinates().iter().skip(axis).step_by(stride).copied();
        let (low, high) = (column().fold(f64::INFINITY, f64::min), column().fold(f64::NEG_INFINITY, f64::max));
        let middle = low / 2.0 + high / 2.0;
        let origin = column().min_by(|x, y| (x - middle).abs().total_cmp(&(y - middle).abs()))?;
        for x in coordinates.iter_mut().skip(axis).step_by(stride) {
            *x = difference::<F>(*x, origin)?;
        }
    }
    Scene::new(scene.dimension(), coordinates).ok()
}

/// The difference of two doubles, if it is a number of `F`.
fn difference<F: Float>(x: f64, origin: f64) -> Option<f64> {
    let difference = x - origin;
    // The rounding error of the difference (Knuth); NaN after an overflow.
    let other = difference - x;
    let error = (x - (difference - other)) - (origin + other);
    (error == 0.0 && F::nearest(difference).wide() == difference).then_some(difference)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_exact_or_there_is_none() {
        let far = 2f64.powi(40);
        for (x, origin, expected) in [
            (far + 3.0, far, Some(3.0)),
            (far, far + 0.25, Some(-0.25)),
            (1.0 + f64::EPSILON, 1.0, Some(f64::EPSILON)),
            (-far, -far - 1024.0, Some(1024.0)),
            (f64::MIN_POSITIVE, f64::MIN_POSITIVE, Some(0.0)),
            // Not a number of f32: 25 bits, and too small.
            (far + 2f64.powi(24) + 1.0, far, None),
            (1e-60, 0.0, None),
            // The rounded difference is a number of f32, the true one is not.
            (2f64.powi(54), 0.5, None),
            (far, f64::EPSILON, None),
            (f64::MAX, -f64::MAX, None),
        ] {
            assert_eq!(difference::<f32>(x, origin), expected, "{x:e} - {origin:e}");
        }
        assert_eq!(difference::<f64>(0.1, 0.3), Some(-0.19999999999999998), "within a factor of two");
        assert_eq!(difference::<f64>(0.1, 3.0), None, "rounded");
    }

    #[test]
    fn the_origin_is_in_the_middle() {
        // 2^24 units to both sides: from an end they would take 25 bits.
        let [far, side] = [2f64.powi(40), 2f64.powi(24) - 1.0];
        let scene = Scene::from_points2(&[[far - side, 7.0], [far + side, 7.0], [far, 7.0]]).unwrap();
        let shifted = shifted::<f32>(&scene).unwrap();
        assert_eq!(shifted.coordinates(), [-side, 0.0, side, 0.0, 0.0, 0.0]);
        let longer = Scene::from_points2(&[[far - side, 7.0], [far + side + 1.0, 7.0]]).unwrap();
        assert_eq!(super::shifted::<f32>(&longer), None, "without a point in the middle");
        assert_eq!(super::shifted::<f32>(&Scene::from_points2(&[]).unwrap()), None, "nothing to shift");
    }
}
