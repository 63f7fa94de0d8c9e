//! A planted fault: one wrong turn.

use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Off, Plane, Predicates, Scene, Sign, Vertex};

/// Answers exactly but for one triple, whose turn it reverses.
pub struct OneFlip<'s> {
    pub exact: <Exact as Backend>::Session<'s, Off>,
    pub flipped: [Vertex; 3],
}

impl Predicates for OneFlip<'_> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.exact.compare(axis, a, b)
    }
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let sign = self.exact.orient2d(plane, a, b, c);
        let mut sorted = [a, b, c];
        sorted.sort_unstable();
        if sorted == self.flipped { -sign } else { sign }
    }
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.exact.orient3d(a, b, c, d)
    }
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.exact.incircle(a, b, c, d)
    }
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.exact.insphere(a, b, c, d, e)
    }
}
