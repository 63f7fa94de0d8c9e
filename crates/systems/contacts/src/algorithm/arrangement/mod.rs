//! Arrangements: two complexes merged where they are in contact.
//!
//! A registered pair is an instruction to whoever cuts one mesh with the
//! other. *Vertex with vertex*: both are one point from now on. *Vertex with
//! edge* (or, in space, with a triangle): the edge passes through the vertex.
//! *Edge with edge*, *triangle with edge*: here is a new point, on both. So the
//! registrations identify points, and an [`Arrangement`] is what is left after
//! they have been identified:
//!
//! * merged [points](Arrangement::points): classes of vertices, by union-find
//!   over the vertex-vertex pairs, and the new points of the other pairs;
//! * for each edge its [path](Arrangement::path): the merged points that it
//!   passes through, in their order as far as weights tell;
//! * in space, the [intersection curves](Arrangement::intersection) of two
//!   surfaces: for each pair of triangles the merged points on both.
//!
//! Points are identified by what was registered alone. Where a merged point
//! *sits* is another question, with more than one answer: a [`Seat`].
//!
//! Nothing is looked at but registrations, so the arrangement of a wrong
//! contact set is a wrong arrangement. That is the point: whether curves still
//! cross an even number of times after merging says something about the
//! registrations. Only the order along an edge is more than they tell: weights
//! are rounded, and vertices that are exactly on the edge's line have the order
//! that their coordinates give, which is decided in rationals.

mod intersection;
mod merge;
mod order;

pub use crate::answer::{Arrangement, MergedPoint, Seat, Side, Stand};
pub use intersection::{Intersection, Meeting};

use predicament_mesh::Complex;
use predicament_predicates::Scene;

use crate::answer::Contacts;

impl Arrangement {
    /// Merges two complexes of a scene by their contacts.
    ///
    /// # Panics
    /// If the contacts are not of these complexes.
    #[must_use]
    pub fn new(scene: &Scene, complexes: [&Complex; 2], contacts: &Contacts) -> Arrangement {
        merge::merge(scene, complexes, contacts)
    }
}
