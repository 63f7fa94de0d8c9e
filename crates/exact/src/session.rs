//! A scene, prepared: which arithmetic its exponents allow, predicate by predicate.

use predicament_arithmetic::Plan;
use predicament_predicates::{Axis, Dimension, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex};

use crate::ladder::Prepared;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::{batch, stage};

/// The exact backend, prepared for one scene.
pub struct Session<'s, T> {
    scene: &'s Scene,
    tally: T,
    /// The scene's points, in the view of its dimension; the other one is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    /// By plane.
    orient2d: [Prepared; 3],
    orient3d: Prepared,
    incircle: Prepared,
    insphere: Prepared,
}

impl<'s, T: Tally> Session<'s, T> {
    pub(crate) fn new(scene: &'s Scene, tally: T) -> Session<'s, T> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let (flat, solid) = (Plan::of(points2), Plan::of(points3));
        let orient2d = match scene.dimension() {
            Dimension::Two => [Prepared::new::<Orient2d, 2, 3>(&flat); 3],
            Dimension::Three => [Plane::Xy, Plane::Yz, Plane::Zx]
                .map(|plane| Prepared::new::<Orient2d, 2, 3>(&solid.project(plane.axes().map(Axis::index)))),
        };
        Session {
            scene,
            tally,
            points2,
            points3,
            orient2d,
            orient3d: Prepared::new::<Orient3d, 3, 4>(&solid),
            incircle: Prepared::new::<Incircle, 2, 4>(&flat),
            insphere: Prepared::new::<Insphere, 3, 5>(&solid),
        }
    }

    /// [`Predicates::compare`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or axis.
    #[inline]
    #[must_use]
    pub fn decide_compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| match self.scene.dimension() {
            Dimension::Two => self.points2[v.index()][axis.index()],
            Dimension::Three => self.points3[v.index()][axis.index()],
        };
        let (a, b) = (at(a), at(b));
        // The coordinates of a scene are finite: there's always an order, in which -0 equals 0.
        let sign = a.partial_cmp(&b).map_or(Sign::Zero, Sign::from);
        (sign, stage::COMPARE)
    }

    /// [`Predicates::orient2d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex, or lacks an axis of the plane.
    #[inline]
    #[must_use]
    pub fn decide_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        let at = |v| self.point2(plane, v);
        let prepared = &self.orient2d[plane as usize];
        match Orient2d::estimate([at(a), at(b), at(c)]).above(prepared.static_bound) {
            Some(sign) => (sign, prepared.static_stage),
            None => self.climb_orient2d(plane, [a, b, c]),
        }
    }

    /// [`Predicates::orient3d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn decide_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3[v.index()];
        match Orient3d::estimate([at(a), at(b), at(c), at(d)]).above(self.orient3d.static_bound) {
            Some(sign) => (sign, self.orient3d.static_stage),
            None => self.climb_orient3d([a, b, c, d]),
        }
    }

    /// [`Predicates::incircle`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D.
    #[inline]
    #[must_use]
    pub fn decide_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points2[v.index()];
        match Incircle::estimate([at(a), at(b), at(c), at(d)]).above(self.incircle.static_bound) {
            Some(sign) => (sign, self.incircle.static_stage),
            None => self.climb_incircle([a, b, c, d]),
        }
    }

    /// [`Predicates::insphere`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn decide_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3[v.index()];
        match Insphere::estimate([at(a), at(b), at(c), at(d), at(e)]).above(self.insphere.static_bound) {
            Some(sign) => (sign, self.insphere.static_stage),
            None => self.climb_insphere([a, b, c, d, e]),
        }
    }

    // The cold paths take vertices and not points, so that the hot ones keep points in registers.

    #[cold]
    #[inline(never)]
    fn climb_orient2d(&self, plane: Plane, vertices: [Vertex; 3]) -> (Sign, usize) {
        self.orient2d[plane as usize].climb::<Orient2d, 2, 3>(vertices.map(|v| self.point2(plane, v)))
    }

    #[cold]
    #[inline(never)]
    fn climb_orient3d(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        self.orient3d.climb::<Orient3d, 3, 4>(vertices.map(|v| self.points3[v.index()]))
    }

    #[cold]
    #[inline(never)]
    fn climb_incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        self.incircle.climb::<Incircle, 2, 4>(vertices.map(|v| self.points2[v.index()]))
    }

    #[cold]
    #[inline(never)]
    fn climb_insphere(&self, vertices: [Vertex; 5]) -> (Sign, usize) {
        self.insphere.climb::<Insphere, 3, 5>(vertices.map(|v| self.points3[v.index()]))
    }

    #[inline(always)]
    fn point2(&self, plane: Plane, v: Vertex) -> [f64; 2] {
        match (self.scene.dimension(), plane) {
            (Dimension::Two, Plane::Xy) => self.points2[v.index()],
            (_, plane) => {
                let point = self.points3[v.index()];
                plane.axes().map(|axis| point[axis.index()])
            }
        }
    }

    fn counter(&self, kind: PredicateKind) -> impl FnMut(usize, u64) {
        move |stage, count| self.tally.settled_many(kind, stage, count)
    }

    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.scene
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

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        if self.scene.dimension() == Dimension::Two {
            let prepared = &self.orient2d[plane as usize];
            batch::by_index::<Orient2d, 2, 3>(prepared, self.points2, queries, out, self.counter(PredicateKind::Orient2d));
        } else {
            for (&[a, b, c], out) in queries.iter().zip(out) {
                *out = self.orient2d(plane, a, b, c);
            }
        }
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let settled = self.counter(PredicateKind::Orient3d);
        batch::by_index::<Orient3d, 3, 4>(&self.orient3d, self.points3, queries, out, settled);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let settled = self.counter(PredicateKind::Incircle);
        batch::by_index::<Incircle, 2, 4>(&self.incircle, self.points2, queries, out, settled);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let settled = self.counter(PredicateKind::Insphere);
        batch::by_index::<Insphere, 3, 5>(&self.insphere, self.points3, queries, out, settled);
    }
}
