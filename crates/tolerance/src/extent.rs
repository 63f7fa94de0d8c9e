//! L for bare points: the largest edge of their bounding box.

use predicament_predicates::{Axis, Scene};

/// The extent of the scene along the given axes, rounded up, so that no exact
/// coordinate difference is larger; infinite where no double is large enough.
pub(crate) fn largest_extent(scene: &Scene, axes: &[Axis]) -> f64 {
    axes.iter().map(|&axis| extent(scene, axis)).fold(0.0, f64::max)
}

fn extent(scene: &Scene, axis: Axis) -> f64 {
    let coordinates = || scene.vertices().map(|v| scene.coordinate(axis, v));
    let low = coordinates().fold(f64::INFINITY, f64::min);
    let high = coordinates().fold(f64::NEG_INFINITY, f64::max);
    if scene.is_empty() { 0.0 } else { difference_up(high, low) }
}

/// high − low, rounded up. The roundoff of a difference is a double, which
/// Knuth's two-sum finds; it is lost only if the difference itself overflows.
fn difference_up(high: f64, low: f64) -> f64 {
    let difference = high - low;
    let low_part = high - difference;
    let high_part = difference + low_part;
    let roundoff = (high - high_part) + (low_part - low);
    if roundoff > 0.0 { difference.next_up() } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_differences_stay_and_others_go_up() {
        assert_eq!(difference_up(3.0, -1.0), 4.0);
        assert_eq!(difference_up(1.0, -2.0_f64.powi(-53)), 1.0_f64.next_up());
        assert_eq!(difference_up(1.0, 2.0_f64.powi(-60)), 1.0);
        assert_eq!(difference_up(f64::MAX, -f64::MAX), f64::INFINITY);
        assert_eq!(difference_up(f64::MAX, -1.0), f64::INFINITY);
        assert_eq!(difference_up(5e-324, -5e-324), 1e-323);
    }

    #[test]
    fn the_largest_edge_of_the_box_counts() {
        let scene = Scene::from_points3(&[[0.0, -0.0, 7.0], [2.0, 0.0, 4.0]]).unwrap();
        assert_eq!(largest_extent(&scene, &[Axis::X, Axis::Y, Axis::Z]), 3.0);
        assert_eq!(largest_extent(&scene, &[Axis::X, Axis::Y]), 2.0);
        assert_eq!(largest_extent(&scene, &[Axis::Y]), 0.0);
        assert_eq!(largest_extent(&Scene::from_points2(&[]).unwrap(), &[Axis::X]), 0.0);
    }
}
