//! The order of parallel faces, the only query of a union of cubes.

use std::cmp::Ordering;

use predicament_predicates::{Axis, Predicates, Sign, Vertex};

/// A face of a cube; its normal is the axis of the query.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Face {
    /// The cube of the face.
    pub cube: u32,
    /// True for the face with the larger coordinate.
    pub upper: bool,
}

/// An order of parallel faces along each axis.
pub trait Order: Sync {
    /// The sign of a's coordinate minus b's.
    fn compare(&self, axis: Axis, a: Face, b: Face) -> Sign;

    /// The position of a face's plane relative to a cube: positive within, zero at one of its faces, negative beyond. A
    /// cube's own faces always count as within and are not queried.
    #[inline]
    fn contact(&self, axis: Axis, face: Face, cube: u32) -> Sign {
        if face.cube == cube {
            return Sign::Positive;
        }
        match self.compare(axis, face, Face { cube, upper: false }) {
            Sign::Positive => self.compare(axis, Face { cube, upper: true }, face),
            other => other,
        }
    }
}

/// The order by the predicates of a session. Its scene has the lower corner of cube i at vertex 2i and the upper one at
/// vertex 2i + 1.
///
/// A session that breaks ties by the vertices' indices here breaks them by those of the cubes. For two faces with equal
/// coordinates belong to two cubes, and 2i, 2i + 1 come before 2j, 2j + 1 iff i comes before j. So the cubes move as
/// rigid bodies, although each vertex is moved separately.
#[derive(Debug)]
pub struct BySession<'s, S>(pub &'s S);

impl<S: Predicates> Order for BySession<'_, S> {
    fn compare(&self, axis: Axis, a: Face, b: Face) -> Sign {
        let vertex = |face: Face| Vertex::input(2 * face.cube as usize + usize::from(face.upper));
        self.0.compare(axis, vertex(a), vertex(b))
    }
}

/// The order by integers; of equal ones, the cube with the smaller index is larger. This is Simulation of Simplicity:
/// cube i is moved by an infinitesimal that is larger than those of all cubes after it.
#[derive(Clone, Copy, Debug)]
pub struct ByIndex<'c> {
    /// The lower corners.
    pub lowers: &'c [[i64; 3]],
    /// The edge length.
    pub edge: i64,
}

impl ByIndex<'_> {
    fn coordinate(&self, axis: Axis, face: Face) -> i64 {
        self.lowers[face.cube as usize][axis.index()] + if face.upper { self.edge } else { 0 }
    }
}

impl Order for ByIndex<'_> {
    fn compare(&self, axis: Axis, a: Face, b: Face) -> Sign {
        let by_value = self.coordinate(axis, a).cmp(&self.coordinate(axis, b));
        Sign::from(by_value.then_with(|| match b.cube.cmp(&a.cube) {
            // The two faces of one cube are an edge apart.
            Ordering::Equal => a.upper.cmp(&b.upper),
            order => order,
        }))
    }
}
