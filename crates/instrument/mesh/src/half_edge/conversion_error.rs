//! The reasons why faces make no half-edge mesh.

use predicament_predicates::Vertex;

/// The reason why a list of faces makes no half-edge mesh. Faces are identified by their indices in the list, from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConversionError {
    /// There are more than 2^31 - 2 corners, or as many vertices or faces.
    TooMany,
    /// A corner is not an index of a vertex.
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The corner, as given.
        corner: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A face has fewer than three corners.
    TooFewCorners {
        /// The face.
        face: usize,
        /// The number of corners.
        corners: usize,
    },
    /// A face has a vertex twice.
    RepeatedVertex {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: Vertex,
    },
    /// An edge has more than two faces.
    ThreeFaces {
        /// The ends of the edge.
        edge: [Vertex; 2],
        /// The first three faces.
        faces: [usize; 3],
    },
    /// Two faces have an edge in the same direction: one of them is flipped.
    FlippedFace {
        /// The edge, in that direction.
        edge: [Vertex; 2],
        /// The faces.
        faces: [usize; 2],
    },
    /// Faces close around a vertex that has further faces.
    SeveralFans {
        /// The vertex.
        vertex: Vertex,
    },
}

impl ConversionError {
    /// The error and its fix as text, with faces and vertices named by these functions, for example by number and line.
    pub fn explained(
        &self,
        face: impl Fn(usize) -> String,
        vertex: impl Fn(Vertex) -> String,
    ) -> (String, &'static str) {
        use ConversionError as E;
        match *self {
            E::TooMany => ("the mesh has more than 2^31 - 2 corners".to_owned(), "divide it"),
            E::NoSuchVertex { face: f, corner, vertices } => {
                let message =
                    format!("face {} has corner {corner}, which is not one of the {vertices} vertices", face(f));
                (message, "correct the index")
            }
            E::TooFewCorners { face: f, corners } => {
                (format!("face {} has {corners} corners", face(f)), "give it three, or remove it")
            }
            E::RepeatedVertex { face: f, vertex: v } => {
                (format!("face {} has vertex {} twice", face(f), vertex(v)), "divide it, or remove it")
            }
            E::ThreeFaces { edge, faces } => {
                let ([a, b], [i, j, k]) = (edge.map(vertex), faces.map(face));
                let message =
                    format!("the edge of vertices {a} and {b} has more than two faces, {i}, {j} and {k} among them");
                (message, "remove all but two, or give the others vertices of their own")
            }
            E::FlippedFace { edge, faces } => {
                let ([a, b], [i, j]) = (edge.map(vertex), faces.map(face));
                let message = format!("faces {i} and {j} both go from vertex {a} to vertex {b}");
                (message, "reverse the corners of one, or remove one if they are the same")
            }
            E::SeveralFans { vertex: v } => {
                let message = format!("faces close around vertex {}, and it has more faces", vertex(v));
                (message, "give these a vertex of their own")
            }
        }
    }

    /// The faulty face, or the last of the faces that conflict; `None` if the error is not about faces.
    #[must_use]
    pub fn face(&self) -> Option<usize> {
        use ConversionError as E;
        match *self {
            E::NoSuchVertex { face, .. } | E::TooFewCorners { face, .. } | E::RepeatedVertex { face, .. } => Some(face),
            E::ThreeFaces { faces: [.., face], .. } | E::FlippedFace { faces: [_, face], .. } => Some(face),
            E::TooMany | E::SeveralFans { .. } => None,
        }
    }
}

impl std::fmt::Display for ConversionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (message, cure) = self.explained(|face| face.to_string(), |vertex| vertex.to_string());
        write!(f, "{message}; {cure}")
    }
}

impl std::error::Error for ConversionError {}
