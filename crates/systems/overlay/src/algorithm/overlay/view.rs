//! The predicates of overlays in the plane: turns, the order of a sweep, and the order along a segment.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

/// A view of a session's scene.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub session: &'a dyn Predicates,
}

impl<'a> View<'a> {
    pub fn new(session: &'a dyn Predicates) -> View<'a> {
        View { session }
    }

    /// The turn a, b, c; zero if two of them are one vertex.
    #[inline]
    pub fn turn(&self, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        if a == b || b == c || a == c { Sign::Zero } else { self.session.orient2d(Plane::Xy, a, b, c) }
    }

    /// The order of two vertices along an axis.
    #[inline]
    pub fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        if a == b { Sign::Zero } else { self.session.compare(axis, a, b) }
    }

    /// The order of two vertices from left to right, and from bottom to top if their x is equal.
    #[inline]
    pub fn order(&self, a: Vertex, b: Vertex) -> Sign {
        match self.compare(Axis::X, a, b) {
            Sign::Zero => self.compare(Axis::Y, a, b),
            sign => sign,
        }
    }

    /// True if the direction from one vertex to another is to the right, or straight up.
    #[inline]
    pub fn is_ahead(&self, from: Vertex, to: Vertex) -> bool {
        self.order(from, to) == Sign::Negative
    }

    /// The order along a segment, by the axis along which its raw ends are further apart: different points of the line
    /// differ there.
    pub fn along(&self, [a, b]: [Vertex; 2]) -> Along<'a> {
        let scene = self.session.scene();
        let [p, q] = [a, b].map(|v| scene.point2(Plane::Xy, v));
        let wide = (p[0] / 2.0 - q[0] / 2.0).abs() >= (p[1] / 2.0 - q[1] / 2.0).abs();
        let axes = if wide { [Axis::X, Axis::Y] } else { [Axis::Y, Axis::X] };
        let signs = axes.map(|axis| self.compare(axis, b, a));
        let at = usize::from(signs[0] == Sign::Zero);
        Along { view: *self, axis: axes[at], forward: signs[at] }
    }

    /// True if two vertices are at one position.
    pub fn is_same_place(&self, a: Vertex, b: Vertex) -> bool {
        [Axis::X, Axis::Y].into_iter().all(|axis| self.compare(axis, a, b) == Sign::Zero)
    }
}

/// The order along a segment.
pub(super) struct Along<'a> {
    view: View<'a>,
    pub axis: Axis,
    /// The direction along the axis; zero for a segment without length, whose points are all equal.
    forward: Sign,
}

impl Along<'_> {
    /// The order of two points of the segment.
    #[inline]
    pub fn order(&self, a: Vertex, b: Vertex) -> Sign {
        self.directed(self.view.compare(self.axis, a, b))
    }

    /// The order of two points of the segment, from their order along the axis.
    #[inline]
    pub fn directed(&self, sign: Sign) -> Sign {
        sign * self.forward
    }

    /// True if the segment has no length.
    pub fn is_point(&self) -> bool {
        self.forward == Sign::Zero
    }

    /// True if the segment ascends along its axis.
    pub fn is_rising(&self) -> bool {
        self.forward == Sign::Positive
    }
}
