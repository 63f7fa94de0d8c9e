//! A scene, prepared: which arithmetic its exponents allow, predicate by predicate.

use predicament_arithmetic::{Plan, Regime};
use predicament_predicates::{Axis, Dimension, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex};

use crate::{filter, form, form::Determinant, ladder, stage};

/// What the scene's plan proves for one determinant, with the filter's bound
/// at hand: the fast path reads nothing else.
#[derive(Clone, Copy)]
struct Prepared {
    bound: f64,
    regime: Regime,
}

impl Prepared {
    fn new(plan: &Plan, determinant: Determinant) -> Prepared {
        let regime = plan.regime(determinant.form);
        Prepared { bound: determinant.bound_in(regime), regime }
    }
}

/// The exact backend, prepared for one scene.
pub struct Session<'s, T> {
    scene: &'s Scene,
    tally: T,
    /// The scene's points, in the view of its dimension; the other one is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    orient2d: Prepared,
    orient3d: Prepared,
    incircle: Prepared,
    insphere: Prepared,
}

impl<'s, T: Tally> Session<'s, T> {
    pub(crate) fn new(scene: &'s Scene, tally: T) -> Session<'s, T> {
        let plan = Plan::of(scene.coordinates());
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        Session {
            scene,
            tally,
            points2,
            points3,
            orient2d: Prepared::new(&plan, form::ORIENT2D),
            orient3d: Prepared::new(&plan, form::ORIENT3D),
            incircle: Prepared::new(&plan, form::INCIRCLE),
            insphere: Prepared::new(&plan, form::INSPHERE),
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
        match filter::orient2d(at(a), at(b), at(c), self.orient2d.bound) {
            Some(sign) => (sign, stage::FILTER),
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
        match filter::orient3d(at(a), at(b), at(c), at(d), self.orient3d.bound) {
            Some(sign) => (sign, stage::FILTER),
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
        match filter::incircle(at(a), at(b), at(c), at(d), self.incircle.bound) {
            Some(sign) => (sign, stage::FILTER),
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
        match filter::insphere(at(a), at(b), at(c), at(d), at(e), self.insphere.bound) {
            Some(sign) => (sign, stage::FILTER),
            None => self.climb_insphere([a, b, c, d, e]),
        }
    }

    // The cold paths take vertices and not points, so that the hot ones keep points in registers.

    #[cold]
    #[inline(never)]
    fn climb_orient2d(&self, plane: Plane, vertices: [Vertex; 3]) -> (Sign, usize) {
        ladder::orient2d(vertices.map(|v| self.point2(plane, v)), self.orient2d.regime)
    }

    #[cold]
    #[inline(never)]
    fn climb_orient3d(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        ladder::orient3d(vertices.map(|v| self.points3[v.index()]), self.orient3d.regime)
    }

    #[cold]
    #[inline(never)]
    fn climb_incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        ladder::incircle(vertices.map(|v| self.points2[v.index()]), self.incircle.regime)
    }

    #[cold]
    #[inline(never)]
    fn climb_insphere(&self, vertices: [Vertex; 5]) -> (Sign, usize) {
        ladder::insphere(vertices.map(|v| self.points3[v.index()]), self.insphere.regime)
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
}
