//! The map from a family's coordinates to the axis or plane of the question.

use predicament_predicates::{Axis, Dimension, Plane, Question};

use crate::Random;

/// Maps points to the axes of the question: a family's first coordinate to the compared axis, its plane to the
/// question's plane. Coordinates that the question does not use are uniform in [0, 1).
pub fn place(coordinates: Vec<f64>, question: Question, dimension: Dimension, rng: &mut Random) -> Vec<f64> {
    let (first, second) = match question {
        Question::Compare(axis) => (axis, if axis == Axis::Y { Axis::X } else { Axis::Y }),
        Question::Orient2d(plane) => (plane.axes()[0], plane.axes()[1]),
        Question::Incircle => (Axis::X, Axis::Y),
        Question::Orient3d | Question::Insphere | Question::Derived(_) => return coordinates,
    };
    if dimension == Dimension::Two && (first, second) == (Plane::Xy.axes()[0], Plane::Xy.axes()[1]) {
        return coordinates;
    }
    let mut placed = Vec::with_capacity(coordinates.len() / 2 * dimension.count());
    for pair in coordinates.as_chunks::<2>().0 {
        let mut point: [f64; 3] = std::array::from_fn(|_| if dimension == Dimension::Three { rng.unit() } else { 0.0 });
        point[first.index()] = pair[0];
        point[second.index()] = pair[1];
        placed.extend(&point[..dimension.count()]);
    }
    placed
}
