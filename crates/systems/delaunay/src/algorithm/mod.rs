//! Delaunay triangulations of points of the plane, by insertion in random rounds along a space-filling curve.
//!
//! # What a zero means
//! * Vertices that no coordinate tells apart are one: the smallest index stands for all, the others are its
//!   [copies](Delaunay2::copies).
//! * All vertices in one line: no triangle; they are the [chain](Delaunay2::chain).
//! * Vertices in the line of an edge of the hull, between its ends, divide it: every vertex is one of a triangle.
//! * More than three vertices on one circle with none inside: each such face is cut as a fan from its smallest index.
//!
//! So the answer does not depend on the order of insertion. A session that never says zero gets the triangulation of its
//! perturbed points, which is unique: no copies, no chain of three, triangles that only the perturbation opens.
//!
//! # Signs that contradict each other
//! Every loop is bounded by the number of triangles. Where a step is impossible the algorithm stops: the answer holds the
//! triangulation as it was before it, and the [`Contradiction`]. Only a hole, left by a vertex or by
//! triangles that a constraint crosses, is filled in any case, with triangles that wrong signs may have turned over.

mod answer;
mod chain;
mod constrained;
mod contradiction;
mod faces;
mod hole;
mod insert;
mod locate;
mod mesh;
mod order;
mod region;
mod remove;

use predicament_predicates::{Construction, Predicates, Vertex};

pub use answer::Delaunay2;
pub use constrained::constrained_delaunay2d;
pub use contradiction::Contradiction;

use mesh::Mesh;
use region::Region;

/// The Delaunay triangulation of the scene's input vertices.
#[must_use]
pub fn delaunay2d<P: Predicates + ?Sized>(session: &P) -> Triangulation {
    let points = session.scene().coordinates().as_chunks().0;
    let mut triangulation = Triangulation::in_order(session, &order::insertion_order(points));
    triangulation.cut_faces();
    triangulation
}

/// The Delaunay triangulation of these vertices, inserted in this order.
#[must_use]
pub fn delaunay2d_in_order<P: Predicates + ?Sized>(session: &P, vertices: &[Vertex]) -> Triangulation {
    let mut triangulation = Triangulation::in_order(session, vertices);
    triangulation.cut_faces();
    triangulation
}

/// A Delaunay triangulation to which vertices can be added, and from which they can be removed.
///
/// It is of the vertices that were inserted, and asks the session that is handed to it: the same one each time. Where there
/// are constraints, vertices are not to be added or removed any more.
#[derive(Clone, Default, Debug)]
pub struct Triangulation {
    mesh: Mesh,
    /// All vertices, where they are in one line; then there is no triangle.
    chain: Vec<Vertex>,
    /// Vertices, and which one stood for each of them when it was found.
    copies: Vec<[Vertex; 2]>,
    /// Where the next walk begins.
    near: u32,
    /// The points where constraints cross, in the order of their construction.
    crossings: Vec<Construction>,
    broken: Option<Contradiction>,
    region: Region,
}
