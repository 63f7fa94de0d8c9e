//! A session that answers known zeros itself: three points of one line have no turn, and two points of a line across an
//! axis have equal coordinates there.
//!
//! Points on an edge of a triangle are in line, and so are the intersections with a plane of the other mesh, even if
//! several coplanar triangles are in that plane. Such a zero holds for any perturbation, which makes it the most
//! expensive predicate: a perturbed session must evaluate every power of ε before it returns zero.

use std::sync::OnceLock;

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

/// A session that knows lines through some vertices.
pub(super) struct Known<'a> {
    session: &'a dyn Predicates,
    corners: [Vertex; 3],
    /// The lines through each vertex, sorted by vertex: a bit for each line. The first three lines are the edges of the
    /// triangle.
    lines: Vec<(Vertex, u64)>,
    /// Three vertices of the plane through each of the other lines, from the fourth on.
    planes: Vec<[Vertex; 3]>,
    /// For each axis the lines across it: two points of such a line have equal coordinates there. It is computed on
    /// demand, because most triangles compare no vertices.
    level: OnceLock<[u64; 3]>,
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

impl<'a> Known<'a> {
    /// Builds a session that knows these lines in a triangle: those along its edges first, then those in planes of the
    /// other mesh.
    pub fn new(
        session: &'a dyn Predicates,
        corners: [Vertex; 3],
        lines: impl Iterator<Item = (Vertex, u64)>,
        planes: Vec<[Vertex; 3]>,
    ) -> Known<'a> {
        let mut lines: Vec<(Vertex, u64)> = lines.collect();
        lines.sort_unstable();
        Known { session, corners, lines, planes, level: OnceLock::new() }
    }

    /// True if three vertices are known to be on one line.
    pub fn are_in_line(&self, a: Vertex, b: Vertex, c: Vertex) -> bool {
        self.lines(a) & self.lines(b) & self.lines(c) != 0
    }

    fn level(&self) -> &[u64; 3] {
        self.level.get_or_init(|| {
            AXES.map(|axis| {
                let is_level = |p: Vertex, q: Vertex| u64::from(self.session.compare(axis, p, q).is_zero());
                let [a, b, c] = self.corners;
                let edges = is_level(a, b) | is_level(b, c) << 1 | is_level(c, a) << 2;
                let across = |&[a, b, c]: &[Vertex; 3]| is_level(a, b) & is_level(a, c);
                self.planes.iter().take(61).zip(3..).fold(edges, |lines, (plane, line)| lines | across(plane) << line)
            })
        })
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
        let level = self.level()[AXES.iter().position(|&other| other == axis).unwrap_or_default()];
        if level & self.lines(a) & self.lines(b) != 0 {
            return Sign::Zero;
        }
        self.session.compare(axis, a, b)
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        if self.are_in_line(a, b, c) {
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
