//! Locating a point in the cells of a line (Franklin & Magalhães, 4.1).
//!
//! As sets, [l, r] and [r, s] both contain r. An algorithm on top needs a partition: every point in exactly one cell.
//! Simulation of Simplicity gives a partition without a special case for r: it moves a point by an infinitesimal, so
//! the point is never at an end. If the point moves further than the ends, the predicate l ≤ p' ≤ r becomes the rule l
//! ≤ p < r, without an infinitesimal: [`half_open`].
//!
//! [`place`] asks any session, which decides for itself the order of equal coordinates.
//!
//! ```
//! # use predicament_interval::algorithm::{Place, half_open, place};
//! # use predicament_exact::Exact;
//! # use predicament_sos::Sos;
//! # use predicament_predicates::{Axis, Backend, Off, Scene, Vertex};
//! // The point comes first, so that it is moved further than the ends of both cells.
//! let scene = Scene::from_points2(&[[1., 0.], [0., 0.], [1., 0.], [2., 0.]])?;
//! let [point, l, m, r] = [0, 1, 2, 3].map(Vertex::input);
//! let sos = Sos::default();
//! let (exact, sos) = (Exact.prepare(&scene, Off)?, sos.prepare(&scene, Off)?);
//! for (cell, ends, rule) in [([l, m], [0., 1.], false), ([m, r], [1., 2.], true)] {
//!     assert_eq!(place(&exact, Axis::X, cell, point), Place::AtEnd);
//!     assert_eq!(place(&sos, Axis::X, cell, point) == Place::Inside, rule);
//!     assert_eq!(half_open(ends, 1.), rule);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use predicament_predicates::{Axis, Predicates, Sign, Vertex};

pub use crate::answer::Place;

/// The place of a point relative to the cell between a left and a right end, as the session compares them along the
/// axis.
///
/// A point is never inside a cell whose right end is not right of the left one.
#[inline]
pub fn place<P: Predicates + ?Sized>(session: &P, axis: Axis, [left, right]: [Vertex; 2], point: Vertex) -> Place {
    let from_left = session.compare(axis, point, left);
    if from_left == Sign::Negative {
        return Place::Outside;
    }
    match session.compare(axis, right, point) {
        Sign::Negative => Place::Outside,
        Sign::Positive if from_left == Sign::Positive => Place::Inside,
        _ => Place::AtEnd,
    }
}

/// The rule of the paper: true if the point, moved to the right by an infinitesimal, is in the cell [l, r].
#[inline]
#[must_use]
pub fn half_open([left, right]: [f64; 2], point: f64) -> bool {
    left <= point && point < right
}

/// The cells that the point is not outside of, by their numbers.
pub fn cells_at<P: Predicates + ?Sized>(
    session: &P,
    axis: Axis,
    cells: &[[Vertex; 2]],
    point: Vertex,
) -> impl Iterator<Item = (usize, Place)> {
    let places = cells.iter().map(move |&cell| place(session, axis, cell, point));
    places.enumerate().filter(|&(_, place)| place != Place::Outside)
}
