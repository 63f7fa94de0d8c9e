//! A scene, prepared: which arithmetic its exponents allow, predicate by predicate.

use predicament_arithmetic::Plan;
use predicament_predicates::{
    Axis, Construction, Declined, Dimension, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign, Tally,
    Vertex,
};

use crate::Exact;
use crate::batch::{self, Along, Batch, Sweep, View, Whole, Xy, Yz, Zx};
use crate::constructed::Constructed;
use crate::integers::Integers;
use crate::ladder::Prepared;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::side::Side;
use crate::stage;

/// The exact backend, prepared for one scene.
pub struct Session<'s, T> {
    /// With the vertices that were constructed since.
    scene: Scene,
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
    /// How far the scene extends along each of its axes.
    extent2: [f64; 2],
    extent3: [f64; 3],
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
        let orient3d = Prepared::new::<Orient3d, 3, 4>(&solid);
        let incircle = Prepared::new::<Incircle, 2, 4>(&flat);
        let insphere = Prepared::new::<Insphere, 3, 5>(&solid);
        // If doubles do for the predicate of the highest degree, they do for all.
        let integers2 = if incircle.is_double() { Integers::NONE } else { Integers::new(&flat, points2) };
        let integers3 = if insphere.is_double() { Integers::NONE } else { Integers::new(&solid, points3) };
        Ok(Session {
            scene: scene.clone(),
            tally,
            constructed: Constructed::new(scene)?,
            points2,
            points3,
            orient2d,
            orient3d,
            incircle,
            insphere,
            integers2,
            integers3,
            extent2: flat.axes().map(|axis| axis.extent()),
            extent3: solid.axes().map(|axis| axis.extent()),
        })
    }

    /// [`Predicates::construct`], where a session that stands on this one has
    /// conditions of its own: each definition that is new, in canonical form,
    /// has to be one that it `accepts`.
    ///
    /// # Errors
    /// As [`Predicates::construct`], with what `accepts` says for a reason.
    pub fn construct_where(
        &mut self,
        definitions: &[Construction],
        accepts: impl Fn(&Construction) -> Result<(), String>,
    ) -> Result<Vec<Vertex>, Refused> {
        let (constructed, before) = (&mut self.constructed, self.scene.constructions().len());
        let vertices = self.scene.construct_all(definitions, |scene, vertex| {
            let construction = scene.construction(vertex).expect("just constructed");
            accepts(construction)?;
            constructed.push(construction).map_err(str::to_owned)
        });
        if vertices.is_err() {
            constructed.truncate(before);
        }
        vertices
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
        const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
        (SIGNS[usize::from(x >= y) + usize::from(x > y)], stage::COMPARE)
    }

    /// [`Predicates::orient2d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex, or lacks an axis of the plane.
    #[inline(always)]
    #[must_use]
    pub fn decide_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        // Two products of one limb cost no more than a filter, and leave nothing open.
        if plane == Plane::Xy
            && let Some(rows) = self.integers2.of_scene([0, 1], [a, b, c])
        {
            return (Orient2d::integer(rows, 2), stage::INTEGER);
        }
        // A projection: where the plane is a constant, so are the places of coordinates.
        let at = |v: Vertex| self.points3.get(v.index());
        if let (Some(a), Some(b), Some(c)) = (at(a), at(b), at(c)) {
            let prepared = &self.orient2d[plane as usize];
            let [i, j] = plane.axes().map(Axis::index);
            let points = [[a[i], a[j]], [b[i], b[j]], [c[i], c[j]]];
            let estimate = Orient2d::estimate(points);
            if let Some(sign) = estimate.above(prepared.static_bound) {
                return (sign, prepared.static_stage);
            }
            if estimate.determinant == 0.0 && vanishes(points) {
                return (Sign::Zero, stage::DOUBLE);
            }
        }
        self.next_orient2d(plane, a, b, c)
    }

    /// [`Predicates::orient3d`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D.
    #[inline]
    #[must_use]
    pub fn decide_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d)) {
            let estimate = Orient3d::estimate([*a, *b, *c, *d]);
            if let Some(sign) = estimate.above(self.orient3d.static_bound) {
                return (sign, self.orient3d.static_stage);
            }
            determinant = estimate.determinant;
        }
        self.next_orient3d(determinant, a, b, c, d)
    }

    /// [`Session::decide_orient3d`] where the static filter decides, or doubles make no error; else none.
    ///
    /// # Panics
    /// If the scene is 2D.
    #[inline]
    #[must_use]
    pub fn filter_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Option<(Sign, usize)> {
        let at = |v: Vertex| self.points3.get(v.index());
        let sign = Orient3d::estimate([*at(a)?, *at(b)?, *at(c)?, *at(d)?]).above(self.orient3d.static_bound)?;
        Some((sign, self.orient3d.static_stage))
    }

    /// [`Predicates::incircle`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 3D.
    #[inline]
    #[must_use]
    pub fn decide_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points2.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d)) {
            let estimate = Incircle::estimate([*a, *b, *c, *d]);
            if let Some(sign) = estimate.above(self.incircle.static_bound) {
                return (sign, self.incircle.static_stage);
            }
            determinant = estimate.determinant;
        }
        self.next_incircle(determinant, a, b, c, d)
    }

    /// [`Predicates::insphere`] and the stage that settled it, not tallied.
    ///
    /// # Panics
    /// If the scene has no such vertex or is 2D, or if one is constructed.
    #[inline]
    #[must_use]
    pub fn decide_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d), Some(e)) = (at(a), at(b), at(c), at(d), at(e)) {
            let estimate = Insphere::estimate([*a, *b, *c, *d, *e]);
            if let Some(sign) = estimate.above(self.insphere.static_bound) {
                return (sign, self.insphere.static_stage);
            }
            determinant = estimate.determinant;
        }
        self.next_insphere(determinant, [a, b, c, d, e])
    }

    // The cold paths take vertices and not points, so that the hot ones keep points in registers.
    // A vertex that is no input vertex gets here because its index is beyond all points.

    #[cold]
    #[inline(never)]
    fn compare_constructed(&self, axis: Axis, [a, b]: [Vertex; 2]) -> (Sign, usize) {
        self.constructed.compare(axis, a, b)
    }

    /// In scenes of more bits, in projections, and where there are no integers: the static filter first, which needs nothing
    /// but the points.
    #[inline(never)]
    fn next_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        // (No vertex of a 2D scene is among the points of a 3D one, and the other way round.)
        let at = |v: Vertex| self.points2.get(v.index());
        if plane == Plane::Xy
            && let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c))
        {
            let points = [*p, *q, *r];
            if let Some(decided) = self.filter_orient2d(plane, points) {
                return decided;
            }
            return match self.integers2.of_query(&points, [a, b, c]) {
                Some((rows, _)) => (Orient2d::integer(rows, 2), stage::INTEGER),
                None => self.climb_orient2d(plane, [a, b, c]),
            };
        }
        let at = |v| self.point2(plane, v);
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return self.constructed.orient2d(plane, a, b, c);
        };
        if let Some(decided) = self.filter_orient2d(plane, [p, q, r]) {
            return decided;
        }
        if let Some(rows) = self.integers3.of_scene(plane.axes().map(Axis::index), [a, b, c]) {
            return (Orient2d::integer(rows, 2), stage::INTEGER);
        }
        match self.integers3.of_query(&[p, q, r], [a, b, c]) {
            Some((rows, _)) => (Orient2d::integer(rows, 2), stage::INTEGER),
            None => self.climb_orient2d(plane, [a, b, c]),
        }
    }

    /// The sign, where the static filter or a difference of zero tells it.
    #[inline(always)]
    fn filter_orient2d(&self, plane: Plane, points: [[f64; 2]; 3]) -> Option<(Sign, usize)> {
        let prepared = &self.orient2d[plane as usize];
        let estimate = Orient2d::estimate(points);
        if let Some(sign) = estimate.above(prepared.static_bound) {
            return Some((sign, prepared.static_stage));
        }
        (estimate.determinant == 0.0 && vanishes(points)).then_some((Sign::Zero, stage::DOUBLE))
    }

    #[cold]
    #[inline(never)]
    fn climb_orient2d(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> (Sign, usize) {
        let at = |v| self.point2(plane, v);
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return self.constructed.orient2d(plane, a, b, c);
        };
        let (points, prepared) = ([p, q, r], &self.orient2d[plane as usize]);
        match self.scene.dimension() {
            Dimension::Two => prepared.climb::<Orient2d, 2, 3, 2>(&points, (&self.integers2, [0, 1], [a, b, c])),
            Dimension::Three => {
                let axes = plane.axes().map(Axis::index);
                prepared.climb::<Orient2d, 2, 3, 3>(&points, (&self.integers3, axes, [a, b, c]))
            }
        }
    }

    // Vertices by themselves and not in arrays: these stay in registers.

    #[inline(never)]
    fn next_orient3d(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        if determinant == 0.0 || determinant.is_nan() {
            // A row of zeros, if the last point is where another one is.
            let at = |v: Vertex| self.points3.get(v.index());
            if let (Some(p), Some(q), Some(r), Some(last)) = (at(a), at(b), at(c), at(d))
                && [p, q, r].contains(&last)
            {
                return (Sign::Zero, stage::DOUBLE);
            }
        }
        let integers = (&self.integers3, [0, 1, 2], [a, b, c, d]);
        let next = self.orient3d.next::<Orient3d, 3, 4, 3>(determinant, integers);
        next.unwrap_or_else(|| self.climb_orient3d([a, b, c, d]))
    }

    #[inline(never)]
    fn next_incircle(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let integers = (&self.integers2, [0, 1], [a, b, c, d]);
        let next = self.incircle.next::<Incircle, 2, 4, 2>(determinant, integers);
        next.unwrap_or_else(|| self.climb_incircle([a, b, c, d]))
    }

    #[inline(never)]
    fn next_insphere(&self, determinant: f64, [a, b, c, d, e]: [Vertex; 5]) -> (Sign, usize) {
        let integers = (&self.integers3, [0, 1, 2], [a, b, c, d, e]);
        let next = self.insphere.next::<Insphere, 3, 5, 3>(determinant, integers);
        next.unwrap_or_else(|| self.climb_insphere([a, b, c, d, e]))
    }

    #[cold]
    #[inline(never)]
    fn climb_orient3d(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        let [a, b, c, d] = vertices;
        let at = |v: Vertex| self.points3.get(v.index());
        match (at(a), at(b), at(c), at(d)) {
            (Some(p), Some(q), Some(r), Some(s)) => {
                let integers = (&self.integers3, [0, 1, 2], vertices);
                self.orient3d.climb::<Orient3d, 3, 4, 3>(&[*p, *q, *r, *s], integers)
            }
            _ => self.constructed.orient3d(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn climb_incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        if vertices.iter().any(|v| v.is_constructed()) {
            return self.constructed.incircle(vertices);
        }
        let points = vertices.map(|v| self.points2[v.index()]);
        self.incircle.climb::<Incircle, 2, 4, 2>(&points, (&self.integers2, [0, 1], vertices))
    }

    #[cold]
    #[inline(never)]
    fn climb_insphere(&self, vertices: [Vertex; 5]) -> (Sign, usize) {
        let points = vertices.map(|v| self.points3[v.index()]);
        self.insphere.climb::<Insphere, 3, 5, 3>(&points, (&self.integers3, [0, 1, 2], vertices))
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
    fn batch<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        prepared: &Prepared,
        points: &[[f64; E]],
        (queries, out): (&[[Vertex; N]], &mut [Sign]),
        climb: impl Fn(&[Vertex; N]) -> (Sign, usize),
    ) {
        batch::run::<P, V, E, D, N>(Batch {
            bounds: [prepared.static_bound, prepared.semi_static_bound],
            points,
            queries,
            out,
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

    /// Where points lie beside a line or plane.
    #[inline]
    fn beside<P: Predicate<D, N>, V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        prepared: &Prepared,
        side: Side<D>,
        points: &[[f64; E]],
        (vertices, out): (&[Vertex], &mut [Sign]),
        climb: impl Fn(Vertex) -> (Sign, usize),
    ) {
        let bound = prepared.semi_static_bound * side.permanent;
        batch::sweep::<V, E, D, 1>(Sweep {
            evaluate: move |[point]: [[f64; D]; 1]| (side.determinant(point), bound),
            points,
            queries: vertices.as_chunks::<1>().0,
            out,
            settled: |count| self.tally.settled_many(P::KIND, prepared.static_stage, count),
            climb: |&[vertex]: &[Vertex; 1]| self.tallied(P::KIND, climb(vertex)),
        });
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

/// Whether both products of `orient2d` have a factor of zero. A difference of doubles is zero only if they are equal: then its product is zero,
/// and not rounded to it.
#[inline(always)]
fn vanishes([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> bool {
    ((ax == cx) | (by == cy)) & ((ay == cy) | (bx == cx))
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        &self.scene
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
        match (self.scene.dimension(), axis) {
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
        let climb = |&[a, b, c]: &[Vertex; 3]| self.decide_orient2d(plane, a, b, c);
        let prepared = &self.orient2d[plane as usize];
        let asked = (queries, out);
        match (self.scene.dimension(), plane) {
            (Dimension::Two, Plane::Xy) => {
                self.batch::<Orient2d, Whole, 2, 2, 3>(prepared, self.points2, asked, climb);
            }
            (_, Plane::Xy) => {
                self.batch::<Orient2d, Xy, 3, 2, 3>(prepared, self.points3, asked, climb);
            }
            (_, Plane::Yz) => {
                self.batch::<Orient2d, Yz, 3, 2, 3>(prepared, self.points3, asked, climb);
            }
            (_, Plane::Zx) => {
                self.batch::<Orient2d, Zx, 3, 2, 3>(prepared, self.points3, asked, climb);
            }
        }
    }

    fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        let (Some(p), Some(q)) = (self.point2(plane, a), self.point2(plane, b)) else {
            return points.iter().zip(out).for_each(|(&c, out)| *out = self.orient2d(plane, a, b, c));
        };
        let climb = |c: Vertex| self.decide_orient2d(plane, a, b, c);
        let prepared = &self.orient2d[plane as usize];
        let asked = (points, out);
        match (self.scene.dimension(), plane) {
            (Dimension::Two, _) => {
                let side = Side::of_line([p, q], self.extent2);
                self.beside::<Orient2d, Whole, 2, 2, 3>(prepared, side, self.points2, asked, climb);
            }
            (Dimension::Three, plane) => {
                let side = Side::of_line([p, q], plane.axes().map(|axis| self.extent3[axis.index()]));
                match plane {
                    Plane::Xy => self.beside::<Orient2d, Xy, 3, 2, 3>(prepared, side, self.points3, asked, climb),
                    Plane::Yz => self.beside::<Orient2d, Yz, 3, 2, 3>(prepared, side, self.points3, asked, climb),
                    Plane::Zx => self.beside::<Orient2d, Zx, 3, 2, 3>(prepared, side, self.points3, asked, climb),
                }
            }
        }
    }

    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return points.iter().zip(out).for_each(|(&d, out)| *out = self.orient3d(a, b, c, d));
        };
        let climb = |d: Vertex| self.next_orient3d(f64::NAN, a, b, c, d);
        let side = Side::of_plane([*p, *q, *r], self.extent3);
        self.beside::<Orient3d, Whole, 3, 3, 4>(&self.orient3d, side, self.points3, (points, out), climb);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.next_orient3d(f64::NAN, a, b, c, d);
        self.batch::<Orient3d, Whole, 3, 3, 4>(&self.orient3d, self.points3, (queries, out), climb);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let climb = |&[a, b, c, d]: &[Vertex; 4]| self.next_incircle(f64::NAN, a, b, c, d);
        self.batch::<Incircle, Whole, 2, 2, 4>(&self.incircle, self.points2, (queries, out), climb);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let climb = |query: &[Vertex; 5]| self.next_insphere(f64::NAN, *query);
        self.batch::<Insphere, Whole, 3, 3, 5>(&self.insphere, self.points3, (queries, out), climb);
    }
}
