//! Convex hulls: of points of the plane by a monotone chain or by divide and conquer, of points of space by divide and
//! conquer over half-edge meshes or by insertion in random order with a conflict graph.
//!
//! The answer does not depend on the method, nor on the order of insertion: lists begin with the smallest vertex and
//! faces are sorted.
//!
//! # What a zero means
//! * Vertices that no coordinate tells apart are one: of several at one place the smallest index stands for all.
//! * Three vertices in one line: the one in the middle is no vertex of the hull.
//! * Four vertices in one plane: a vertex in the plane of a face is not outside of it, and faces in one plane are merged
//!   to one polygon, whose corners are vertices of three faces or more.
//! * All vertices in one place: the hull is that vertex. All in one line: the two ends. All in one plane: the polygon of
//!   its extreme vertices, in space as two faces back to back.
//!
//! A session that never says zero gets the hull of its perturbed points: simple polygons, faces that are triangles, and
//! vertices that only the perturbation makes extreme.
//!
//! # Signs that contradict each other
//! Every loop is bounded by the number of vertices or faces. Where a step is impossible the algorithm stops: the answer
//! holds the hull as it was before it, and the [`Contradiction`].

mod chains;
mod contradiction;
mod divide;
mod faces;
mod first;
mod incremental;
mod interior;
mod order;
mod plane;
mod scratch;
mod space;
mod stitch;
mod surface;

use predicament_predicates::Vertex;

pub use contradiction::Contradiction;
pub use plane::{PlaneMethod, hull2d};
pub use space::{SpaceMethod, hull3d};

/// The convex hull of points of the plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Hull2 {
    /// Its vertices counterclockwise, from the one with the smallest x on, of several that with the smallest y.
    pub vertices: Vec<Vertex>,
    /// The invariant that did not hold, where signs contradict each other.
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
    /// Its vertices, ascending.
    pub vertices: Vec<Vertex>,
    /// Its faces, each counterclockwise as seen from outside and from its smallest vertex on, sorted. None where the hull
    /// is a point or a segment, two of the same vertices where it is flat.
    pub faces: Vec<Vec<Vertex>>,
    /// The invariant that did not hold, where signs contradict each other.
    pub broken: Option<Contradiction>,
}

/// The numbers of vertices and of faces.
impl std::fmt::Display for Hull3 {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} vertices, {} faces", self.vertices.len(), self.faces.len())?;
        self.broken.map_or(Ok(()), |broken| write!(f, "; broken: {broken}"))
    }
}
