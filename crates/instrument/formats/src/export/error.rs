//! Why a mesh is not written.

/// Why a mesh is not written. Vertices and faces are named by their places, from 0.
#[derive(Debug)]
pub enum ExportError {
    /// Writing failed; part of the file may be there.
    Io(std::io::Error),
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// A corner is none of the vertices.
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The corner.
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
        vertex: u32,
    },
    /// More vertices or faces than 2^31 - 1.
    TooMany,
    /// STL has triangles only.
    NoTriangle {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// STL has no vertices but those of faces.
    Unused {
        /// The vertex.
        vertex: usize,
    },
    /// STL knows vertices by their coordinates, and two have the same.
    OnePlace {
        /// The vertices.
        vertices: [usize; 2],
    },
    /// Binary STL has singles, and a coordinate is none.
    NoSingle {
        /// The vertex.
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
            E::NotFinite { vertex } => write!(f, "vertex {vertex} is not finite; no format keeps it"),
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
            E::TooMany => f.write_str("a file has at most 2^31 - 1 vertices and as many faces; divide the mesh"),
            E::NoTriangle { face, corners } => {
                write!(f, "face {face} has {corners} corners, and STL has triangles only; divide it, or write PLY")
            }
            E::Unused { vertex } => {
                write!(f, "vertex {vertex} is in no face, and STL would lose it; remove it, or write PLY")
            }
            E::OnePlace { vertices: [a, b] } => {
                write!(f, "vertices {a} and {b} are at one place, and STL would make one of them; write PLY")
            }
            E::NoSingle { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is no single, and binary STL would round it; ")?;
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
