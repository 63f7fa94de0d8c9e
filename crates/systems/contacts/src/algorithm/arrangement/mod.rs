//! Arrangements: two complexes, merged at their contacts.
//!
//! A registered pair is an instruction for cutting one mesh with the other. *Vertex with vertex*: both become one
//! point. *Vertex with edge* (or, in space, with a triangle): the edge passes through the vertex. *Edge with edge*,
//! *triangle with edge*: a new point is on both. So the registrations identify points, and an [`Arrangement`] is the
//! result:
//!
//! * merged [points](Arrangement::points): classes of vertices, by union-find over the vertex-vertex pairs, and the new
//!   points of the other pairs;
//! * for each edge its [path](Arrangement::path): the merged points that it passes through, in order as far as the
//!   weights determine it;
//! * in space, the [intersection curves](Arrangement::intersection) of two surfaces: for each pair of triangles the
//!   merged points on both.
//!
//! Only the registrations decide which points are identified. The *location* of a merged point is a separate question
//! with several answers: see [`Seat`].
//!
//! Only registrations are used, so a wrong contact set gives a wrong arrangement. This is intended: if curves do not
//! cross an even number of times after merging, the registrations are wrong. Only the order along an edge needs more
//! than the registrations, as weights are rounded. Vertices exactly on the edge's line are ordered by their
//! coordinates, in rationals.

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
    /// If the contacts do not belong to these complexes.
    #[must_use]
    pub fn new(scene: &Scene, complexes: [&Complex; 2], contacts: &Contacts) -> Arrangement {
        merge::merge(scene, complexes, contacts)
    }
}
