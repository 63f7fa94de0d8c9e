//! A session that answers known zeros itself: three points of one line have no turn, and two points of a line across an
//! axis have equal coordinates there.
//!
//! Points on an edge of a triangle are in line, and so are the intersections with a plane of the other mesh, even if
//! several coplanar triangles are in that plane. Such a zero holds for any perturbation, which makes it the most
//! expensive predicate: a perturbed session must evaluate every power of ε before it returns zero.

use std::sync::OnceLock;

use predicament_predicates::{Axis, Predicates, Question, Scene, Sign, Vertex, answer_by};

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

    /// Returns true for a vertex on an edge of the triangle.
    pub fn is_at_border(&self, v: Vertex) -> bool {
        self.lines(v) & 0b111 != 0
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

impl Known<'_> {
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let is_known = match (question, &args[..]) {
            (Question::Compare(axis), &[a, b]) => self.level()[axis.index()] & self.lines(a) & self.lines(b) != 0,
            (Question::Orient2d(_), &[a, b, c]) => self.are_in_line(a, b, c),
            _ => false,
        };
        if is_known { Sign::Zero } else { question.ask(self.session, &args) }
    }
}

impl Predicates for Known<'_> {
    fn scene(&self) -> &Scene {
        self.session.scene()
    }

    answer_by!(ask);
}
