//! The truth about cells of a line: where a point is, by comparing doubles.
//!
//! Coordinates are doubles and comparing those is exact. Perturbed, of two equal
//! coordinates that of the vertex with the smaller number is larger, as
//! x_i + ε^(2^i) says: for a point that is numbered before both ends the cell
//! is l ≤ p < r, behind both it is l < p ≤ r. So no infinitesimal is left.

use predicament_predicates::{Axis, Scene, Vertex};

/// Where a point is, seen from a cell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Place {
    /// Left or right of it.
    Outside,
    /// At one of the ends, and not outside.
    AtEnd,
    /// Between the ends.
    Inside,
}

/// Where the point is, seen from the cell between a left and a right end.
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

/// Whether the perturbed point is in the cell; it is at an end only if it is that end.
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

/// The cells that a point is not outside of, by their places in the list.
///
/// # Panics
/// As [`place`].
#[must_use]
pub fn cells_at(scene: &Scene, axis: Axis, cells: &[[Vertex; 2]], point: Vertex) -> Vec<(usize, Place)> {
    let places = cells.iter().map(|&cell| place(scene, axis, cell, point));
    places.enumerate().filter(|&(_, place)| place != Place::Outside).collect()
}
