//! Tie breaking: the sign of a tie of the exact backend, and the stage that has found it.
//!
//! A breaker counts nothing, so it is one type, compiled once for all tallies of a [`Session`](crate::Session).

use predicament_exact::Exact;
use predicament_exact::stage::COMPARE;
use predicament_predicates::{
    Axis, Backend, Construction, Declined, Off, Plane, PredicateKind, Predicates, Question, Refused, Scene, Sign,
    Vertex,
};

use crate::batch::{Ties, break_all};
use crate::constructed::{self, Memo};
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
        match self.exact.decide_compare(axis, a, b) {
            (Sign::Zero, stage) => match self.tie_constructed(Question::Compare(axis), [a, b]) {
                (sign, AS_EXACT) => (sign, stage),
                broken => broken,
            },
            decided => decided,
        }
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

    // Ties are broken out of line and take vertices in registers: answers without ties need no stack for them. Most
    // ties need none either. The others are left to a second function, which takes the same registers.

    #[inline(always)]
    pub fn tie_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        match self.scheme {
            Scheme::PerCoordinate => self.orient2d::<PER_COORDINATE>(plane, a, b, c),
            Scheme::EdelsbrunnerMucke => self.orient2d::<EDELSBRUNNER_MUCKE>(plane, a, b, c),
        }
    }

    #[cold]
    #[inline(never)]
    fn orient2d<const SCHEME: usize>(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        if self.points.solid.is_empty()
            && let Some((sign, place)) = leading::differences::<SCHEME>(self.points.flat, [a, b, c])
        {
            return (sign, stage::FIRST_TERM + place);
        }
        self.open_orient2d::<SCHEME>(plane, a, b, c)
    }

    #[cold]
    #[inline(never)]
    fn open_orient2d<const SCHEME: usize>(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        let decided = leading::orient2d::<SCHEME>(self.points, plane, [a, b, c]);
        self.broken(Question::Orient2d(plane), [a, b, c], decided)
    }

    #[inline(always)]
    pub fn tie_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match self.scheme {
            Scheme::PerCoordinate => self.orient3d::<PER_COORDINATE>(a, b, c, d),
            Scheme::EdelsbrunnerMucke => self.orient3d::<EDELSBRUNNER_MUCKE>(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn orient3d<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        if self.exact.is_known_double(PredicateKind::Orient3d)
            && let Some((sign, place)) = leading::turns_of::<SCHEME>(self.points.solid, [a, b, c, d])
        {
            return (sign, stage::FIRST_TERM + place);
        }
        self.open_orient3d::<SCHEME>(a, b, c, d)
    }

    #[cold]
    #[inline(never)]
    fn open_orient3d<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let decided = leading::orient3d::<SCHEME>(&self.exact, self.points, [a, b, c, d]);
        self.broken(Question::Orient3d, [a, b, c, d], decided)
    }

    #[inline(always)]
    pub fn tie_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match self.scheme {
            Scheme::PerCoordinate => self.incircle::<PER_COORDINATE>(a, b, c, d),
            Scheme::EdelsbrunnerMucke => self.incircle::<EDELSBRUNNER_MUCKE>(a, b, c, d),
        }
    }

    #[cold]
    #[inline(never)]
    fn incircle<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        if self.exact.is_known_double(PredicateKind::Incircle)
            && let Some(sign) = many::first_incircle::<SCHEME>(self.points.flat, [a, b, c, d])
        {
            return (sign, stage::FIRST_TERM);
        }
        self.open_incircle::<SCHEME>(a, b, c, d)
    }

    #[cold]
    #[inline(never)]
    fn open_incircle<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        let decided = leading::incircle::<SCHEME>(&self.exact, self.points, [a, b, c, d]);
        self.broken(Question::Incircle, [a, b, c, d], decided)
    }

    #[inline(always)]
    pub fn tie_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        match self.scheme {
            Scheme::PerCoordinate => self.insphere::<PER_COORDINATE>(a, b, c, d, e),
            Scheme::EdelsbrunnerMucke => self.insphere::<EDELSBRUNNER_MUCKE>(a, b, c, d, e),
        }
    }

    #[cold]
    #[inline(never)]
    fn insphere<const SCHEME: usize>(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        if self.exact.is_known_double(PredicateKind::Insphere)
            && let Some(sign) = many::first_insphere::<SCHEME>(self.points.solid, [a, b, c, d, e])
        {
            return (sign, stage::FIRST_TERM);
        }
        self.open_insphere::<SCHEME>(a, b, c, d, e)
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
        self.exact.orient2d_batch(plane, queries, out);
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
        self.exact.orient3d_batch(queries, out);
        let (exact, points) = (&self.exact, self.points);
        let is_exact = || exact.is_double(PredicateKind::Orient3d);
        let first = (
            |args| leading::orient3d::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::orient3d::<PER_COORDINATE>(points.solid, ties, out, is_exact()),
        );
        let second = (
            |args| leading::orient3d::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::orient3d::<EDELSBRUNNER_MUCKE>(points.solid, ties, out, is_exact()),
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Orient3d, args).0);
    }

    pub fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.exact.incircle_batch(queries, out);
        let (exact, points) = (&self.exact, self.points);
        let is_exact = || exact.is_double(PredicateKind::Incircle);
        let first = (
            |args| leading::incircle::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::incircle::<PER_COORDINATE>(points.flat, ties, out, is_exact()),
        );
        let second = (
            |args| leading::incircle::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::incircle::<EDELSBRUNNER_MUCKE>(points.flat, ties, out, is_exact()),
        );
        self.break_by(queries, out, (first, second), |args| self.rest(Question::Incircle, args).0);
    }

    pub fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.exact.insphere_batch(queries, out);
        let (exact, points) = (&self.exact, self.points);
        let is_exact = || exact.is_double(PredicateKind::Insphere);
        let first = (
            |args| leading::insphere::<PER_COORDINATE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::insphere::<PER_COORDINATE>(points.solid, ties, out, is_exact()),
        );
        let second = (
            |args| leading::insphere::<EDELSBRUNNER_MUCKE>(exact, points, args),
            |ties: &[_], out: &mut [_]| many::insphere::<EDELSBRUNNER_MUCKE>(points.solid, ties, out, is_exact()),
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
