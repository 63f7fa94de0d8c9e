//! The session's answers, one by one and in batches, each tallied once.

use predicament_arithmetic::bound;
use predicament_predicates::{
    Axis, Construction, Dimension, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign, Tally, Vertex,
};

use super::Session;
use crate::Exact;
use crate::batch::{self, Along, Batch, Sweep, View, Whole, Xy, Yz, Zx};
use crate::first;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::side::Side;
use crate::stage;

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.constructed.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.construct_where(definitions, |_| Ok(()))
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Exact)
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tallied(PredicateKind::Compare, self.decide_compare(axis, a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient2d, self.decide_orient2d(plane, a, b, c))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient3d, self.decide_orient3d(a, b, c, d))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Incircle, self.decide_incircle(a, b, c, d))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tallied(PredicateKind::Insphere, self.decide_insphere(a, b, c, d, e))
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        match (self.constructed.scene().dimension(), axis) {
            (Dimension::Two, Axis::X) => self.compare_all::<Along<0>, 2>(axis, self.points2, queries, out),
            (Dimension::Two, Axis::Y) => self.compare_all::<Along<1>, 2>(axis, self.points2, queries, out),
            // There's no such axis, which is said where one is asked.
            (Dimension::Two, Axis::Z) => {
                queries.iter().zip(out).for_each(|(&[a, b], out)| *out = self.compare(axis, a, b));
            }
            (Dimension::Three, Axis::X) => self.compare_all::<Along<0>, 3>(axis, self.points3, queries, out),
            (Dimension::Three, Axis::Y) => self.compare_all::<Along<1>, 3>(axis, self.points3, queries, out),
            (Dimension::Three, Axis::Z) => self.compare_all::<Along<2>, 3>(axis, self.points3, queries, out),
        }
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        if self.turn_scale[plane as usize] != 0.0 {
            return queries.iter().zip(out).for_each(|(&[a, b, c], out)| *out = self.orient2d(plane, a, b, c));
        }
        let climb = |&[a, b, c]: &[Vertex; 3]| self.climb_orient2d(plane, a, b, c);
        let bound = self.turn_bound(plane);
        let is_double = || self.solid().orient2d[plane as usize].is_double();
        let asked = (queries, out);
        match (self.constructed.scene().dimension(), plane) {
            (Dimension::Two, Plane::Xy) => {
                let is_double = || self.flat().orient2d.is_double();
                self.batch::<Orient2d, Whole, 2, 2, 3>(bound, self.points2, asked, is_double, climb);
            }
            (_, Plane::Xy) => {
                self.batch::<Orient2d, Xy, 3, 2, 3>(bound, self.points3, asked, is_double, climb);
            }
            (_, Plane::Yz) => {
                self.batch::<Orient2d, Yz, 3, 2, 3>(bound, self.points3, asked, is_double, climb);
            }
            (_, Plane::Zx) => {
                self.batch::<Orient2d, Zx, 3, 2, 3>(bound, self.points3, asked, is_double, climb);
            }
        }
    }

    fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        let (Some(p), Some(q)) = (self.point2(plane, a), self.point2(plane, b)) else {
            return points.iter().zip(out).for_each(|(&c, out)| *out = self.orient2d(plane, a, b, c));
        };
        let climb = |c: Vertex| self.decide_orient2d(plane, a, b, c);
        let bound = self.turn_bound(plane);
        let asked = (points, out);
        match (self.constructed.scene().dimension(), plane) {
            (Dimension::Two, _) => {
                let side = Side::of_line([p, q], self.extent2);
                self.beside::<Orient2d, Whole, 2, 2, 3>(bound, side, self.points2, asked, climb);
            }
            (Dimension::Three, plane) => {
                let side = Side::of_line([p, q], plane.axes().map(|axis| self.extent3[axis.index()]));
                match plane {
                    Plane::Xy => self.beside::<Orient2d, Xy, 3, 2, 3>(bound, side, self.points3, asked, climb),
                    Plane::Yz => self.beside::<Orient2d, Yz, 3, 2, 3>(bound, side, self.points3, asked, climb),
                    Plane::Zx => self.beside::<Orient2d, Zx, 3, 2, 3>(bound, side, self.points3, asked, climb),
                }
            }
        }
    }

    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return points.iter().zip(out).for_each(|(&d, out)| *out = self.orient3d(a, b, c, d));
        };
        let climb = |d: Vertex| self.decide_orient3d(a, b, c, d);
        let side = Side::of_plane([*p, *q, *r], self.extent3);
        self.beside::<Orient3d, Whole, 3, 3, 4>(self.orient3d, side, self.points3, (points, out), climb);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.open_orient3d(f64::NAN, a, b, c, d);
        let is_double = || self.solid().orient3d.is_double();
        self.batch::<Orient3d, Whole, 3, 3, 4>(self.orient3d, self.points3, (queries, out), is_double, climb);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.open_incircle(f64::NAN, a, b, c, d);
        let is_double = || self.flat().incircle.is_double();
        self.batch::<Incircle, Whole, 2, 2, 4>(self.incircle, self.points2, (queries, out), is_double, climb);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let climb = |query: &[Vertex; 5]| self.open_insphere(f64::NAN, *query);
        let is_double = || self.solid().insphere.is_double();
        self.batch::<Insphere, Whole, 3, 3, 5>(self.insphere, self.points3, (queries, out), is_double, climb);
    }
}

impl<T: Tally> Session<'_, T> {
    #[inline]
    fn batch<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        static_bound: f64,
        points: &[[f64; E]],
        (queries, out): (&[[Vertex; N]], &mut [Sign]),
        is_double: impl Fn() -> bool,
        climb: impl Fn(&[Vertex; N]) -> (Sign, usize),
    ) {
        batch::run::<P, V, E, D, N>(Batch {
            static_bound,
            points,
            queries,
            out,
            is_double,
            settled: |stage, count| self.tally.settled_many(P::KIND, stage, count),
            climb: |query: &[Vertex; N]| {
                let (sign, stage) = climb(query);
                self.tally.settled(P::KIND, stage);
                sign
            },
        });
    }

    /// Where points lie beside a line or plane; `static_bound` is that of the predicate.
    #[inline]
    fn beside<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        static_bound: f64,
        side: Side<D>,
        points: &[[f64; E]],
        (vertices, out): (&[Vertex], &mut [Sign]),
        climb: impl Fn(Vertex) -> (Sign, usize),
    ) {
        // Where the scene has no bound, there is none here; where that is zero, all determinants are.
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
            settled: |count| self.tally.settled_many(P::KIND, stage::STATIC, count),
            climb: |&[vertex]: &[Vertex; 1]| self.tallied(P::KIND, climb(vertex)),
        });
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
    ) {
        batch::sweep::<V, E, 1, 2>(Sweep {
            // Never rounded to zero and never to the other sign, so as good as exact. (It may overflow.)
            evaluate: |[[x], [y]]: [[f64; 1]; 2]| (x - y, 0.0),
            points,
            queries,
            out,
            settled: |count| self.tally.settled_many(PredicateKind::Compare, stage::COMPARE, count),
            climb: |&[a, b]: &[Vertex; 2]| self.compare(axis, a, b),
        });
    }

    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }
}
