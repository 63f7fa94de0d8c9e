//! The reasons why meshes are not written.

/// The reason why a mesh is not written. Vertices and faces are identified by their indices, from 0.
#[derive(Debug)]
pub enum ExportError {
    /// Writing failed; the file may be partly written.
    Io(std::io::Error),
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The index of the vertex.
        vertex: usize,
    },
    /// A corner is not an index of a vertex.
    NoSuchVertex {
        /// The index of the face.
        face: usize,
        /// The corner.
        corner: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A face has fewer than three corners.
    TooFewCorners {
        /// The index of the face.
        face: usize,
        /// The number of corners.
        corners: usize,
    },
    /// A face has a vertex twice.
    RepeatedVertex {
        /// The index of the face.
        face: usize,
        /// The index of the vertex.
        vertex: u32,
    },
    /// There are more than 2^31 - 1 vertices or faces.
    TooMany,
    /// A face is not a triangle, and STL has triangles only.
    NoTriangle {
        /// The index of the face.
        face: usize,
        /// The number of corners.
        corners: usize,
    },
    /// A vertex is in no face, and STL stores only the vertices of faces.
    Unused {
        /// The index of the vertex.
        vertex: usize,
    },
    /// Two vertices have the same coordinates, and STL identifies vertices by coordinates.
    OnePlace {
        /// The indices of the vertices.
        vertices: [usize; 2],
    },
    /// A coordinate is not a single, and binary STL stores singles.
    NoSingle {
        /// The index of the vertex.
        vertex: usize,
    },
}

impl From<std::io::Error> for ExportError {
    fn from(error: std::io::Error) -> ExportError {
        ExportError::Io(error)
    }
}

impl std::fmt::Display for ExportError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        use ExportError as E;
        match self {
            E::Io(error) => write!(f, "the mesh cannot be written: {error}"),
            E::NotFinite { vertex } => write!(f, "vertex {vertex} is not finite; no format can store it"),
            E::NoSuchVertex { face, corner, vertices } => {
                write!(
                    f,
                    "face {face} has corner {corner}, which is not one of the {vertices} vertices; correct the index"
                )
            }
            E::TooFewCorners { face, corners } => {
                write!(f, "face {face} has {corners} corners; give it three, or remove it")
            }
            E::RepeatedVertex { face, vertex } => {
                write!(f, "face {face} has vertex {vertex} twice; divide it, or remove it")
            }
            E::TooMany => f.write_str("a file has at most 2^31 - 1 vertices and as many faces; divide the mesh"),
            E::NoTriangle { face, corners } => {
                write!(f, "face {face} has {corners} corners, and STL has triangles only; divide it, or write PLY")
            }
            E::Unused { vertex } => {
                write!(f, "vertex {vertex} is in no face, and STL would lose it; remove it, or write PLY")
            }
            E::OnePlace { vertices: [a, b] } => {
                write!(f, "vertices {a} and {b} have the same coordinates, and STL would merge them; write PLY")
            }
            E::NoSingle { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not a single, and binary STL would round it; ")?;
                f.write_str("write STL in ASCII, or binary PLY")
            }
        }
    }
}

impl std::error::Error for ExportError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            ExportError::Io(error) => Some(error),
            _ => None,
        }
    }
}
