//! The session of the control: the ladder of a [`Decider`](crate::decider::Decider), with one device left out.

use alloc::{boxed::Box, vec::Vec};
use predicament_arithmetic::{Plan, bound};
use predicament_predicates::{
    Axis, Construction, Declined, Dimension, Off, Plane, PredicateKind, Predicates, Refused, Scene, Sessions, Sign,
    Tally, Vertex,
};

use super::{BATCH, DOUBLES, INTEGERS, PLAN, SEMI_STATIC, STATIC, Without};
use crate::alone::alone;
use crate::batch::Settled;
use crate::decider::open::{Open, coincide, vanishes, zero_or_unknown};
use crate::first::{self, First, extents};
use crate::ladder::{Flat, Prepared, Solid};
use crate::once::Once;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::scene_integers::{Integers, scaled};
use crate::{Session, stage};

/// A session without one device, prepared for one scene.
pub struct WithoutSession<'s, T, const DEVICE: usize> {
    /// An exact session, for comparisons, constructed vertices and formulas.
    pub(super) exact: Session<'s, Off>,
    tally: T,
    pub(super) points2: &'s [[f64; 2]],
    pub(super) points3: &'s [[f64; 3]],
    /// The extent of the scene along each of its axes; NaN without the static filter.
    pub(super) extent2: [f64; 2],
    pub(super) extent3: [f64; 3],
    /// The scale that turns coordinates into integers, if integers come before any filter; else zero. By plane.
    pub(super) turn_scale: [f64; 3],
    pub(super) incircle: Filter,
    pub(super) orient3d: Filter,
    pub(super) insphere: Filter,
    flat: Once<Box<Flat>>,
    solid: Once<Box<Solid>>,
}

/// The filters of a predicate.
#[derive(Clone, Copy)]
pub(super) struct Filter {
    /// The bound of the static filter; NaN if there is none.
    pub bound: f64,
    /// True if queries run their own filters first.
    by_query: bool,
}

impl<'s, T: Tally, const DEVICE: usize> WithoutSession<'s, T, DEVICE> {
    /// True if the static filter runs: without preparation it has no bound.
    pub(super) const STATIC: bool = DEVICE != STATIC && DEVICE != PLAN;
    pub(super) const SEMI_STATIC: bool = DEVICE != SEMI_STATIC;
    const DOUBLES: bool = DEVICE != DOUBLES;

    pub(super) fn new(scene: &'s Scene, tally: T) -> Result<WithoutSession<'s, T, DEVICE>, Declined> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let (extent2, extent3) =
            if Self::STATIC { (extents(points2), extents(points3)) } else { ([f64::NAN; 2], [f64::NAN; 3]) };
        let [orient3d, insphere] = [bound::static_orient3d, bound::static_insphere].map(|of| first::bound(extent3, of));
        let mut session = WithoutSession {
            exact: Session::new(scene, Off)?,
            tally,
            points2,
            points3,
            extent2,
            extent3,
            turn_scale: [0.0; 3],
            incircle: Filter::of::<Incircle, 2, 4>(points2, first::bound(extent2, bound::static_incircle)),
            orient3d: Filter::of::<Orient3d, 3, 4>(points3, orient3d),
            insphere: Filter::of::<Insphere, 3, 5>(points3, insphere),
            flat: Once::new(),
            solid: Once::new(),
        };
        if DEVICE != PLAN && DEVICE != INTEGERS {
            session.turn_scale = session.scales();
        }
        Ok(session)
    }

    fn scales(&self) -> [f64; 3] {
        if first::leaves_much::<Orient2d, 2, 3>(self.points2.len(), |at| self.points2[at]) {
            return [self.flat().orient2d.scale, 0.0, 0.0];
        }
        [Plane::Xy, Plane::Yz, Plane::Zx].map(|plane| {
            let axes = plane.axes().map(Axis::index);
            let seen = |at: usize| axes.map(|axis| self.points3[at][axis]);
            let leaves_much = first::leaves_much::<Orient2d, 2, 3>(self.points3.len(), seen);
            if leaves_much { self.solid().orient2d[plane as usize].scale } else { 0.0 }
        })
    }

    fn flat(&self) -> &Flat {
        self.flat.get_or_init(|| {
            let plan = Plan::of(self.points2);
            Box::new(Flat {
                orient2d: Self::prepared::<Orient2d, 2, 3>(&plan),
                incircle: Self::prepared::<Incircle, 2, 4>(&plan),
                integers: Self::integers::<Incircle, 2, 4>(&plan, self.points2),
            })
        })
    }

    fn solid(&self) -> &Solid {
        self.solid.get_or_init(|| {
            let plan = Plan::of(self.points3);
            let of_plane =
                |plane: Plane| Self::prepared::<Orient2d, 2, 3>(&plan.project(plane.axes().map(Axis::index)));
            Box::new(Solid {
                orient2d: [Plane::Xy, Plane::Yz, Plane::Zx].map(of_plane),
                orient3d: Self::prepared::<Orient3d, 3, 4>(&plan),
                insphere: Self::prepared::<Insphere, 3, 5>(&plan),
                integers: Self::integers::<Insphere, 3, 5>(&plan, self.points3),
            })
        })
    }

    fn prepared<P: Predicate<D, N>, const D: usize, const N: usize>(plan: &Plan<D>) -> Prepared {
        let mut prepared = Prepared::after::<P, D, N>(plan, Self::SEMI_STATIC);
        if !Self::DOUBLES {
            prepared.static_stage = stage::STATIC;
        }
        if DEVICE == INTEGERS {
            prepared.scale = 0.0;
        }
        prepared
    }

    /// The stored integers, if doubles do not suffice for the predicate of the highest degree.
    fn integers<P: Predicate<D, N>, const D: usize, const N: usize>(
        plan: &Plan<D>,
        points: &[[f64; D]],
    ) -> Integers<D> {
        let is_double = Self::prepared::<P, D, N>(plan).is_double();
        if is_double || DEVICE == INTEGERS { Integers::None } else { Integers::new(plan, points) }
    }

    /// The sign of a query that the filters have left open.
    #[inline(always)]
    fn exactly<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        prepared: &Prepared,
        points: &[[f64; D]; N],
        integers: (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> (Sign, usize) {
        if DEVICE == INTEGERS && !prepared.is_double() {
            return (P::dyadic(*points), stage::DYADIC);
        }
        prepared.exactly::<P, D, N, E>(points, integers)
    }

    #[inline(always)]
    fn without_plan<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[f64; D]; N]) -> (Sign, usize) {
        alone::<P, D, N>(points).expect("the coordinates of a scene are finite")
    }

    pub(super) fn decide_orient2d(&self, plane: Plane, vertices: [Vertex; 3]) -> (Sign, usize) {
        self.turned::<false>(plane, vertices)
    }

    /// The turn, also if a batch's filters have left it open.
    #[inline(always)]
    pub(super) fn turned<const OPEN: bool>(&self, plane: Plane, vertices: [Vertex; 3]) -> (Sign, usize) {
        let axes = plane.axes().map(Axis::index);
        if plane == Plane::Xy
            && let Some(points) = points(self.points2, vertices)
        {
            let plan = || (&self.flat().orient2d, &self.flat().integers);
            return self.turn::<2, OPEN>(plane, &points, [0, 1], vertices, plan);
        }
        let Some(points) = points(self.points3, vertices) else {
            let [a, b, c] = vertices;
            return self.exact.decide_orient2d(plane, a, b, c);
        };
        let plan = || (&self.solid().orient2d[plane as usize], &self.solid().integers);
        self.turn::<3, OPEN>(plane, &points.map(|point| axes.map(|axis| point[axis])), axes, vertices, plan)
    }

    #[inline(always)]
    fn turn<'a, const E: usize, const OPEN: bool>(
        &self,
        plane: Plane,
        points: &[[f64; 2]; 3],
        axes: [usize; 2],
        vertices: [Vertex; 3],
        plan: impl Fn() -> (&'a Prepared, &'a Integers<E>),
    ) -> (Sign, usize) {
        if self.turn_scale[plane as usize] != 0.0 {
            return (Orient2d::integer(scaled(points, self.turn_scale[plane as usize]), 2), stage::INTEGER);
        }
        if Self::SEMI_STATIC
            && !OPEN
            && let Some(sign) = Orient2d::anywhere(*points).certain()
        {
            return (sign, stage::SEMI_STATIC);
        }
        if DEVICE == PLAN {
            return Self::without_plan::<Orient2d, 2, 3>(points);
        }
        if Self::DOUBLES && (vertices[0] == vertices[1] || vanishes(*points)) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let (prepared, integers) = plan();
        Self::exactly::<Orient2d, 2, 3, E>(prepared, points, (integers, axes, vertices))
    }

    pub(super) fn decide_orient3d(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        let Some(points) = points(self.points3, vertices) else {
            let [a, b, c, d] = vertices;
            return self.exact.decide_orient3d(a, b, c, d);
        };
        self.filtered::<Orient3d, 3, 4>(self.orient3d, &points, |determinant| self.open_orient3d(determinant, vertices))
    }

    pub(super) fn decide_incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        let Some(points) = points(self.points2, vertices) else {
            let [a, b, c, d] = vertices;
            return self.exact.decide_incircle(a, b, c, d);
        };
        self.filtered::<Incircle, 2, 4>(self.incircle, &points, |determinant| self.open_incircle(determinant, vertices))
    }

    pub(super) fn decide_insphere(&self, vertices: [Vertex; 5]) -> (Sign, usize) {
        let Some(points) = points(self.points3, vertices) else {
            let [a, b, c, d, e] = vertices;
            return self.exact.decide_insphere(a, b, c, d, e);
        };
        self.filtered::<Insphere, 3, 5>(self.insphere, &points, |determinant| self.open_insphere(determinant, vertices))
    }

    /// The sign by the first filter, else by `open`, which takes the static filter's determinant, or zero or NaN.
    #[inline(always)]
    fn filtered<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        filter: Filter,
        points: &[[f64; D]; N],
        open: impl Fn(f64) -> (Sign, usize),
    ) -> (Sign, usize) {
        if !Self::STATIC || (Self::SEMI_STATIC && filter.by_query) {
            let bounded = P::anywhere(*points);
            return match bounded.certain() {
                Some(sign) => (sign, stage::SEMI_STATIC),
                None => open(zero_or_unknown(bounded.determinant)),
            };
        }
        let estimate = P::estimate(*points);
        match estimate.above(filter.bound) {
            Some(sign) => (sign, stage::STATIC),
            None => open(estimate.determinant),
        }
    }

    #[cold]
    #[inline(never)]
    pub(super) fn open_orient3d(&self, determinant: f64, vertices: [Vertex; 4]) -> (Sign, usize) {
        let Some(points) = points(self.points3, vertices) else {
            let [a, b, c, d] = vertices;
            return self.exact.decide_orient3d(a, b, c, d);
        };
        let known = || self.solid.get().is_some_and(|plan| plan.orient3d.is_double());
        let plan = || (&self.solid().orient3d, &self.solid().integers);
        self.open::<Orient3d, 3, 4>(determinant, self.orient3d, (&points, vertices), known, plan)
    }

    #[cold]
    #[inline(never)]
    pub(super) fn open_incircle(&self, determinant: f64, vertices: [Vertex; 4]) -> (Sign, usize) {
        let Some(points) = points(self.points2, vertices) else {
            let [a, b, c, d] = vertices;
            return self.exact.decide_incircle(a, b, c, d);
        };
        let known = || self.flat.get().is_some_and(|plan| plan.incircle.is_double());
        let plan = || (&self.flat().incircle, &self.flat().integers);
        self.open::<Incircle, 2, 4>(determinant, self.incircle, (&points, vertices), known, plan)
    }

    #[cold]
    #[inline(never)]
    pub(super) fn open_insphere(&self, determinant: f64, vertices: [Vertex; 5]) -> (Sign, usize) {
        let points = vertices.map(|v| self.points3[v.index()]);
        let known = || self.solid.get().is_some_and(|plan| plan.insphere.is_double());
        let plan = || (&self.solid().insphere, &self.solid().integers);
        self.open::<Insphere, 3, 5>(determinant, self.insphere, (&points, vertices), known, plan)
    }

    /// The sign of a query that its first filter leaves open.
    #[inline(always)]
    fn open<'a, P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        determinant: f64,
        filter: Filter,
        (points, vertices): (&[[f64; D]; N], [Vertex; N]),
        is_known_double: impl Fn() -> bool,
        plan: impl Fn() -> (&'a Prepared, &'a Integers<D>),
    ) -> (Sign, usize) {
        if DEVICE == PLAN {
            return Self::without_plan::<P, D, N>(points);
        }
        if Self::DOUBLES && determinant == 0.0 && is_known_double() {
            return (Sign::Zero, stage::DOUBLE);
        }
        let open = Open { determinant, static_bound: filter.bound };
        let is_blank = determinant.is_nan() || determinant == 0.0;
        if is_blank && Self::DOUBLES && coincide(points, vertices) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let is_early = !is_blank && open.is_small();
        if Self::SEMI_STATIC
            && is_early
            && let Some(sign) = P::anywhere(*points).certain()
        {
            return (sign, stage::SEMI_STATIC);
        }
        let (prepared, integers) = plan();
        if Self::DOUBLES && prepared.scale == 0.0 && open.is_exact_zero::<P, D, N>(points) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let is_late = !is_blank && !is_early && prepared.scale == 0.0;
        if Self::SEMI_STATIC
            && is_late
            && let Some(sign) = P::anywhere(*points).certain()
        {
            return (sign, stage::SEMI_STATIC);
        }
        Self::exactly::<P, D, N, D>(prepared, points, (integers, core::array::from_fn(|axis| axis), vertices))
    }

    /// Returns true if doubles make no error in this predicate, in the turn's plane.
    pub(super) fn is_double(&self, kind: PredicateKind, plane: Plane) -> bool {
        match (kind, self.points2.is_empty()) {
            (PredicateKind::Orient2d, false) => self.flat().orient2d.is_double(),
            (PredicateKind::Orient2d, true) => self.solid().orient2d[plane as usize].is_double(),
            (PredicateKind::Incircle, _) => self.flat().incircle.is_double(),
            (PredicateKind::Orient3d, _) => self.solid().orient3d.is_double(),
            _ => self.solid().insphere.is_double(),
        }
    }

    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }

    fn tally_all(&self, kind: PredicateKind, settled: Settled) {
        let some = settled.into_iter().enumerate().filter(|&(_, count)| count > 0);
        some.for_each(|(stage, count)| self.tally.settled_many(kind, stage, count));
    }
}

impl Filter {
    fn of<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[f64; D]], bound: f64) -> Filter {
        Filter { bound, by_query: first::choose::<P, D, N>(points, bound) == First::Query }
    }
}

/// The points of these vertices; `None` if one is constructed.
#[inline(always)]
fn points<const D: usize, const N: usize>(of: &[[f64; D]], vertices: [Vertex; N]) -> Option<[[f64; D]; N]> {
    let mut points = [[0.0; D]; N];
    for (point, vertex) in points.iter_mut().zip(vertices) {
        *point = *of.get(vertex.index())?;
    }
    Some(points)
}

/// Answers a batch by the method of this name without a tally, or one by one without batches.
macro_rules! batch {
    ($self:ident, $kind:ident, $queries:ident, $out:ident, $decide:expr, $batch:expr) => {{
        let settled = if DEVICE == BATCH { crate::decider::batches::singly($queries, $out, $decide) } else { $batch };
        $self.tally_all(PredicateKind::$kind, settled);
    }};
}

impl<T: Tally, const DEVICE: usize> Predicates for WithoutSession<'_, T, DEVICE> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.exact.construct(definitions)
    }

    #[cfg(feature = "formulas")]
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.exact.supports(kind)
    }

    #[cfg(feature = "formulas")]
    fn sign(&self, predicate: predicament_predicates::Derived, vertices: &[Vertex]) -> Sign {
        self.tallied(PredicateKind::Derived(predicate), self.exact.decide_derived(predicate, vertices))
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Without::<DEVICE>)
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tallied(PredicateKind::Compare, self.exact.decide_compare(axis, a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient2d, self.decide_orient2d(plane, [a, b, c]))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Orient3d, self.decide_orient3d([a, b, c, d]))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tallied(PredicateKind::Incircle, self.decide_incircle([a, b, c, d]))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tallied(PredicateKind::Insphere, self.decide_insphere([a, b, c, d, e]))
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        let decide = |&[a, b]: &[Vertex; 2]| self.exact.decide_compare(axis, a, b);
        batch!(self, Compare, queries, out, decide, self.compares(axis, queries, out));
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        let decide = |&query: &[Vertex; 3]| self.decide_orient2d(plane, query);
        batch!(self, Orient2d, queries, out, decide, self.turns(plane, queries, out));
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        let decide = |&c: &Vertex| self.decide_orient2d(plane, [line[0], line[1], c]);
        batch!(self, Orient2d, points, out, decide, self.beside_line(plane, line, points, out));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let decide = |&query: &[Vertex; 4]| self.decide_orient3d(query);
        batch!(self, Orient3d, queries, out, decide, self.orients(queries, out));
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        let decide = |&d: &Vertex| self.decide_orient3d([plane[0], plane[1], plane[2], d]);
        batch!(self, Orient3d, points, out, decide, self.beside_plane(plane, points, out));
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let decide = |&query: &[Vertex; 4]| self.decide_incircle(query);
        batch!(self, Incircle, queries, out, decide, self.circles(queries, out));
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let decide = |&query: &[Vertex; 5]| self.decide_insphere(query);
        batch!(self, Insphere, queries, out, decide, self.spheres(queries, out));
    }
}
