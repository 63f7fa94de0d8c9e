//! A session that is not asked what is known: three points of one line have no turn, and two points of a line
//! across an axis have one coordinate there.
//!
//! Points on an edge of a triangle are in line, and so are those where a plane of the other mesh passes through it, also if several coplanar
//! triangles are in that plane. Such a zero holds for any perturbation, which makes it the dearest question there is: a perturbed
//! session has to look at every power before it says so.

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

/// A session that knows the lines that some vertices are on.
pub(super) struct Known<'a> {
    session: &'a dyn Predicates,
    /// By vertex, ascending: a bit for each line. The first three are the edges of the triangle.
    lines: Vec<(Vertex, u64)>,
    /// For each axis the lines across it: of two points of such a line neither has the larger coordinate.
    level: [u64; 3],
}

pub(super) const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

impl<'a> Known<'a> {
    /// A session that knows these lines, those along the edges of a triangle first, and which of the others are across each axis.
    pub fn new(
        session: &'a dyn Predicates,
        [a, b, c]: [Vertex; 3],
        lines: impl Iterator<Item = (Vertex, u64)>,
        across: [u64; 3],
    ) -> Known<'a> {
        let mut lines: Vec<(Vertex, u64)> = lines.collect();
        lines.sort_unstable();
        let is_level = |axis: Axis, p: Vertex, q: Vertex| u64::from(session.compare(axis, p, q).is_zero());
        let edges = AXES.map(|axis| is_level(axis, a, b) | is_level(axis, b, c) << 1 | is_level(axis, c, a) << 2);
        let level = [0, 1, 2].map(|axis: usize| edges[axis] | across[axis]);
        Known { session, lines, level }
    }

    fn lines(&self, v: Vertex) -> u64 {
        self.lines.binary_search_by_key(&v, |of| of.0).map_or(0, |at| self.lines[at].1)
    }
}

impl Predicates for Known<'_> {
    fn scene(&self) -> &Scene {
        self.session.scene()
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let level = self.level[AXES.iter().position(|&other| other == axis).unwrap_or_default()];
        if level & self.lines(a) & self.lines(b) != 0 {
            return Sign::Zero;
        }
        self.session.compare(axis, a, b)
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        if self.lines(a) & self.lines(b) & self.lines(c) != 0 {
            return Sign::Zero;
        }
        self.session.orient2d(plane, a, b, c)
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.session.orient3d(a, b, c, d)
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.session.incircle(a, b, c, d)
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.session.insphere(a, b, c, d, e)
    }
}
