//! A coordinate plane as the algorithms see it: turns and the order of the sweep.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

/// A coordinate plane of a session's scene, seen from one of its sides.
pub(super) struct View<'a, P: ?Sized> {
    pub session: &'a P,
    plane: Plane,
    /// The axes in the order of the sweep; exchanged if the plane is seen from behind.
    pub axes: [Axis; 2],
    reversed: bool,
}

impl<'a, P: Predicates + ?Sized> View<'a, P> {
    pub fn new(session: &'a P, plane: Plane, reversed: bool) -> View<'a, P> {
        let [first, second] = plane.axes();
        View { session, plane, axes: if reversed { [second, first] } else { [first, second] }, reversed }
    }

    /// The same view with the axes exchanged in the order; turns do not change.
    pub fn across(&self) -> View<'a, P> {
        let [first, second] = self.axes;
        View { axes: [second, first], ..*self }
    }

    /// The turn a, b, c as seen from this side; zero if two of them are one vertex.
    #[inline]
    pub fn turn(&self, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        if a == b || b == c || a == c {
            return Sign::Zero;
        }
        let sign = self.session.orient2d(self.plane, a, b, c);
        if self.reversed { -sign } else { sign }
    }

    /// The order of two vertices along the sweep: by the first axis, then by the second.
    #[inline]
    pub fn order(&self, a: Vertex, b: Vertex) -> Sign {
        if a == b {
            return Sign::Zero;
        }
        match self.session.compare(self.axes[0], a, b) {
            Sign::Zero => self.session.compare(self.axes[1], a, b),
            sign => sign,
        }
    }
}
