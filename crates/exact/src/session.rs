//! A scene, prepared: which arithmetic its exponents allow, predicate by predicate.

use predicament_arithmetic::Plan;
use predicament_predicates::{Axis, Declined, Dimension, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex};

use crate::batch::{self, Batch};
use crate::constructed::Constructed;
use crate::integers::Integers;
use crate::ladder::Prepared;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::stage;

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
    integers2: Integers<2>,
    integers3: Integers<3>,
    constructed: Constructed<'s>,
}

impl<'s, T: Tally> Session<'s, T> {
    pub(crate) fn new(scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
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
        Ok(Session {
            scene,
            tally,
            constructed: Constructed::new(scene)?,
            points2,
            points3,
            orient2d,
            orient3d: Prepared::new::<Orient3d, 3, 4>(&solid),
            incircle: Prepared::new::<Incircle, 2, 4>(&flat),
            insphere: Prepared::new::<Insphere, 3, 5>(&solid),
            integers2: Integers::new(&flat, points2),
            integers3: Integers::new(&solid, points3),
        })
    }

    /// The scene's constructed vertices.
    #[must_use]
    pub fn constructed(&self) -> &Constructed<'s> {
        &self.constructed
    }

    /// [`Predicates::compare`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or axis.
    #[inline]
    #[must_use]
    pub fn decide_compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| match self.scene.dimension() {
            Dimension::Two => self.points2.get(v.index()).map(|p| p[axis.index()]),
            Dimension::Three => self.points3.get(v.index()).map(|p| p[axis.index()]),
        };
        let (Some(x), Some(y)) = (at(a), at(b)) else { return self.compare_constructed(axis, [a, b]) };
        // The coordinates of a scene are finite: there's always an order, in which -0 equals 0.
        let sign = x.partial_cmp(&y).map_or(Sign::Zero, Sign::from);
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
        if let (Some(a), Some(b), Some(c)) = (at(a), at(b), at(c)) {
            let estimate = Orient2d::estimate([a, b, c]);
            if let Some(sign) = estimate.above(prepared.static_bound) {
                return (sign, prepared.static_stage);
            }
            // Here the second filter costs less than the call.
            if let Some(sign) = estimate.certain(prepared.semi_static_bound) {
                return (sign, stage::SEMI_STATIC);
            }
        }
        self.climb_orient2d(plane, [a, b, c])
    }

    /// [`Predicates::orient3d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn decide_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d))
            && let Some(sign) = Orient3d::estimate([*a, *b, *c, *d]).above(self.orient3d.static_bound)
        {
            return (sign, self.orient3d.static_stage);
        }
        self.climb_orient3d([a, b, c, d])
    }

    /// [`Predicates::incircle`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D, or if one is constructed.
    #[inline]
    #[must_use]
    pub fn decide_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points2.get(v.index());
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d))
            && let Some(sign) = Incircle::estimate([*a, *b, *c, *d]).above(self.incircle.static_bound)
        {
            return (sign, self.incircle.static_stage);
        }
        self.climb_incircle([a, b, c, d])
    }

    /// [`Predicates::insphere`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D, or if one is constructed.
    #[inline]
    #[must_use]
    pub fn decide_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        if let (Some(a), Some(b), Some(c), Some(d), Some(e)) = (at(a), at(b), at(c), at(d), at(e))
            && let Some(sign) = Insphere::estimate([*a, *b, *c, *d, *e]).above(self.insphere.static_bound)
        {
            return (sign, self.insphere.static_stage);
        }
        self.climb_insphere([a, b, c, d, e])
    }

    // The cold paths take vertices and not points, so that the hot ones keep points in registers.
    // A vertex that is no input vertex gets here because its index is beyond all points.

    #[cold]
    #[inline(never)]
    fn compare_constructed(&self, axis: Axis, [a, b]: [Vertex; 2]) -> (Sign, usize) {
        self.constructed.compare(axis, a, b)
    }

    #[cold]
    #[inline(never)]
    fn climb_orient2d(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> (Sign, usize) {
        if self.scene.dimension() == Dimension::Three {
            return self.climb_projected(plane, [a, b, c]);
        }
        let at = |v: Vertex| self.points2.get(v.index());
        match (at(a), at(b), at(c)) {
            (Some(p), Some(q), Some(r)) => {
                let rows = || self.integers2.rows([0, 1], [a.index(), b.index(), c.index()]);
                self.orient2d[plane as usize].climb::<Orient2d, 2, 3>([*p, *q, *r], rows)
            }
            _ => self.constructed.orient2d(plane, a, b, c),
        }
    }

    #[inline(never)]
    fn climb_projected(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> (Sign, usize) {
        let at = |v| self.point2(plane, v);
        match (at(a), at(b), at(c)) {
            (Some(p), Some(q), Some(r)) => {
                let axes = plane.axes().map(Axis::index);
                let rows = || self.integers3.rows(axes, [a.index(), b.index(), c.index()]);
                self.orient2d[plane as usize].climb::<Orient2d, 2, 3>([p, q, r], rows)
            }
            _ => self.constructed.orient2d(plane, a, b, c),
        }
    }

    #[cold]
    #[inline(never)]
    fn climb_orient3d(&self, [a, b, c, d]: [Vertex; 4]) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        match (at(a), at(b), at(c), at(d)) {
            (Some(p), Some(q), Some(r), Some(s)) => {
                let rows = || self.integers3.rows([0, 1, 2], [a.index(), b.index(), c.index(), d.index()]);
                self.orient3d.climb::<Orient3d, 3, 4>([*p, *q, *r, *s], rows)
            }
            _ => self.constructed.orient3d(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn climb_incircle(&self, [a, b, c, d]: [Vertex; 4]) -> (Sign, usize) {
        let at = |v: Vertex| self.points2[v.index()];
        let rows = || self.integers2.rows([0, 1], [a.index(), b.index(), c.index(), d.index()]);
        self.incircle.climb::<Incircle, 2, 4>([at(a), at(b), at(c), at(d)], rows)
    }

    #[cold]
    #[inline(never)]
    fn climb_insphere(&self, [a, b, c, d, e]: [Vertex; 5]) -> (Sign, usize) {
        let at = |v: Vertex| self.points3[v.index()];
        let rows = || self.integers3.rows([0, 1, 2], [a.index(), b.index(), c.index(), d.index(), e.index()]);
        self.insphere.climb::<Insphere, 3, 5>([at(a), at(b), at(c), at(d), at(e)], rows)
    }

    #[inline(always)]
    fn point2(&self, plane: Plane, v: Vertex) -> Option<[f64; 2]> {
        match (self.scene.dimension(), plane) {
            (Dimension::Two, Plane::Xy) => self.points2.get(v.index()).copied(),
            (_, plane) => {
                let point = self.points3.get(v.index())?;
                let [x, y] = plane.axes();
                Some([point[x.index()], point[y.index()]])
            }
        }
    }

    #[inline]
    fn batch<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        prepared: &Prepared,
        points: &[[f64; D]],
        queries: &[[Vertex; N]],
        out: &mut [Sign],
        climb: impl Fn(&[Vertex; N]) -> (Sign, usize),
    ) {
        batch::run::<P, _, D, N>(Batch {
            bounds: [prepared.static_bound, prepared.semi_static_bound],
            queries,
            out,
            // With NaN nothing is certain, and the vertex is seen to where it climbs.
            point: |v: Vertex| points.get(v.index()).copied().unwrap_or([f64::NAN; D]),
            settled: |[by_static, by_semi_static]: [u64; 2]| {
                self.tally.settled_many(P::KIND, prepared.static_stage, by_static);
                self.tally.settled_many(P::KIND, stage::SEMI_STATIC, by_semi_static);
            },
            climb: |query: &[Vertex; N]| {
                let (sign, stage) = climb(query);
                self.tally.settled(P::KIND, stage);
                sign
            },
        });
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
            let climb = |query: &[Vertex; 3]| self.climb_orient2d(plane, *query);
            self.batch::<Orient2d, 2, 3>(&self.orient2d[plane as usize], self.points2, queries, out, climb);
        } else {
            for (&[a, b, c], out) in queries.iter().zip(out) {
                *out = self.orient2d(plane, a, b, c);
            }
        }
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |query: &[Vertex; 4]| self.climb_orient3d(*query);
        self.batch::<Orient3d, 3, 4>(&self.orient3d, self.points3, queries, out, climb);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |query: &[Vertex; 4]| self.climb_incircle(*query);
        self.batch::<Incircle, 2, 4>(&self.incircle, self.points2, queries, out, climb);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let climb = |query: &[Vertex; 5]| self.climb_insphere(*query);
        self.batch::<Insphere, 3, 5>(&self.insphere, self.points3, queries, out, climb);
    }
}
