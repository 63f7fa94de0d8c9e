//! Pairs of features: whether their nearest points are inside both, and which of two pairs is nearer.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::questions::{Asked, comparing, inside, meeting};
use crate::answer::Pair;

/// A session that is asked about pairs.
pub(super) struct Asking<'s, P: ?Sized> {
    pub(super) session: &'s P,
}

impl<P: Predicates + ?Sized> Asking<'_, P> {
    fn all(&self, asked: &Asked, wanted: Sign) -> bool {
        asked.iter().all(|(question, args)| question.ask(self.session, args) == wanted)
    }

    /// True if the nearest points of the lines or planes of both features are inside the features.
    pub(super) fn is_inside(&self, pair: &Pair) -> bool {
        self.all(&inside(self.session.scene(), pair), Sign::Positive)
    }

    /// The squared distance of one pair minus that of the other.
    pub(super) fn compare(&self, one: &Pair, other: &Pair) -> Sign {
        let Some((question, args, turns)) = comparing(self.session.scene(), one, other) else { return Sign::Zero };
        let sign = question.ask(self.session, &args);
        if turns { -sign } else { sign }
    }

    /// True if the nearest points of a pair are one point.
    pub(super) fn meets(&self, pair: &Pair) -> bool {
        self.all(&meeting(self.session.scene(), pair), Sign::Zero)
    }

    /// True if an edge of one part passes through the other part: through the inside of a triangle, or, in the plane,
    /// of an edge.
    pub(super) fn cross(&self, one: &[Vertex], other: &[Vertex]) -> bool {
        match (one, other) {
            (&[a, b], &[c, d]) => {
                let turn = |a, b, p| self.session.orient2d(Plane::Xy, a, b, p);
                are_opposite(turn(a, b, c), turn(a, b, d)) && are_opposite(turn(c, d, a), turn(c, d, b))
            }
            (&[a, b, c], &[d, e, f]) => self.pierces([a, b, c], [d, e, f]) || self.pierces([d, e, f], [a, b, c]),
            _ => false,
        }
    }

    /// True if an edge of the second triangle passes through the inside of the first one.
    fn pierces(&self, [a, b, c]: [Vertex; 3], edges: [Vertex; 3]) -> bool {
        let sides = edges.map(|v| self.session.orient3d(a, b, c, v));
        (0..3).any(|at| {
            let next = (at + 1) % 3;
            let [p, q] = [edges[at], edges[next]];
            are_opposite(sides[at], sides[next]) && {
                let side = |u, v| self.session.orient3d(p, q, u, v);
                let first = side(a, b);
                first != Sign::Zero && side(b, c) == first && side(c, a) == first
            }
        })
    }
}

fn are_opposite(one: Sign, other: Sign) -> bool {
    one != Sign::Zero && other == -one
}
