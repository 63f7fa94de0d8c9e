//! The length L of a set of points: the largest edge of their bounding box.

use predicament_arithmetic::difference_up;
use predicament_predicates::{Axis, Scene};

/// The largest extent of the scene along the given axes, rounded up, so that no exact coordinate difference is larger.
///
/// It is infinite if no double is large enough.
pub(crate) fn largest_extent(scene: &Scene, axes: &[Axis]) -> f64 {
    axes.iter().map(|&axis| extent(scene, axis)).fold(0.0, f64::max)
}

fn extent(scene: &Scene, axis: Axis) -> f64 {
    let coordinates = || scene.vertices().map(|v| scene.coordinate(axis, v));
    let low = coordinates().fold(f64::INFINITY, f64::min);
    let high = coordinates().fold(f64::NEG_INFINITY, f64::max);
    if scene.is_empty() { 0.0 } else { difference_up(high, low) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_edge_of_the_box_counts() {
        let scene = Scene::from_points3(&[[0.0, -0.0, 7.0], [2.0, 0.0, 4.0]]).unwrap();
        assert_eq!(largest_extent(&scene, &[Axis::X, Axis::Y, Axis::Z]), 3.0);
        assert_eq!(largest_extent(&scene, &[Axis::X, Axis::Y]), 2.0);
        assert_eq!(largest_extent(&scene, &[Axis::Y]), 0.0);
        assert_eq!(largest_extent(&Scene::from_points2(&[]).unwrap(), &[Axis::X]), 0.0);
    }
}
