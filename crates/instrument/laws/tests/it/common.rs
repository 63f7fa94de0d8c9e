//! Sessions with planted faults.

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex, forward_to};

/// A session that answers as `inner`, except for what the fault changes.
pub struct Faulty<P> {
    pub inner: P,
    pub fault: Fault,
}

/// The fault of a [`Faulty`] session.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    /// No fault: the wrapper alone must not be reported.
    None,
    /// One pair is compared the wrong way round in x.
    MirroredPair([usize; 2]),
    /// One ordered pair is compared the wrong way round, but its swap is not.
    OneSidedPair([usize; 2]),
    /// One triple turns the other way, in every order.
    FlippedTriple([usize; 3]),
    /// One quadruple is on the other side, in every order.
    FlippedQuadruple([usize; 4]),
    /// Ties are broken by the position in the argument list and not by the vertex.
    TiesByPlace,
    /// All ties are broken towards positive, as a "≥" in place of a ">" does.
    TiesUp,
    /// Ties of turns are broken by the parity of the sum of the indices: each tie on its own, not as part of one
    /// perturbed scene.
    TiesByParity,
    /// Every value within this distance of zero becomes zero, although the session does not declare a band.
    Epsilon(f64),
    /// The last answer of a batch of turns is negated.
    LastOfBatch,
    /// The first point beside a line is reported on the other side.
    FirstOfLine,
    /// Ties are broken by the number of vertices that come after the first argument.
    CountedFromTheEnd,
}

fn sorted<const N: usize>(args: [Vertex; N]) -> [usize; N] {
    let mut sorted = args.map(Vertex::index);
    sorted.sort_unstable();
    sorted
}

impl<P: Predicates> Faulty<P> {
    /// The determinant in plain floating point; exact on small integers.
    fn plain(&self, plane: Plane, args: [Vertex; 3]) -> f64 {
        let [a, b, c] = args.map(|v| self.scene().point2(plane, v));
        (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    }

    fn break_tie(&self, sign: Sign) -> Sign {
        match self.fault {
            Fault::TiesUp | Fault::TiesByPlace if sign.is_zero() => Sign::Positive,
            _ => sign,
        }
    }
}

impl<P: Predicates> Predicates for Faulty<P> {
    fn scene(&self) -> &Scene {
        self.inner.scene()
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let sign = self.inner.compare(axis, a, b);
        match self.fault {
            Fault::MirroredPair(pair) if axis == Axis::X && sorted([a, b]) == pair => -sign,
            Fault::OneSidedPair(pair) if axis == Axis::X && [a, b].map(Vertex::index) == pair => -sign,
            Fault::TiesUp if sign.is_zero() => Sign::Positive,
            _ => sign,
        }
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let sign = self.inner.orient2d(plane, a, b, c);
        match self.fault {
            Fault::FlippedTriple(triple) if sorted([a, b, c]) == triple => -sign,
            Fault::TiesByParity if self.plain(plane, [a, b, c]) == 0.0 => {
                let sum = a.index() + b.index() + c.index();
                if sum.is_multiple_of(2) { Sign::Positive } else { Sign::Negative }
            }
            Fault::CountedFromTheEnd if self.plain(plane, [a, b, c]) == 0.0 => {
                if (self.scene().len() - a.index()).is_multiple_of(3) { -sign } else { sign }
            }
            Fault::Epsilon(eps) if self.plain(plane, [a, b, c]).abs() < eps => Sign::Zero,
            _ => self.break_tie(sign),
        }
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.inner.orient2d_batch(plane, queries, out);
        if let (Fault::LastOfBatch, Some(last)) = (self.fault, out.last_mut()) {
            *last = -*last;
        }
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        self.inner.orient2d_line(plane, line, points, out);
        if let (Fault::FirstOfLine, Some(first)) = (self.fault, out.first_mut()) {
            *first = -*first;
        }
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let sign = self.inner.orient3d(a, b, c, d);
        match self.fault {
            Fault::FlippedQuadruple(quadruple) if sorted([a, b, c, d]) == quadruple => -sign,
            _ => self.break_tie(sign),
        }
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.break_tie(self.inner.incircle(a, b, c, d))
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.break_tie(self.inner.insphere(a, b, c, d, e))
    }
}

/// A session with the comparisons and orientations of one session, and the circles and spheres of another.
pub struct Patched<'a, P, Q> {
    pub sides: &'a P,
    pub circles: &'a Q,
}

impl<P: Predicates, Q: Predicates> Predicates for Patched<'_, P, Q> {
    forward_to!(sides: scene, compare, orient2d, orient3d);

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.circles.incircle(a, b, c, d)
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.circles.insphere(a, b, c, d, e)
    }
}
