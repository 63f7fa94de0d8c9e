//! The exact position of a point relative to cells of a line, by comparing doubles.
//!
//! Coordinates are doubles, and comparing them is exact. In the perturbed scene, of two equal coordinates the
//! coordinate of the vertex with the smaller number is larger, as x_i + ε^(2^i) says. A point that is numbered before
//! both ends is in the cell if l ≤ p < r; a point behind both, if l < p ≤ r. So the rule needs no infinitesimals.

use predicament_predicates::{Axis, Scene, Vertex};

/// The position of a point relative to a cell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Place {
    /// Left or right of the cell.
    Outside,
    /// At one of the ends of a cell, and not outside.
    AtEnd,
    /// Strictly between the ends.
    Inside,
}

/// The position of the point relative to the cell between a left and a right end.
///
/// # Panics
/// If the scene lacks a vertex or the axis.
#[must_use]
pub fn place(scene: &Scene, axis: Axis, [left, right]: [Vertex; 2], point: Vertex) -> Place {
    let [left, right, at] = [left, right, point].map(|v| scene.coordinate(axis, v));
    if at < left || right < at {
        Place::Outside
    } else if left < at && at < right {
        Place::Inside
    } else {
        Place::AtEnd
    }
}

/// The position of the perturbed point relative to the cell; it is at an end only if it is that end's vertex.
///
/// # Panics
/// As [`place`].
#[must_use]
pub fn perturbed_place(scene: &Scene, axis: Axis, [left, right]: [Vertex; 2], point: Vertex) -> Place {
    // The order of the perturbed coordinates: by value, then the later vertex first.
    let key = |v: Vertex| (scene.coordinate(axis, v), std::cmp::Reverse(v));
    let [left, right, at] = [left, right, point].map(key);
    if at < left || right < at {
        Place::Outside
    } else if left < at && at < right {
        Place::Inside
    } else {
        Place::AtEnd
    }
}

/// The indices of the cells that a point is not outside of, each with the point's position.
///
/// # Panics
/// As [`place`].
#[must_use]
pub fn cells_at(scene: &Scene, axis: Axis, cells: &[[Vertex; 2]], point: Vertex) -> Vec<(usize, Place)> {
    let places = cells.iter().map(|&cell| place(scene, axis, cell, point));
    places.enumerate().filter(|&(_, place)| place != Place::Outside).collect()
}
