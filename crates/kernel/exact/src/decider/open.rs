//! Queries that filters leave open: they climb to integers and beyond, or involve constructed vertices.
//!
//! These functions take vertices and not points, so that filters keep points in registers. The points have just been
//! read. A constructed vertex gets here because its index is beyond all points.

use predicament_arithmetic::power_of_two;
use predicament_predicates::{Axis, Dimension, Plane, Sign, Vertex};

use super::Decider;
use crate::few_bits::doubles_are_exact;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::scene_integers::scaled;
use crate::stage;

impl Decider<'_> {
    #[cold]
    #[inline(never)]
    pub(super) fn compare_constructed(&self, axis: Axis, [a, b]: [Vertex; 2]) -> (Sign, usize) {
        self.constructed.compare(axis, a, b)
    }

    #[inline(never)]
    pub(super) fn turn_in_integers(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        // (A vertex of a 2D scene is never among the points of a 3D scene.)
        if let Some((sign, _)) = self.turn_of_integers(a, b, c) {
            return (sign, stage::INTEGER);
        }
        let scale = self.turn_scale[plane as usize];
        let at = |v: Vertex| self.points3.get(v.index());
        if let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) {
            let [i, j] = plane.axes().map(Axis::index);
            let points = [[p[i], p[j]], [q[i], q[j]], [r[i], r[j]]];
            return (Orient2d::integer(scaled(&points, scale), 2), stage::INTEGER);
        }
        self.climb_orient2d(plane, a, b, c)
    }

    /// Answers a turn that its filter leaves open.
    #[inline(never)]
    pub(crate) fn climb_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points2.get(v.index());
        // (A vertex of a 2D scene is never among the points of a 3D scene, and vice versa.)
        if plane == Plane::Xy
            && let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c))
        {
            let points = [*p, *q, *r];
            if a == b || vanishes(points) {
                return (Sign::Zero, stage::DOUBLE);
            }
            let flat = self.flat();
            let integers = (&flat.integers, [0, 1], [a, b, c]);
            return flat.orient2d.exactly::<Orient2d, 2, 3, 2>(&points, integers);
        }
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r)) = (at(a), at(b), at(c)) else {
            return self.constructed.orient2d(plane, a, b, c);
        };
        let axes = plane.axes().map(Axis::index);
        let points = [p, q, r].map(|point| axes.map(|axis| point[axis]));
        if a == b || vanishes(points) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let solid = self.solid();
        let integers = (&solid.integers, axes, [a, b, c]);
        solid.orient2d[plane as usize].exactly::<Orient2d, 2, 3, 3>(&points, integers)
    }

    // Answers by the query's own filter, in scenes whose bounds are too large for most of their figures.
    // Such a scene has figures at scales of their own: a tie is looked for in doubles first.

    #[inline(never)]
    pub(super) fn orient3d_by_query(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d)) {
            let points = [*a, *b, *c, *d];
            let bounded = Orient3d::anywhere(points);
            if let Some(sign) = bounded.certain() {
                return (sign, stage::SEMI_STATIC);
            }
            if bounded.determinant == 0.0 && doubles_are_exact::<Orient3d, _, _>(&points) {
                return (Sign::Zero, stage::DOUBLE);
            }
            determinant = zero_or_unknown(bounded.determinant);
        }
        self.open_orient3d(determinant, a, b, c, d)
    }

    #[inline(never)]
    pub(super) fn incircle_by_query(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| self.points2.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d)) {
            let points = [*a, *b, *c, *d];
            let bounded = Incircle::anywhere(points);
            if let Some(sign) = bounded.certain() {
                return (sign, stage::SEMI_STATIC);
            }
            if bounded.determinant == 0.0 && doubles_are_exact::<Incircle, _, _>(&points) {
                return (Sign::Zero, stage::DOUBLE);
            }
            determinant = zero_or_unknown(bounded.determinant);
        }
        self.open_incircle(determinant, a, b, c, d)
    }

    #[inline(never)]
    pub(super) fn insphere_by_query(&self, [a, b, c, d, e]: [Vertex; 5]) -> (Sign, usize) {
        let at = |v: Vertex| self.points3.get(v.index());
        let mut determinant = f64::NAN;
        if let (Some(a), Some(b), Some(c), Some(d), Some(e)) = (at(a), at(b), at(c), at(d), at(e)) {
            let points = [*a, *b, *c, *d, *e];
            let bounded = Insphere::anywhere(points);
            if let Some(sign) = bounded.certain() {
                return (sign, stage::SEMI_STATIC);
            }
            if bounded.determinant == 0.0 && doubles_are_exact::<Insphere, _, _>(&points) {
                return (Sign::Zero, stage::DOUBLE);
            }
            determinant = zero_or_unknown(bounded.determinant);
        }
        self.open_insphere(determinant, [a, b, c, d, e])
    }

    // Answers a query that its filter leaves open.
    //
    // `determinant` is the static filter's value; if the query's own filter left it open, zero or NaN.

    #[cold]
    #[inline(never)]
    pub(crate) fn open_orient3d(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        // A tie if doubles make no error; once the plan is known, nothing else is needed.
        if determinant == 0.0 && self.solid.get().is_some_and(|plan| plan.orient3d.is_double()) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let at = |v: Vertex| self.points3.get(v.index());
        let (Some(p), Some(q), Some(r), Some(last)) = (at(a), at(b), at(c), at(d)) else {
            return self.constructed.orient3d(a, b, c, d);
        };
        let points = [*p, *q, *r, *last];
        let open = Open { determinant, static_bound: self.orient3d };
        if let Some(decided) = open.early::<Orient3d, 3, 4>(&points, [a, b, c, d]) {
            return decided;
        }
        let solid = self.solid();
        if let Some(decided) = open.late::<Orient3d, 3, 4>(&points, solid.orient3d.scale != 0.0) {
            return decided;
        }
        solid.orient3d.exactly::<Orient3d, 3, 4, 3>(&points, (&solid.integers, [0, 1, 2], [a, b, c, d]))
    }

    #[cold]
    #[inline(never)]
    pub(crate) fn open_incircle(&self, determinant: f64, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        // A tie if doubles make no error; once the plan is known, nothing else is needed.
        if determinant == 0.0 && self.flat.get().is_some_and(|plan| plan.incircle.is_double()) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let at = |v: Vertex| self.points2.get(v.index());
        let (Some(p), Some(q), Some(r), Some(last)) = (at(a), at(b), at(c), at(d)) else {
            return self.constructed_incircle([a, b, c, d]);
        };
        let points = [*p, *q, *r, *last];
        let open = Open { determinant, static_bound: self.incircle };
        if let Some(decided) = open.early::<Incircle, 2, 4>(&points, [a, b, c, d]) {
            return decided;
        }
        let flat = self.flat();
        if let Some(decided) = open.late::<Incircle, 2, 4>(&points, flat.incircle.scale != 0.0) {
            return decided;
        }
        flat.incircle.exactly::<Incircle, 2, 4, 2>(&points, (&flat.integers, [0, 1], [a, b, c, d]))
    }

    #[cold]
    #[inline(never)]
    pub(crate) fn open_insphere(&self, determinant: f64, vertices: [Vertex; 5]) -> (Sign, usize) {
        // A tie if doubles make no error; once the plan is known, nothing else is needed.
        if determinant == 0.0 && self.solid.get().is_some_and(|plan| plan.insphere.is_double()) {
            return (Sign::Zero, stage::DOUBLE);
        }
        let points = vertices.map(|v| self.points3[v.index()]);
        let open = Open { determinant, static_bound: self.insphere };
        if let Some(decided) = open.early::<Insphere, 3, 5>(&points, vertices) {
            return decided;
        }
        let solid = self.solid();
        if let Some(decided) = open.late::<Insphere, 3, 5>(&points, solid.insphere.scale != 0.0) {
            return decided;
        }
        solid.insphere.exactly::<Insphere, 3, 5, 3>(&points, (&solid.integers, [0, 1, 2], vertices))
    }

    #[cold]
    #[inline(never)]
    pub(super) fn constructed_incircle(&self, vertices: [Vertex; 4]) -> (Sign, usize) {
        assert!(self.constructed.scene().dimension() == Dimension::Two, "incircle needs a 2D scene");
        self.constructed.incircle(vertices)
    }
}

/// The determinant of a query's own filter, for the functions that answer what it leaves open.
///
/// Only a zero is passed on, because other values say that the query's own filter has not run.
#[inline(always)]
pub(crate) fn zero_or_unknown(determinant: f64) -> f64 {
    if determinant == 0.0 { 0.0 } else { f64::NAN }
}

/// A query that a filter has left open.
pub(crate) struct Open {
    /// The static filter's determinant; NaN or zero if the query's own filter has run.
    pub determinant: f64,
    /// The bound of the static filter.
    pub static_bound: f64,
}

impl Open {
    /// The sign if two points coincide, or by the query's own filter if that is likely to decide.
    ///
    /// Points coincide if a vertex is named twice or the last point equals another one.
    #[inline(always)]
    fn early<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]; N],
        vertices: [Vertex; N],
    ) -> Option<(Sign, usize)> {
        if self.determinant.is_nan() || self.determinant == 0.0 {
            return coincide(points, vertices).then_some((Sign::Zero, stage::DOUBLE));
        }
        if self.is_small() { self.by_query::<P, D, N>(points) } else { None }
    }

    /// The sign in doubles, if the scene's integers would not do as well: by the query's own filter, if it has not run.
    ///
    /// The filter must run before integers in units of the query. A determinant of zero it leaves open, and that is a
    /// tie if doubles make no error.
    #[inline(always)]
    fn late<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]; N],
        has_integers: bool,
    ) -> Option<(Sign, usize)> {
        if has_integers {
            return None;
        }
        if self.is_exact_zero::<P, D, N>(points) {
            return Some((Sign::Zero, stage::DOUBLE));
        }
        let is_asked = self.determinant.is_nan() || self.determinant == 0.0 || self.is_small();
        if is_asked { None } else { self.by_query::<P, D, N>(points) }
    }

    /// Returns true if the determinant is zero in doubles that make no error.
    #[inline(always)]
    pub fn is_exact_zero<P: Predicate<D, N>, const D: usize, const N: usize>(&self, points: &[[f64; D]; N]) -> bool {
        let is_zero = || self.determinant.is_nan() && P::estimate(*points).determinant == 0.0;
        (self.determinant == 0.0 || is_zero()) && doubles_are_exact::<P, D, N>(points)
    }

    #[inline(always)]
    fn by_query<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: &[[f64; D]; N],
    ) -> Option<(Sign, usize)> {
        P::anywhere(*points).certain().map(|sign| (sign, stage::SEMI_STATIC))
    }

    /// Returns true if a determinant probably belongs to a small figure.
    ///
    /// A small figure has equally small roundings. The alternative is a large determinant that has cancelled: its
    /// remainder is some hundred times smaller than the bound.
    #[inline(always)]
    pub fn is_small(&self) -> bool {
        const FRACTION: f64 = power_of_two(-20);
        self.determinant.abs() < FRACTION * self.static_bound
    }
}

/// Returns true if the last point is at the place of another one, or a vertex is named twice.
#[inline(always)]
pub(crate) fn coincide<const D: usize, const N: usize>(points: &[[f64; D]; N], vertices: [Vertex; N]) -> bool {
    // Two equal rows, or a row of zeros.
    let mut is_zero = points[..N - 1].contains(&points[N - 1]);
    for i in 1..N - 1 {
        for j in 0..i {
            is_zero |= vertices[i] == vertices[j];
        }
    }
    is_zero
}

/// Returns true if both products of `orient2d` have a factor of zero.
///
/// A difference of doubles is zero only if they are equal: then its product is zero, and not rounded to zero.
#[inline(always)]
pub(crate) fn vanishes([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> bool {
    ((ax == cx) | (by == cy)) & ((ay == cy) | (bx == cx))
}
