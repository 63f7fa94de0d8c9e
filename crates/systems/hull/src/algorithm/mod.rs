//! Convex hulls of points in the plane and in space.
//!
//! In the plane, the method is a monotone chain or divide and conquer. In space, it is divide and conquer over
//! half-edge meshes, or insertion in random order with a conflict graph. The answer depends neither on the method nor
//! on the order of insertion: lists begin with the smallest vertex and faces are sorted.
//!
//! # Meaning of a zero
//! * Vertices that compare equal on every axis are one: the smallest index at a place stands for all.
//! * Three vertices on one line: the middle one is not a vertex of the hull.
//! * Four vertices in one plane: a vertex in the plane of a face is not outside of it. Coplanar faces are merged to one
//!   polygon, whose corners are vertices of three faces or more.
//! * All vertices in one place: the hull is that vertex. All on one line: the two ends. All in one plane: the polygon
//!   of its extreme vertices, in space as two faces back to back.
//!
//! A session that never answers zero gets the hull of its perturbed points: simple polygons, triangular faces, and
//! vertices that only the perturbation makes extreme.
//!
//! # Contradictory signs
//! Every loop is bounded by the number of vertices or faces. If a step is impossible, the algorithm stops: the answer
//! holds the hull before that step, and the [`Contradiction`].

mod chains;
mod contradiction;
mod divide;
mod faces;
mod first;
mod incremental;
mod interior;
mod middle;
mod order;
mod parts;
mod plane;
mod scratch;
mod space;
mod stitch;
mod surface;

use predicament_predicates::Vertex;

pub use contradiction::Contradiction;
pub use plane::{PlaneMethod, hull2d};
pub use space::{SpaceMethod, hull3d};

/// The number of points of a piece of parallel work.
const PIECE: usize = 1 << 15;

/// The convex hull of points of the plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Hull2 {
    /// The vertices counterclockwise, from the one with the smallest x on; of several such, the one with the smallest
    /// y.
    pub vertices: Vec<Vertex>,
    /// The invariant that did not hold, if signs contradict each other.
    pub broken: Option<Contradiction>,
}

/// The vertices, by their indices.
impl std::fmt::Display for Hull2 {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let vertices: Vec<String> = self.vertices.iter().map(ToString::to_string).collect();
        f.write_str(&vertices.join(" "))?;
        self.broken.map_or(Ok(()), |broken| write!(f, "; broken: {broken}"))
    }
}

/// The convex hull of points of space.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Hull3 {
    /// The vertices, ascending.
    pub vertices: Vec<Vertex>,
    /// The faces, sorted, each counterclockwise as seen from outside and from its smallest vertex on. A point or a
    /// segment has no faces; a flat hull has two faces with the same vertices.
    pub faces: Vec<Vec<Vertex>>,
    /// The invariant that did not hold, if signs contradict each other.
    pub broken: Option<Contradiction>,
}

/// The numbers of vertices and of faces.
impl std::fmt::Display for Hull3 {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} vertices, {} faces", self.vertices.len(), self.faces.len())?;
        self.broken.map_or(Ok(()), |broken| write!(f, "; broken: {broken}"))
    }
}
