//! Answers in batches, with the number of queries that each stage has settled.

use predicament_arithmetic::bound;
use predicament_lanes::{Along, View, Whole, Xy, Yz, Zx};
use predicament_predicates::{Axis, Dimension, Plane, Sign, Vertex};

use super::Decider;
use crate::batch::{self, Batch, NONE, Settled, Sweep, Ties, Unbroken};
use crate::first;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::side::Side;
use crate::stage;

impl Decider<'_> {
    pub fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) -> Settled {
        match (self.constructed.scene().dimension(), axis) {
            (Dimension::Two, Axis::X) => self.compare_all::<Along<0>, 2>(axis, self.points2, queries, out),
            (Dimension::Two, Axis::Y) => self.compare_all::<Along<1>, 2>(axis, self.points2, queries, out),
            // There is no such axis; the single query reports it.
            (Dimension::Two, Axis::Z) => singly(queries, out, |&[a, b]| self.decide_compare(axis, a, b)),
            (Dimension::Three, Axis::X) => self.compare_all::<Along<0>, 3>(axis, self.points3, queries, out),
            (Dimension::Three, Axis::Y) => self.compare_all::<Along<1>, 3>(axis, self.points3, queries, out),
            (Dimension::Three, Axis::Z) => self.compare_all::<Along<2>, 3>(axis, self.points3, queries, out),
        }
    }

    /// Returns true if turns in the plane are decided one by one, in integers.
    pub fn turns_in_integers(&self) -> bool {
        self.turn_scale[Plane::Xy as usize] != 0.0
    }

    pub fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) -> Settled {
        self.orient2d_batch_with(plane, queries, out, Unbroken)
    }

    #[inline]
    pub fn orient2d_batch_with(
        &self,
        plane: Plane,
        queries: &[[Vertex; 3]],
        out: &mut [Sign],
        ties: impl Ties<2, 3>,
    ) -> Settled {
        if self.turn_scale[plane as usize] != 0.0 {
            return singly(queries, out, |&[a, b, c]| self.decide_orient2d(plane, a, b, c));
        }
        let climb = |&[a, b, c]: &[Vertex; 3]| self.climb_orient2d(plane, a, b, c);
        let bound = self.turn_bound(plane);
        let is_double = || self.solid().orient2d[plane as usize].is_double();
        let asked = (queries, out);
        match (self.constructed.scene().dimension(), plane) {
            (Dimension::Two, Plane::Xy) => {
                let is_double = || self.flat().orient2d.is_double();
                self.batch::<Orient2d, Whole, 2, 2, 3>(bound, self.points2, asked, is_double, climb, ties)
            }
            (_, Plane::Xy) => self.batch::<Orient2d, Xy, 3, 2, 3>(bound, self.points3, asked, is_double, climb, ties),
            (_, Plane::Yz) => self.batch::<Orient2d, Yz, 3, 2, 3>(bound, self.points3, asked, is_double, climb, ties),
            (_, Plane::Zx) => self.batch::<Orient2d, Zx, 3, 2, 3>(bound, self.points3, asked, is_double, climb, ties),
        }
    }

    pub fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) -> Settled {
        let (Some(p), Some(q)) = (self.point2(plane, a), self.point2(plane, b)) else {
            return singly(points, out, |&c| self.decide_orient2d(plane, a, b, c));
        };
        let climb = |c: Vertex| self.decide_orient2d(plane, a, b, c);
        let bound = self.turn_bound(plane);
        let asked = (points, out);
        match (self.constructed.scene().dimension(), plane) {
            (Dimension::Two, _) => {
                let side = Side::of_line([p, q], self.extent2);
                beside::<Orient2d, Whole, 2, 2, 3>(bound, side, self.points2, asked, climb)
            }
            (Dimension::Three, plane) => {
                let side = Side::of_line([p, q], plane.axes().map(|axis| self.extent3[axis.index()]));
                match plane {
                    Plane::Xy => beside::<Orient2d, Xy, 3, 2, 3>(bound, side, self.points3, asked, climb),
                    Plane::Yz => beside::<Orient2d, Yz, 3, 2, 3>(bound, side, self.points3, asked, climb),
                    Plane::Zx => beside::<Orient2d, Zx, 3, 2, 3>(bound, side, self.points3, asked, climb),
                }
            }
        }
    }

    pub fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) -> Settled {
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return singly(points, out, |&d| self.decide_orient3d(a, b, c, d));
        };
        let climb = |d: Vertex| self.decide_orient3d(a, b, c, d);
        let side = Side::of_plane([*p, *q, *r], self.extent3);
        beside::<Orient3d, Whole, 3, 3, 4>(self.orient3d, side, self.points3, (points, out), climb)
    }

    pub fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) -> Settled {
        self.orient3d_batch_with(queries, out, Unbroken)
    }

    #[inline]
    pub fn orient3d_batch_with(&self, queries: &[[Vertex; 4]], out: &mut [Sign], ties: impl Ties<3, 4>) -> Settled {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.open_orient3d(f64::NAN, a, b, c, d);
        let is_double = || self.solid().orient3d.is_double();
        self.batch::<Orient3d, Whole, 3, 3, 4>(self.orient3d, self.points3, (queries, out), is_double, climb, ties)
    }

    pub fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) -> Settled {
        self.incircle_batch_with(queries, out, Unbroken)
    }

    #[inline]
    pub fn incircle_batch_with(&self, queries: &[[Vertex; 4]], out: &mut [Sign], ties: impl Ties<2, 4>) -> Settled {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.open_incircle(f64::NAN, a, b, c, d);
        let is_double = || self.flat().incircle.is_double();
        self.batch::<Incircle, Whole, 2, 2, 4>(self.incircle, self.points2, (queries, out), is_double, climb, ties)
    }

    pub fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) -> Settled {
        self.insphere_batch_with(queries, out, Unbroken)
    }

    #[inline]
    pub fn insphere_batch_with(&self, queries: &[[Vertex; 5]], out: &mut [Sign], ties: impl Ties<3, 5>) -> Settled {
        let climb = |query: &[Vertex; 5]| self.open_insphere(f64::NAN, *query);
        let is_double = || self.solid().insphere.is_double();
        self.batch::<Insphere, Whole, 3, 3, 5>(self.insphere, self.points3, (queries, out), is_double, climb, ties)
    }
}

impl Decider<'_> {
    #[inline]
    fn batch<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        static_bound: f64,
        points: &[[f64; E]],
        (queries, out): (&[[Vertex; N]], &mut [Sign]),
        is_double: impl Fn() -> bool,
        climb: impl Fn(&[Vertex; N]) -> (Sign, usize),
        ties: impl Ties<D, N>,
    ) -> Settled {
        batch::run::<P, V, E, D, N>(Batch { static_bound, points, queries, out, is_double, climb, ties })
    }

    /// The bound of the static filter for turns.
    fn turn_bound(&self, plane: Plane) -> f64 {
        let extent = match self.constructed.scene().dimension() {
            Dimension::Two => self.extent2,
            Dimension::Three => plane.axes().map(|axis| self.extent3[axis.index()]),
        };
        first::bound(extent, bound::static_orient2d)
    }

    /// Comparisons of many vertices, seen along one axis.
    #[inline]
    fn compare_all<V: View<E, 1>, const E: usize>(
        &self,
        axis: Axis,
        points: &[[f64; E]],
        queries: &[[Vertex; 2]],
        out: &mut [Sign],
    ) -> Settled {
        batch::sweep::<V, E, 1, 2>(Sweep {
            // Never rounded to zero or to the other sign, so as good as exact. (It may overflow.)
            evaluate: |[[x], [y]]: [[f64; 1]; 2]| (x - y, 0.0),
            points,
            queries,
            out,
            stage: stage::COMPARE,
            // Input vertices are certain.
            climb: |&[a, b]: &[Vertex; 2]| self.constructed.compare(axis, a, b),
        })
    }
}

/// Answers where points lie beside a line or plane; `static_bound` is the predicate's.
#[inline]
pub(crate) fn beside<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    static_bound: f64,
    side: Side<D>,
    points: &[[f64; E]],
    (vertices, out): (&[Vertex], &mut [Sign]),
    climb: impl Fn(Vertex) -> (Sign, usize),
) -> Settled {
    // If the scene has no bound, there is none here; if the bound is zero, all determinants are.
    let bound = match static_bound {
        0.0 => 0.0,
        bound if bound.is_nan() => f64::NAN,
        _ => first::beside(P::DETERMINANT.bound * side.permanent),
    };
    batch::sweep::<V, E, D, 1>(Sweep {
        evaluate: move |[point]: [[f64; D]; 1]| (side.determinant(point), bound),
        points,
        queries: vertices.as_chunks::<1>().0,
        out,
        stage: stage::STATIC,
        climb: |&[vertex]: &[Vertex; 1]| climb(vertex),
    })
}

/// Answers queries one by one.
#[inline]
pub(crate) fn singly<Q>(queries: &[Q], out: &mut [Sign], decide: impl Fn(&Q) -> (Sign, usize)) -> Settled {
    let mut settled = NONE;
    batch::climb_all(queries, out, &mut settled, decide);
    settled
}
