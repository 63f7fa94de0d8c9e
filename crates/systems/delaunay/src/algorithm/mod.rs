//! Delaunay triangulations of points of the plane, by insertion in random rounds along a space-filling curve.
//!
//! Large scenes are divided into vertical strips, which are triangulated in parallel and joined.
//!
//! # Meaning of a zero
//! * Vertices that compare equal on both axes are one: the smallest index represents all, the others are its
//!   [copies](Delaunay2::copies).
//! * All vertices on one line: no triangle; the vertices are the [chain](Delaunay2::chain).
//! * Vertices on an edge of the hull, between its ends, divide it: every vertex is a corner of a triangle.
//! * More than three vertices on one empty circle: each such face is cut as a fan from its smallest index.
//!
//! The answer therefore does not depend on the order of insertion. A session that never answers zero gets the
//! triangulation of its perturbed points, which is unique. It has no copies and no chain of three, and some of its
//! triangles have area only by the perturbation.
//!
//! # Contradictory signs
//! Every loop is bounded by the number of triangles. If a step is impossible, the algorithm stops: the answer holds the
//! triangulation before that step, and the [`Contradiction`]. The only exception is a hole, left by a vertex or by
//! triangles that a constraint crosses: it is always filled, with triangles that wrong signs may have inverted.

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
mod strips;

use predicament_predicates::{Construction, Predicates, Vertex};

pub use answer::Delaunay2;
pub use constrained::constrained_delaunay2d;
pub use contradiction::Contradiction;

use mesh::Mesh;
use region::Region;

/// The minimum number of points of a strip.
const POINTS_OF_STRIP: usize = 1 << 17;
/// The maximum number of strips.
const STRIPS: usize = 16;

/// The Delaunay triangulation of the scene's input vertices.
///
/// Scenes of many points are triangulated in strips, by several threads.
#[must_use]
pub fn delaunay2d<P: Predicates + ?Sized>(session: &P) -> Triangulation {
    // A power of two, because strips are joined in pairs.
    let strips = (session.scene().len() / POINTS_OF_STRIP).checked_ilog2().map_or(1, |exponent| 1 << exponent);
    delaunay2d_in_strips(session, strips.min(STRIPS))
}

/// The Delaunay triangulation of the scene's input vertices, in this number of strips.
///
/// The number does not change the answer of a session whose signs do not contradict each other.
#[must_use]
pub fn delaunay2d_in_strips<P: Predicates + ?Sized>(session: &P, strips: usize) -> Triangulation {
    let joined = if strips < 2 { None } else { strips::in_strips(session, strips) };
    let mut triangulation = joined.unwrap_or_else(|| {
        let points = session.scene().coordinates().as_chunks().0;
        let all = points.iter().zip(0..).map(|(_, at)| at).collect();
        Triangulation::in_order(session, &order::insertion_order(points, all))
    });
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

/// A Delaunay triangulation that supports insertion and removal of vertices.
///
/// It contains the inserted vertices. Pass the same session to each call. With constraints, vertices must not be added
/// or removed any more.
#[derive(Clone, Default, Debug)]
pub struct Triangulation {
    mesh: Mesh,
    /// All vertices if they are collinear, without any triangle; else empty.
    chain: Vec<Vertex>,
    /// Copies, each with its representative at the time it was found.
    copies: Vec<[Vertex; 2]>,
    /// The triangle where the next walk begins.
    near: u32,
    /// The points where constraints cross, in the order of their construction.
    crossings: Vec<Construction>,
    broken: Option<Contradiction>,
    region: Region,
}
