//! Batches of the control, with one filter or both.

use predicament_arithmetic::bound;
use predicament_lanes::{View, Whole, Xy, Yz, Zx};
use predicament_predicates::{Axis, Plane, PredicateKind, Sign, Tally, Vertex};

use super::WithoutSession;
use crate::batch::{self, Batch, Settled, Sweep, Unbroken};
use crate::decider::batches::{beside, singly};
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::side::Side;
use crate::{first, stage};

impl<T: Tally, const DEVICE: usize> WithoutSession<'_, T, DEVICE> {
    pub(super) fn compares(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) -> Settled {
        self.exact.decider.compare_batch(axis, queries, out)
    }

    pub(super) fn turns(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) -> Settled {
        if self.turn_scale[plane as usize] != 0.0 {
            return singly(queries, out, |&query| self.decide_orient2d(plane, query));
        }
        let climb = |&query: &[Vertex; 3]| self.turned::<true>(plane, query);
        let of = (self.turn_bound(plane), PredicateKind::Orient2d, plane);
        match (self.points2.is_empty(), plane) {
            (false, _) => self.blocks::<Orient2d, Whole, 2, 2, 3>(of, self.points2, queries, out, climb),
            (true, Plane::Xy) => self.blocks::<Orient2d, Xy, 3, 2, 3>(of, self.points3, queries, out, climb),
            (true, Plane::Yz) => self.blocks::<Orient2d, Yz, 3, 2, 3>(of, self.points3, queries, out, climb),
            (true, Plane::Zx) => self.blocks::<Orient2d, Zx, 3, 2, 3>(of, self.points3, queries, out, climb),
        }
    }

    pub(super) fn orients(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) -> Settled {
        let of = (self.orient3d.bound, PredicateKind::Orient3d, Plane::Xy);
        let climb = |&query: &[Vertex; 4]| self.open_orient3d(f64::NAN, query);
        self.blocks::<Orient3d, Whole, 3, 3, 4>(of, self.points3, queries, out, climb)
    }

    pub(super) fn circles(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) -> Settled {
        let of = (self.incircle.bound, PredicateKind::Incircle, Plane::Xy);
        let climb = |&query: &[Vertex; 4]| self.open_incircle(f64::NAN, query);
        self.blocks::<Incircle, Whole, 2, 2, 4>(of, self.points2, queries, out, climb)
    }

    pub(super) fn spheres(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) -> Settled {
        let of = (self.insphere.bound, PredicateKind::Insphere, Plane::Xy);
        let climb = |&query: &[Vertex; 5]| self.open_insphere(f64::NAN, query);
        self.blocks::<Insphere, Whole, 3, 3, 5>(of, self.points3, queries, out, climb)
    }

    pub(super) fn beside_line(
        &self,
        plane: Plane,
        [a, b]: [Vertex; 2],
        points: &[Vertex],
        out: &mut [Sign],
    ) -> Settled {
        let climb = |c: Vertex| self.decide_orient2d(plane, [a, b, c]);
        let bound = self.turn_bound(plane);
        if let (Some(p), Some(q)) = (self.points2.get(a.index()), self.points2.get(b.index())) {
            let side = Side::of_line([*p, *q], self.extent2);
            return beside::<Orient2d, Whole, 2, 2, 3>(bound, side, self.points2, (points, out), climb);
        }
        let (Some(p), Some(q)) = (self.points3.get(a.index()), self.points3.get(b.index())) else {
            return singly(points, out, |&c| climb(c));
        };
        let axes = plane.axes().map(Axis::index);
        let side = Side::of_line([p, q].map(|p| axes.map(|axis| p[axis])), axes.map(|axis| self.extent3[axis]));
        match plane {
            Plane::Xy => beside::<Orient2d, Xy, 3, 2, 3>(bound, side, self.points3, (points, out), climb),
            Plane::Yz => beside::<Orient2d, Yz, 3, 2, 3>(bound, side, self.points3, (points, out), climb),
            Plane::Zx => beside::<Orient2d, Zx, 3, 2, 3>(bound, side, self.points3, (points, out), climb),
        }
    }

    pub(super) fn beside_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) -> Settled {
        let climb = |d: Vertex| self.decide_orient3d([a, b, c, d]);
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return singly(points, out, |&d| climb(d));
        };
        let side = Side::of_plane([*p, *q, *r], self.extent3);
        beside::<Orient3d, Whole, 3, 3, 4>(self.orient3d.bound, side, self.points3, (points, out), climb)
    }

    /// Answers in blocks by the filters that there are; `climb` answers what they leave open.
    fn blocks<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        (static_bound, kind, plane): (f64, PredicateKind, Plane),
        points: &[[f64; E]],
        queries: &[[Vertex; N]],
        out: &mut [Sign],
        climb: impl Fn(&[Vertex; N]) -> (Sign, usize),
    ) -> Settled {
        if !Self::STATIC {
            let evaluate = |points: [[f64; D]; N]| {
                let of = P::anywhere(points);
                // Strictly beyond the bound; zero is not.
                (of.determinant, if of.determinant.abs() > of.bound { 0.0 } else { f64::NAN })
            };
            let stage = stage::SEMI_STATIC;
            return batch::sweep::<V, E, D, N>(Sweep { evaluate, points, queries, out, stage, climb });
        }
        if !Self::SEMI_STATIC {
            let evaluate = |points: [[f64; D]; N]| (P::estimate(points).determinant, static_bound);
            let stage = stage::STATIC;
            return batch::sweep::<V, E, D, N>(Sweep { evaluate, points, queries, out, stage, climb });
        }
        let is_double = || self.is_double(kind, plane);
        batch::run::<P, V, E, D, N>(Batch { static_bound, points, queries, out, is_double, climb, ties: Unbroken })
    }

    /// The bound of the static filter for turns.
    fn turn_bound(&self, plane: Plane) -> f64 {
        let extent = match self.points2.is_empty() {
            false => self.extent2,
            true => plane.axes().map(|axis| self.extent3[axis.index()]),
        };
        first::bound(extent, bound::static_orient2d)
    }
}
