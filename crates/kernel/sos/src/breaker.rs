//! Tie breaking: the sign of a tie of the exact backend, and the stage that has found it.
//!
//! A breaker counts nothing, so it is one type, compiled once for all tallies of a [`Session`](crate::Session).

use predicament_exact::stage::{COMPARE, DOUBLE, INTEGER};
use predicament_exact::{Exact, Filtered};
use predicament_predicates::{
    Axis, Backend, Construction, Declined, Off, Plane, PredicateKind, Predicates, Question, Refused, Scene, Sign,
    Vertex,
};

use crate::batch::{Ties, break_all};
use crate::constructed::{self, Memo};
use crate::gradient::{self, INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D, first_nonzero, in_order, smallest_first};
use crate::lanes as many;
use crate::leading::{self, Decided, EDELSBRUNNER_MUCKE, PER_COORDINATE, Points};
use crate::{Scheme, stage};

/// The stage of a tie that the perturbation does not break: zero however the vertices move.
///
/// The exact backend's stage is counted for it.
pub(crate) const AS_EXACT: usize = usize::MAX;

/// The exact backend and a perturbation scheme.
pub(crate) struct Breaker<'s> {
    pub scheme: Scheme,
    pub exact: predicament_exact::Session<'s, Off>,
    pub points: Points<'s>,
    memo: Memo,
}

/// The answer of the leading terms of a turn; `None` if all are zero, or the smallest vertex occurs twice.
///
/// They are differences of two doubles, which have the right sign.
#[inline(always)]
fn leading_orient2d<const SCHEME: usize>(points: [&[f64; 2]; 3]) -> Option<(Sign, usize)> {
    let minors = gradient::orient2d(smallest_first(points)?.map(|point| *point));
    let (sign, place) = first_nonzero(in_order::<SCHEME, ORIENT2D, 2>(minors))?;
    Some((sign, stage::FIRST_TERM + place))
}

impl<'s> Breaker<'s> {
    pub fn new(scheme: Scheme, scene: &'s Scene) -> Result<Breaker<'s>, Declined> {
        if scheme != Scheme::PerCoordinate && !scene.constructions().is_empty() {
            return Err(Declined::scene(constructed::others_only()));
        }
        constructed::are_of_inputs(scene)?;
        Ok(Breaker { scheme, exact: Exact.prepare(scene, Off)?, points: Points::of(scene), memo: Memo::new(scene) })
    }

    pub fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        match self.scheme {
            Scheme::PerCoordinate => {
                let vertices = self.exact.construct_where(definitions, constructed::is_of_inputs);
                self.memo.grow(self.exact.scene());
                vertices
            }
            Scheme::EdelsbrunnerMucke => Err(Refused::session(constructed::others_only())),
        }
    }

    #[cold]
    #[inline(never)]
    pub fn compare_constructed(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        let decided = self.exact.decide_compare(axis, a, b);
        self.tied(decided, || self.tie_constructed(Question::Compare(axis), [a, b]))
    }

    /// The order of two input vertices of equal coordinates, by the one term of both lists.
    ///
    /// The vertex with the smaller index moves further.
    #[inline(always)]
    pub fn tie_compare(a: Vertex, b: Vertex) -> (Sign, usize) {
        (Sign::from(b.cmp(&a)), if a == b { COMPARE } else { stage::FIRST_TERM })
    }

    #[cold]
    #[inline(never)]
    fn tie_constructed<const N: usize>(&self, question: Question, args: [Vertex; N]) -> (Sign, usize) {
        match self.memo.decide(self.exact.scene(), question, args) {
            Some((sign, degree)) => (sign, stage::of_degree(degree)),
            None => (Sign::Zero, AS_EXACT),
        }
    }

    // Ties are broken out of line and take points in registers, which the exact backend's filter has read: answers
    // without ties need no stack for them. Most ties need none either. The others are left to a second function.

    #[inline(always)]
    pub fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        match (self.exact.filtered_orient2d(plane, a, b, c), self.scheme) {
            (Filtered::Settled(sign, stage), _) => (sign, stage),
            (Filtered::Left(zero, [p, q, r]), Scheme::PerCoordinate) => {
                self.left_orient2d::<PER_COORDINATE>(zero, p, q, r)
            }
            (Filtered::Left(zero, [p, q, r]), Scheme::EdelsbrunnerMucke) => {
                self.left_orient2d::<EDELSBRUNNER_MUCKE>(zero, p, q, r)
            }
            (Filtered::Unasked, Scheme::PerCoordinate) => self.turn::<PER_COORDINATE>(plane, a, b, c),
            (Filtered::Unasked, Scheme::EdelsbrunnerMucke) => self.turn::<EDELSBRUNNER_MUCKE>(plane, a, b, c),
        }
    }

    #[cold]
    #[inline(never)]
    fn left_orient2d<const SCHEME: usize>(
        &self,
        determinant: f64,
        p: &[f64; 2],
        q: &[f64; 2],
        r: &[f64; 2],
    ) -> (Sign, usize) {
        if determinant == 0.0
            && self.exact.is_known_double(PredicateKind::Orient2d)
            && let Some(broken) = leading_orient2d::<SCHEME>([p, q, r])
        {
            return broken;
        }
        let [a, b, c] = [p, q, r].map(|point| self.points.vertex2(point));
        self.tied(self.exact.decide_left_orient2d(a, b, c), || {
            leading_orient2d::<SCHEME>([p, q, r]).unwrap_or_else(|| self.open_orient2d::<SCHEME>(Plane::Xy, a, b, c))
        })
    }

    /// Answers a turn that integers or a projection's filter decide first.
    #[inline(never)]
    fn turn<const SCHEME: usize>(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        if let Some((sign, points)) = self.exact.turn_of_integers(a, b, c) {
            if !sign.is_zero() {
                return (sign, INTEGER);
            }
            if let Some(broken) = leading_orient2d::<SCHEME>(points) {
                return broken;
            }
        }
        self.open_turn::<SCHEME>(plane, a, b, c)
    }

    #[cold]
    #[inline(never)]
    fn open_turn<const SCHEME: usize>(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        self.tied(self.exact.decide_orient2d(plane, a, b, c), || self.open_orient2d::<SCHEME>(plane, a, b, c))
    }

    #[cold]
    #[inline(never)]
    fn open_orient2d<const SCHEME: usize>(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        let decided = leading::orient2d::<SCHEME>(self.points, plane, [a, b, c]);
        self.broken(Question::Orient2d(plane), [a, b, c], decided)
    }

    #[inline(always)]
    pub fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match (self.exact.filtered_orient3d(a, b, c, d), self.scheme) {
            (Filtered::Settled(sign, stage), _) if !sign.is_zero() => (sign, stage),
            (Filtered::Left(zero, [p, q, r, s]), Scheme::PerCoordinate) => {
                self.left_orient3d::<PER_COORDINATE>(zero, p, q, r, s)
            }
            (Filtered::Left(zero, [p, q, r, s]), Scheme::EdelsbrunnerMucke) => {
                self.left_orient3d::<EDELSBRUNNER_MUCKE>(zero, p, q, r, s)
            }
            // (In a flat scene zeros are certain.)
            (Filtered::Settled(..) | Filtered::Unasked, _) => self.unasked_orient3d(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn left_orient3d<const SCHEME: usize>(
        &self,
        determinant: f64,
        p: &[f64; 3],
        q: &[f64; 3],
        r: &[f64; 3],
        s: &[f64; 3],
    ) -> (Sign, usize) {
        if determinant == 0.0
            && self.exact.is_known_double(PredicateKind::Orient3d)
            && let Some(points) = smallest_first([p, q, r, s])
            && let Some((sign, place)) = gradient::decide::<SCHEME, ORIENT3D, _, _, _>(points, gradient::orient3d)
        {
            return (sign, stage::FIRST_TERM + place);
        }
        let [a, b, c, d] = [p, q, r, s].map(|point| self.points.vertex3(point));
        self.tied(self.exact.decide_left_orient3d(determinant, a, b, c, d), || self.open_orient3d::<SCHEME>(a, b, c, d))
    }

    #[inline(never)]
    fn unasked_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.tied(self.exact.decide_orient3d(a, b, c, d), || match self.scheme {
            Scheme::PerCoordinate => self.open_orient3d::<PER_COORDINATE>(a, b, c, d),
            Scheme::EdelsbrunnerMucke => self.open_orient3d::<EDELSBRUNNER_MUCKE>(a, b, c, d),
        })
    }

    #[cold]
    #[inline(never)]
    fn open_orient3d<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let decided = leading::orient3d::<SCHEME>(&self.exact, self.points, [a, b, c, d]);
        self.broken(Question::Orient3d, [a, b, c, d], decided)
    }

    #[inline(always)]
    pub fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match (self.exact.filtered_incircle(a, b, c, d), self.scheme) {
            (Filtered::Settled(sign, stage), _) if !sign.is_zero() => (sign, stage),
            (Filtered::Left(zero, [p, q, r, s]), Scheme::PerCoordinate) => {
                self.left_incircle::<PER_COORDINATE>(zero, p, q, r, s)
            }
            (Filtered::Left(zero, [p, q, r, s]), Scheme::EdelsbrunnerMucke) => {
                self.left_incircle::<EDELSBRUNNER_MUCKE>(zero, p, q, r, s)
            }
            // (In a flat scene zeros are certain.)
            (Filtered::Settled(..) | Filtered::Unasked, _) => self.unasked_incircle(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn left_incircle<const SCHEME: usize>(
        &self,
        determinant: f64,
        p: &[f64; 2],
        q: &[f64; 2],
        r: &[f64; 2],
        s: &[f64; 2],
    ) -> (Sign, usize) {
        if determinant == 0.0
            && self.exact.is_known_double(PredicateKind::Incircle)
            && let Some(points) = smallest_first([p, q, r, s])
        {
            return match gradient::decide_one::<SCHEME, INCIRCLE, _, _, _>(points, gradient::incircle) {
                Some((sign, place)) => (sign, stage::FIRST_TERM + place),
                None => self.deep_incircle::<SCHEME>([p, q, r, s]),
            };
        }
        let [a, b, c, d] = [p, q, r, s].map(|point| self.points.vertex2(point));
        self.tied(self.exact.decide_left_incircle(determinant, a, b, c, d), || self.open_incircle::<SCHEME>(a, b, c, d))
    }

    /// Decides by the rest of the list where doubles are exact and the leading terms and the next one are zero.
    #[cold]
    #[inline(never)]
    fn deep_incircle<const SCHEME: usize>(&self, points: [&[f64; 2]; 4]) -> (Sign, usize) {
        let args = points.map(|point| self.points.vertex2(point));
        let decided = leading::deep::<SCHEME, INCIRCLE, 2, 4>(&self.exact, self.points.flat, args, (true, 3));
        self.tied((Sign::Zero, DOUBLE), || self.broken(Question::Incircle, args, decided))
    }

    #[inline(never)]
    fn unasked_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        self.tied(self.exact.decide_incircle(a, b, c, d), || match self.scheme {
            Scheme::PerCoordinate => self.open_incircle::<PER_COORDINATE>(a, b, c, d),
            Scheme::EdelsbrunnerMucke => self.open_incircle::<EDELSBRUNNER_MUCKE>(a, b, c, d),
        })
    }

    #[cold]
    #[inline(never)]
    fn open_incircle<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let decided = leading::incircle::<SCHEME>(&self.exact, self.points, [a, b, c, d]);
        self.broken(Question::Incircle, [a, b, c, d], decided)
    }

    #[inline(always)]
    pub fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        match (self.exact.filtered_insphere(a, b, c, d, e), self.scheme) {
            (Filtered::Settled(sign, stage), _) if !sign.is_zero() => (sign, stage),
            (Filtered::Left(zero, [p, q, r, s, t]), Scheme::PerCoordinate) => {
                self.left_insphere::<PER_COORDINATE>(zero, p, q, r, s, t)
            }
            (Filtered::Left(zero, [p, q, r, s, t]), Scheme::EdelsbrunnerMucke) => {
                self.left_insphere::<EDELSBRUNNER_MUCKE>(zero, p, q, r, s, t)
            }
            // (In a flat scene zeros are certain.)
            (Filtered::Settled(..) | Filtered::Unasked, _) => self.unasked_insphere(a, b, c, d, e),
        }
    }

    #[cold]
    #[inline(never)]
    fn left_insphere<const SCHEME: usize>(
        &self,
        determinant: f64,
        p: &[f64; 3],
        q: &[f64; 3],
        r: &[f64; 3],
        s: &[f64; 3],
        t: &[f64; 3],
    ) -> (Sign, usize) {
        if determinant == 0.0
            && self.exact.is_known_double(PredicateKind::Insphere)
            && let Some(points) = smallest_first([p, q, r, s, t])
        {
            return match gradient::decide_one::<SCHEME, INSPHERE, _, _, _>(points, gradient::insphere) {
                Some((sign, place)) => (sign, stage::FIRST_TERM + place),
                None => self.deep_insphere::<SCHEME>([p, q, r, s, t]),
            };
        }
        let [a, b, c, d, e] = [p, q, r, s, t].map(|point| self.points.vertex3(point));
        self.tied(self.exact.decide_left_insphere(determinant, a, b, c, d, e), || {
            self.open_insphere::<SCHEME>(a, b, c, d, e)
        })
    }

    /// Decides by the rest of the list where doubles are exact and the leading terms and the next one are zero.
    #[cold]
    #[inline(never)]
    fn deep_insphere<const SCHEME: usize>(&self, points: [&[f64; 3]; 5]) -> (Sign, usize) {
        let args = points.map(|point| self.points.vertex3(point));
        let decided = leading::deep::<SCHEME, INSPHERE, 3, 5>(&self.exact, self.points.solid, args, (true, 4));
        self.tied((Sign::Zero, DOUBLE), || self.broken(Question::Insphere, args, decided))
    }

    #[inline(never)]
    fn unasked_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        self.tied(self.exact.decide_insphere(a, b, c, d, e), || match self.scheme {
            Scheme::PerCoordinate => self.open_insphere::<PER_COORDINATE>(a, b, c, d, e),
            Scheme::EdelsbrunnerMucke => self.open_insphere::<EDELSBRUNNER_MUCKE>(a, b, c, d, e),
        })
    }

    #[cold]
    #[inline(never)]
    fn open_insphere<const SCHEME: usize>(
        &self,
        a: Vertex,
        b: Vertex,
        c: Vertex,
        d: Vertex,
        e: Vertex,
    ) -> (Sign, usize) {
        let decided = leading::insphere::<SCHEME>(&self.exact, self.points, [a, b, c, d, e]);
        self.broken(Question::Insphere, [a, b, c, d, e], decided)
    }

    /// The exact backend's answer, or the answer of the tie if that is zero.
    #[inline(always)]
    pub fn tied(&self, exact: (Sign, usize), tie: impl FnOnce() -> (Sign, usize)) -> (Sign, usize) {
        match exact {
            (Sign::Zero, stage) => match tie() {
                (sign, AS_EXACT) => (sign, stage),
                broken => broken,
            },
            decided => decided,
        }
    }

    #[inline(always)]
    fn broken<const N: usize>(&self, question: Question, args: [Vertex; N], decided: Decided) -> (Sign, usize) {
        match decided {
            Some((sign, place)) => (sign, stage::FIRST_TERM + place),
            None => self.rest(question, args),
        }
    }

    /// Breaks ties without a term list: a vertex occurs twice, or a vertex is constructed.
    #[cold]
    #[inline(never)]
    fn rest<const N: usize>(&self, question: Question, args: [Vertex; N]) -> (Sign, usize) {
        if args.iter().any(|v| v.is_constructed()) {
            return self.tie_constructed(question, args);
        }
        (Sign::Zero, AS_EXACT)
    }

    pub fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        self.exact.compare_batch(axis, queries, out);
        let tie = |[a, b]: [Vertex; 2]| {
            let is_input = !a.is_constructed() && !b.is_constructed();
            is_input.then(|| (Sign::from(b.cmp(&a)), 0))
        };
        break_all(queries, out, tie, |[a, b]| self.compare_constructed(axis, a, b).0);
    }

    pub fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        if plane == Plane::Xy && self.exact.turns_in_integers() {
            queries.iter().zip(out).for_each(|(&[a, b, c], out)| *out = self.orient2d(plane, a, b, c).0);
            return;
        }
        if plane == Plane::Zx {
            // The columns of the lists ascend.
            self.exact.orient2d_batch(plane, queries, out);
        } else {
            match self.scheme {
                Scheme::PerCoordinate => {
                    self.exact.orient2d_batch_with(plane, queries, out, many::Lanes::<PER_COORDINATE>);
                }
                Scheme::EdelsbrunnerMucke => {
                    self.exact.orient2d_batch_with(plane, queries, out, many::Lanes::<EDELSBRUNNER_MUCKE>);
                }
            }
        }
        let points = self.points;
        // (In space there are no points of the plane, and all ties remain open.)
        let first = (
            |args| leading::orient2d::<PER_COORDINATE>(points, plane, args),
            |ties: &[_], out: &mut [_]| many::orient2d::<PER_COORDINATE>(points.flat, ties, out),
        );
        let second = (
            |args| leading::orient2d::<EDELSBRUNNER_MUCKE>(points, plane, args),
            |ties: &[_], out: &mut [_]| many::orient2d::<EDELSBRUNNER_MUCKE>(points.flat, ties, out),
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Orient2d(plane), args).0);
    }

    pub fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], vertices: &[Vertex], out: &mut [Sign]) {
        self.exact.orient2d_line(plane, line, vertices, out);
        let ([a, b], points) = (line, self.points);
        let first = |c| leading::orient2d::<PER_COORDINATE>(points, plane, [a, b, c]);
        let second = |c| leading::orient2d::<EDELSBRUNNER_MUCKE>(points, plane, [a, b, c]);
        self.break_by(vertices, out, (first, second), |c| self.rest(Question::Orient2d(plane), [a, b, c]).0);
    }

    pub fn orient3d_plane(&self, plane: [Vertex; 3], vertices: &[Vertex], out: &mut [Sign]) {
        self.exact.orient3d_plane(plane, vertices, out);
        let ([a, b, c], points) = (plane, self.points);
        let first = |d| leading::orient3d::<PER_COORDINATE>(&self.exact, points, [a, b, c, d]);
        let second = |d| leading::orient3d::<EDELSBRUNNER_MUCKE>(&self.exact, points, [a, b, c, d]);
        self.break_by(vertices, out, (first, second), |d| self.rest(Question::Orient3d, [a, b, c, d]).0);
    }

    pub fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        match self.scheme {
            Scheme::PerCoordinate => self.exact.orient3d_batch_with(queries, out, many::Lanes::<PER_COORDINATE>),
            Scheme::EdelsbrunnerMucke => {
                self.exact.orient3d_batch_with(queries, out, many::Lanes::<EDELSBRUNNER_MUCKE>);
            }
        }
        let (exact, points) = (&self.exact, self.points);
        let is_broken = exact.is_known_double(PredicateKind::Orient3d);
        let first = (
            |args| leading::orient3d::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::orient3d::<PER_COORDINATE>(points.solid, ties, out) }
            },
        );
        let second = (
            |args| leading::orient3d::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::orient3d::<EDELSBRUNNER_MUCKE>(points.solid, ties, out) }
            },
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Orient3d, args).0);
    }

    pub fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        match self.scheme {
            Scheme::PerCoordinate => self.exact.incircle_batch_with(queries, out, many::Lanes::<PER_COORDINATE>),
            Scheme::EdelsbrunnerMucke => {
                self.exact.incircle_batch_with(queries, out, many::Lanes::<EDELSBRUNNER_MUCKE>);
            }
        }
        let (exact, points) = (&self.exact, self.points);
        let is_broken = exact.is_known_double(PredicateKind::Incircle);
        let first = (
            |args| leading::incircle::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::incircle::<PER_COORDINATE>(points.flat, ties, out) }
            },
        );
        let second = (
            |args| leading::incircle::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::incircle::<EDELSBRUNNER_MUCKE>(points.flat, ties, out) }
            },
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Incircle, args).0);
    }

    pub fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        match self.scheme {
            Scheme::PerCoordinate => self.exact.insphere_batch_with(queries, out, many::Lanes::<PER_COORDINATE>),
            Scheme::EdelsbrunnerMucke => {
                self.exact.insphere_batch_with(queries, out, many::Lanes::<EDELSBRUNNER_MUCKE>);
            }
        }
        let (exact, points) = (&self.exact, self.points);
        let is_broken = exact.is_known_double(PredicateKind::Insphere);
        let first = (
            |args| leading::insphere::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::insphere::<PER_COORDINATE>(points.solid, ties, out) }
            },
        );
        let second = (
            |args| leading::insphere::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| {
                if is_broken { u64::MAX } else { many::insphere::<EDELSBRUNNER_MUCKE>(points.solid, ties, out) }
            },
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Insphere, args).0);
    }

    /// Breaks the ties of a batch by either scheme, or by the general method if neither has a list.
    #[inline(always)]
    fn break_by<Q: Copy>(
        &self,
        queries: &[Q],
        out: &mut [Sign],
        (per_coordinate, edelsbrunner_mucke): (impl Ties<Q>, impl Ties<Q>),
        rest: impl Fn(Q) -> Sign,
    ) {
        match self.scheme {
            Scheme::PerCoordinate => break_all(queries, out, per_coordinate, rest),
            Scheme::EdelsbrunnerMucke => break_all(queries, out, edelsbrunner_mucke, rest),
        }
    }
}
