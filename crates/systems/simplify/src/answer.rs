//! The steps of a simplification, and the triangles that it leaves.

use std::sync::OnceLock;

use predicament_predicates::{Derived, Sign, Vertex};

/// A decision about an edge: the vertex that would be removed moves into the vertex that would stay.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Step {
    /// The edge is collapsed.
    Collapse {
        /// The vertex that is removed.
        gone: Vertex,
        /// The vertex that takes over its triangles.
        kept: Vertex,
    },
    /// The edge stays, because a face would turn over.
    Refusal {
        /// The vertex that would be removed.
        gone: Vertex,
        /// The vertex that would take over its triangles.
        kept: Vertex,
        /// The other two corners of the first face that would turn over.
        base: [Vertex; 2],
        /// The session's answer to [`same_facing`] of the face before and after: zero or negative.
        sign: Sign,
    },
}

/// A simplified mesh.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Simplified {
    /// The decisions in their order. Edges that the link condition forbids are not listed.
    pub steps: Vec<Step>,
    /// The triangles that are left, in the order of the input.
    pub triangles: Vec<[Vertex; 3]>,
    /// A bound on the distance between each vertex of the input and the vertex that it has become.
    ///
    /// Both Hausdorff distances between the two surfaces are at most this: the map that is linear on each triangle and
    /// takes vertices to their new places moves no point further, and covers the new surface.
    pub reach: f64,
}

/// The predicate of the faces that a step changes, by the formula of this name: positive if the triangles `b c u` and
/// `b c v` face the same way.
///
/// # Panics
/// Never: the project ships the formula.
#[must_use]
pub fn same_facing() -> Derived {
    static FOUND: OnceLock<Derived> = OnceLock::new();
    *FOUND.get_or_init(|| Derived::named("same_facing").expect("the project ships the formula"))
}
