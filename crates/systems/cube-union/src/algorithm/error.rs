//! The errors of a union.

use predicament_predicates::Declined;

/// An error in the input: it is not a set of congruent cubes, or can't be measured exactly.
#[derive(Clone, PartialEq, Debug)]
pub enum CubesError {
    /// The edge length is zero, negative or not finite.
    Edge {
        /// The edge length.
        edge: f64,
    },
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The cube with the coordinate.
        cube: usize,
        /// The axis of the coordinate.
        axis: usize,
        /// The value found.
        value: f64,
    },
    /// The scene has an odd number of vertices, or is in the plane.
    NoPairs {
        /// The number of vertices.
        vertices: usize,
        /// The number of coordinates of a vertex.
        dimension: usize,
    },
    /// This cube's extent along this axis differs from the extent of cube 0 along the first axis.
    Unequal {
        /// The cube.
        cube: usize,
        /// The axis of the extent.
        axis: usize,
    },
    /// The coordinates have no common unit, a power of two, in which they fit in 62 bits.
    TooFine {
        /// The cube with the largest number; `None` for the edge length.
        largest: Option<usize>,
        /// The cube that needs the finest unit; `None` for the edge length.
        finest: Option<usize>,
        /// The number of bits needed.
        bits: u32,
    },
    /// The bounding box of all cubes has a volume of 2^127 units or more, or an edge of 2^62.
    TooLarge {
        /// The edges of the box, in units.
        extents: [u128; 3],
    },
    /// There are more cubes than indices.
    TooMany {
        /// The number of cubes.
        cubes: usize,
    },
    /// The session doesn't compare coordinates.
    Declined(Declined),
}

impl std::fmt::Display for CubesError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let name = |cube: &Option<usize>| cube.map_or("the edge length".to_owned(), |cube| format!("cube {cube}"));
        match self {
            CubesError::Edge { edge } => {
                write!(f, "the edge length is {edge}; it must be positive and finite")
            }
            CubesError::NotFinite { cube, axis, value } => {
                write!(f, "cube {cube}: coordinate {axis} is {value}; every coordinate must be finite")
            }
            CubesError::NoPairs { vertices, dimension } => write!(
                f,
                "{vertices} vertices with {dimension} coordinates do not make cubes: a cube is two vertices in space, \
                 its lower and its upper corner"
            ),
            CubesError::Unequal { cube, axis } => write!(
                f,
                "cube {cube}: its extent along axis {axis} differs from the extent of cube 0 along axis 0; all cubes \
                 must be exactly congruent: give coordinates whose differences are exact"
            ),
            CubesError::TooFine { largest, finest, bits } => write!(
                f,
                "in a common unit of {} and {}, coordinates take {bits} bits; at most 62 are allowed; round the \
                 coordinates to multiples of one power of two",
                name(largest),
                name(finest)
            ),
            CubesError::TooLarge { extents: [x, y, z] } => write!(
                f,
                "the box around the cubes measures {x} x {y} x {z} units; exact sums need a volume below 2^127 and \
                 edges below 2^62: round the coordinates to a coarser unit"
            ),
            CubesError::TooMany { cubes } => write!(f, "{cubes} cubes are too many: at most 2^32 - 1 have an index"),
            CubesError::Declined(declined) => write!(f, "{declined}"),
        }
    }
}

impl std::error::Error for CubesError {}
