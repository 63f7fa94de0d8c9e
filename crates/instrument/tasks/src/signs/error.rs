//! Error measures of single queries, for tables and plots; they decide nothing.

use predicament_predicates::{Dimension, Plane, Question, Scene, Vertex};

/// The length L of a scene: the largest edge of its points' bounding box. It is rounded (a unit for display), and
/// infinite if the box is wider than the largest double.
#[must_use]
pub fn largest_edge(scene: &Scene) -> f64 {
    let stride = scene.dimension().count();
    (0..stride)
        .map(|axis| {
            let along = scene.coordinates().iter().skip(axis).step_by(stride);
            let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)));
            high - low
        })
        .fold(0.0, f64::max)
}

/// The distance of the last vertex from the line (orient2d) or plane (orient3d) of the others, in units of `l`. `None`
/// if it has no meaning: for other predicates, if the others span nothing, beyond the range of doubles, and for
/// constructed vertices, whose coordinates are not doubles.
///
/// The determinant is the exact one, rounded once; lengths are plain floating point.
#[must_use]
pub fn distance_over_l(scene: &Scene, question: Question, args: &[Vertex], determinant: f64, l: f64) -> Option<f64> {
    if args.iter().any(|v| v.is_constructed()) {
        return None;
    }
    let span = match (question, args) {
        (Question::Orient2d(plane), &[a, b, _]) => {
            let ([ax, ay], [bx, by]) = (scene.point2(plane, a), scene.point2(plane, b));
            (bx - ax).hypot(by - ay)
        }
        (Question::Orient3d, &[a, b, c, _]) if scene.dimension() == Dimension::Three => {
            let along = |plane: Plane| {
                let ([ax, ay], [bx, by], [cx, cy]) =
                    (scene.point2(plane, a), scene.point2(plane, b), scene.point2(plane, c));
                (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            };
            along(Plane::Xy).hypot(along(Plane::Yz)).hypot(along(Plane::Zx))
        }
        _ => return None,
    };
    let distance = determinant.abs() / span / l;
    distance.is_finite().then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_in_units_of_the_scene() {
        let plane = Scene::from_points2(&[[0.0, 0.0], [4.0, 0.0], [1.0, 2.0]]).unwrap();
        let args: Vec<Vertex> = plane.vertices().collect();
        assert_eq!(largest_edge(&plane), 4.0);
        // twice the area is 8, the base 4, so the height 2: half of L.
        assert_eq!(distance_over_l(&plane, Question::Orient2d(Plane::Xy), &args, 8.0, 4.0), Some(0.5));
        let flat = Scene::from_points2(&[[0.0, 0.0], [0.0, 0.0], [1.0, 2.0]]).unwrap();
        assert_eq!(distance_over_l(&flat, Question::Orient2d(Plane::Xy), &args, 0.0, 2.0), None);
        let space = Scene::from_points3(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]).unwrap();
        let args: Vec<Vertex> = space.vertices().collect();
        assert_eq!(distance_over_l(&space, Question::Orient3d, &args, -4.0, 2.0), Some(0.5));
        assert_eq!(distance_over_l(&space, Question::Insphere, &args, -4.0, 2.0), None);
    }
}
