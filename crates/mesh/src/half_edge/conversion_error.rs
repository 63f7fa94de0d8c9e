//! Why faces make no half-edge mesh.

use predicament_predicates::Vertex;

/// Why a list of faces makes no half-edge mesh. Faces are named by their places in the list, from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConversionError {
    /// More than 2^31 - 2 corners, or as many vertices or faces.
    TooMany,
    /// A corner is none of the vertices.
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The corner, as it was given.
        corner: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A face of fewer than three corners.
    TooFewCorners {
        /// The face.
        face: usize,
        /// How many it has.
        corners: usize,
    },
    /// A face names a vertex twice.
    RepeatedVertex {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: Vertex,
    },
    /// More than two faces at an edge.
    ThreeFaces {
        /// The ends of the edge.
        edge: [Vertex; 2],
        /// The first three faces.
        faces: [usize; 3],
    },
    /// Two faces pass along an edge in the same direction: one of them is flipped.
    FlippedFace {
        /// The edge, in that direction.
        edge: [Vertex; 2],
        /// The faces.
        faces: [usize; 2],
    },
    /// Faces close around a vertex, and there are more faces at it.
    SeveralFans {
        /// The vertex.
        vertex: Vertex,
    },
}

impl std::fmt::Display for ConversionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        use ConversionError as E;
        match self {
            E::TooMany => f.write_str("the mesh has more than 2^31 - 2 corners; divide it"),
            E::NoSuchVertex { face, corner, vertices } => {
                write!(
                    f,
                    "face {face} has corner {corner}, which is none of the {vertices} vertices; correct the index"
                )
            }
            E::TooFewCorners { face, corners } => {
                write!(f, "face {face} has {corners} corners; give it three, or remove it")
            }
            E::RepeatedVertex { face, vertex } => {
                write!(f, "face {face} has vertex {vertex} twice; divide it, or remove it")
            }
            E::ThreeFaces { edge: [a, b], faces: [i, j, k] } => {
                write!(f, "the edge of vertices {a} and {b} has more than two faces, {i}, {j} and {k} among them; ")?;
                f.write_str("remove all but two, or give the others vertices of their own")
            }
            E::FlippedFace { edge: [a, b], faces: [i, j] } => {
                write!(f, "faces {i} and {j} both go from vertex {a} to vertex {b}; reverse the corners of one")
            }
            E::SeveralFans { vertex } => {
                write!(f, "faces close around vertex {vertex}, and it has more faces; give these a vertex of their own")
            }
        }
    }
}

impl std::error::Error for ConversionError {}
