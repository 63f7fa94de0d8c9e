//! The backend: exact first, the perturbation on ties only.

use predicament_exact::stage::COMPARE;
use predicament_exact::{Exact, lanes};
use predicament_predicates::{
    Axis, Backend, Construction, Constructs, Contract, Declined, Off, Plane, PredicateKind, Predicates, Question,
    Refused, Scene, Sessions, Sign, Tally, Vertex, ZeroMeaning,
};

use crate::constructed::{self, Memo};
use crate::lanes as many;
use crate::leading::{self, Decided, EDELSBRUNNER_MUCKE, PER_COORDINATE, Points};
use crate::{Scheme, stage};

/// The Simulation of Simplicity backend.
///
/// Its promise is proved: the sign of the real determinant where that is not
/// zero, and else the sign for all small enough ε > 0 of the determinant of
/// the scene that the scheme has moved. Between input vertices the answer is zero only if a
/// vertex comes twice in a query; about constructed vertices it is zero
/// exactly if the determinant is zero wherever the input vertices are.
///
/// [`Scheme::PerCoordinate`] moves constructed vertices with the vertices that define them. The
/// other scheme declines scenes that have constructed vertices, and this one those whose
/// definitions name constructed vertices.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Sos {
    /// How the scene is moved.
    pub scheme: Scheme,
}

impl Backend for Sos {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    /// `sos`, and the scheme if it is not the default.
    fn name(&self) -> String {
        match self.scheme {
            Scheme::PerCoordinate => "sos".to_owned(),
            Scheme::EdelsbrunnerMucke => format!("sos:{}", self.scheme),
        }
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Never, proved: true }
    }

    /// The exact backend's stages, then `term 1`, `term 2`… for ties: how deep
    /// in the predicate's list the deciding term stands.
    fn stages(&self) -> &'static [&'static str] {
        stage::names(self.scheme)
    }

    fn constructs(&self) -> Constructs {
        match self.scheme {
            Scheme::PerCoordinate => Constructs::KeepsFirst,
            Scheme::EdelsbrunnerMucke => Constructs::Declines,
        }
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if self.scheme != Scheme::PerCoordinate && !scene.constructions().is_empty() {
            return Err(Declined::scene(constructed::others_only()));
        }
        constructed::are_of_inputs(scene)?;
        let exact = Exact.prepare(scene, Off)?;
        let points = Points::of(scene);
        Ok(Session { scheme: self.scheme, exact, points, memo: Memo::new(scene), tally })
    }
}

/// The backend, prepared for one scene.
pub struct Session<'s, T> {
    scheme: Scheme,
    exact: predicament_exact::Session<'s, Off>,
    points: Points<'s>,
    memo: Memo,
    tally: T,
}

impl<T: Tally> Session<'_, T> {
    #[inline(always)]
    fn tallied(&self, kind: PredicateKind, sign: Sign, stage: usize) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }

    #[cold]
    #[inline(never)]
    fn compare_constructed(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let (sign, stage) = self.exact.decide_compare(axis, a, b);
        if sign.is_zero() {
            return self.tie_constructed(Question::Compare(axis), [a, b]);
        }
        self.tallied(PredicateKind::Compare, sign, stage)
    }

    #[cold]
    #[inline(never)]
    fn tie_constructed<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        match self.memo.decide(self.exact.scene(), question, args) {
            Some((sign, degree)) => self.tallied(question.kind(), sign, stage::of_degree(degree)),
            None => self.stays_zero(question, &args),
        }
    }

    // Ties are broken out of line and take vertices in registers: answers without ties need no stack for them.

    #[cold]
    #[inline(never)]
    fn tie_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let decided = match self.scheme {
            Scheme::PerCoordinate => leading::orient2d::<PER_COORDINATE>(self.points, plane, [a, b, c]),
            Scheme::EdelsbrunnerMucke => leading::orient2d::<EDELSBRUNNER_MUCKE>(self.points, plane, [a, b, c]),
        };
        self.broken(Question::Orient2d(plane), [a, b, c], decided)
    }

    #[cold]
    #[inline(never)]
    fn tie_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let (exact, args) = (&self.exact, [a, b, c, d]);
        let decided = match self.scheme {
            Scheme::PerCoordinate => leading::orient3d::<PER_COORDINATE>(exact, self.points, args),
            Scheme::EdelsbrunnerMucke => leading::orient3d::<EDELSBRUNNER_MUCKE>(exact, self.points, args),
        };
        self.broken(Question::Orient3d, args, decided)
    }

    #[cold]
    #[inline(never)]
    fn tie_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let (exact, args) = (&self.exact, [a, b, c, d]);
        let decided = match self.scheme {
            Scheme::PerCoordinate => leading::incircle::<PER_COORDINATE>(exact, self.points, args),
            Scheme::EdelsbrunnerMucke => leading::incircle::<EDELSBRUNNER_MUCKE>(exact, self.points, args),
        };
        self.broken(Question::Incircle, args, decided)
    }

    #[cold]
    #[inline(never)]
    fn tie_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        let (exact, args) = (&self.exact, [a, b, c, d, e]);
        let decided = match self.scheme {
            Scheme::PerCoordinate => leading::insphere::<PER_COORDINATE>(exact, self.points, args),
            Scheme::EdelsbrunnerMucke => leading::insphere::<EDELSBRUNNER_MUCKE>(exact, self.points, args),
        };
        self.broken(Question::Insphere, args, decided)
    }

    /// Tallies a tie.
    #[inline(always)]
    fn broken<const N: usize>(&self, question: Question, args: [Vertex; N], decided: Decided) -> Sign {
        match decided {
            Some((sign, place)) => self.tallied(question.kind(), sign, stage::FIRST_TERM + place),
            None => self.rest(question, args),
        }
    }

    /// What no list of terms is about: a vertex that comes twice, or a constructed one.
    #[cold]
    #[inline(never)]
    fn rest<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        if args.iter().any(|v| v.is_constructed()) {
            return self.tie_constructed(question, args);
        }
        self.stays_zero(question, &args)
    }

    /// Tallies what is zero however the vertices move, by the exact backend's stage.
    fn stays_zero(&self, question: Question, args: &[Vertex]) -> Sign {
        // Nobody pays for a stage that nobody wants to know.
        let (_, stage) = match (question, args) {
            _ if !T::LISTENS => return Sign::Zero,
            (Question::Compare(axis), &[a, b]) => self.exact.decide_compare(axis, a, b),
            (Question::Orient2d(plane), &[a, b, c]) => self.exact.decide_orient2d(plane, a, b, c),
            (Question::Orient3d, &[a, b, c, d]) => self.exact.decide_orient3d(a, b, c, d),
            (Question::Incircle, &[a, b, c, d]) => self.exact.decide_incircle(a, b, c, d),
            (Question::Insphere, &[a, b, c, d, e]) => self.exact.decide_insphere(a, b, c, d, e),
            _ => panic!("{question:?} is not asked of {args:?}"),
        };
        self.tallied(question.kind(), Sign::Zero, stage)
    }

    /// The exact backend's batch, and then the ties that it has found: by either scheme, or by what neither has a list for.
    #[inline(always)]
    fn batch<Q: Copy>(
        &self,
        queries: &[Q],
        out: &mut [Sign],
        single: impl Fn(&Q) -> Sign,
        exact: impl Fn(&mut [Sign]),
        (per_coordinate, edelsbrunner_mucke, rest): (impl Ties<Q>, impl Ties<Q>, impl Fn(Q) -> Sign),
    ) {
        if T::LISTENS {
            // Which of the exact backend's stages settled a query is known only where it is asked alone.
            for (query, out) in queries.iter().zip(out) {
                *out = single(query);
            }
            return;
        }
        exact(out);
        match self.scheme {
            Scheme::PerCoordinate => break_all(queries, out, per_coordinate, rest),
            Scheme::EdelsbrunnerMucke => break_all(queries, out, edelsbrunner_mucke, rest),
        }
    }
}

/// How the ties of a predicate are broken: one by one, and as many as a block has at once.
trait Ties<Q> {
    /// One tie.
    fn one(&self, tie: Q) -> Decided;

    /// The signs of some ties; those that are left open, by the bits of a mask.
    fn many(&self, ties: &[Q], out: &mut [Sign]) -> u64;
}

/// Ties that are broken one by one.
impl<Q, F: Fn(Q) -> Decided> Ties<Q> for F {
    #[inline(always)]
    fn one(&self, tie: Q) -> Decided {
        self(tie)
    }

    #[inline(always)]
    fn many(&self, _: &[Q], _: &mut [Sign]) -> u64 {
        u64::MAX
    }
}

impl<Q, F: Fn(Q) -> Decided, M: Fn(&[Q], &mut [Sign]) -> u64> Ties<Q> for (F, M) {
    #[inline(always)]
    fn one(&self, tie: Q) -> Decided {
        self.0(tie)
    }

    #[inline(always)]
    fn many(&self, ties: &[Q], out: &mut [Sign]) -> u64 {
        self.1(ties, out)
    }
}

/// Queries of a batch whose answers are looked at together.
const BLOCK: usize = lanes::MOST;
/// Ties of a block that are worth registers.
const MANY: usize = 8;

/// Breaks all ties of a batch.
#[inline(always)]
fn break_all<Q: Copy>(queries: &[Q], out: &mut [Sign], ties: impl Ties<Q>, rest: impl Fn(Q) -> Sign) {
    let one = |query: Q| match ties.one(query) {
        Some((sign, _)) => sign,
        None => rest(query),
    };
    for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
        // Seen for whole registers at once: most blocks have no tie.
        if !out.iter().fold(false, |any, sign| any | sign.is_zero()) {
            continue;
        }
        // Ties come as they like: those of a block are found without a branch on each.
        let (mut places, mut count) = ([0; BLOCK], 0);
        for (at, sign) in (0_u8..).zip(out.iter()) {
            places[count] = at;
            count += usize::from(sign.is_zero());
        }
        let places = places[..count].iter().map(|&at| usize::from(at));
        if count < MANY {
            places.for_each(|at| out[at] = one(queries[at]));
            continue;
        }
        if count == queries.len() {
            let mut open = ties.many(queries, out) & (u64::MAX >> (BLOCK - count));
            while open != 0 {
                let at = open.trailing_zeros() as usize;
                out[at] = one(queries[at]);
                open &= open - 1;
            }
            continue;
        }
        let (mut tied, mut signs) = ([queries[0]; BLOCK], [Sign::Zero; BLOCK]);
        places.clone().zip(&mut tied).for_each(|(at, tie)| *tie = queries[at]);
        let open = ties.many(&tied[..count], &mut signs[..count]);
        for (tie, at) in places.enumerate() {
            out[at] = if open >> tie & 1 == 0 { signs[tie] } else { one(queries[at]) };
        }
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        match self.scheme {
            Scheme::PerCoordinate => {
                let vertices = self.exact.construct_where(definitions, constructed::is_of_inputs);
                self.memo.grow(self.exact.scene());
                vertices
            }
            Scheme::EdelsbrunnerMucke => Err(Refused::session(constructed::others_only())),
        }
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Exact)
    }

    /// Circles and spheres are those of input vertices.
    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        let scene = self.scene();
        if matches!(kind, PredicateKind::Incircle | PredicateKind::Insphere) && !scene.constructions().is_empty() {
            return Err(Declined::predicate(kind, "ties of circles through constructed vertices are not broken"));
        }
        scene.has_dimension_for(kind)
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        let kind = PredicateKind::Compare;
        let (Some(x), Some(y)) = (self.points.coordinate(axis, a), self.points.coordinate(axis, b)) else {
            return self.compare_constructed(axis, a, b);
        };
        // What is not equal has one of two orders, for which the exact backend has to look twice.
        if x != y {
            return self.tallied(kind, if x > y { Sign::Positive } else { Sign::Negative }, COMPARE);
        }
        // The one term of both lists: the smaller index moves further.
        let stage = if a == b { COMPARE } else { stage::FIRST_TERM };
        self.tallied(kind, Sign::from(b.cmp(&a)), stage)
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let (sign, stage) = self.exact.decide_orient2d(plane, a, b, c);
        if sign.is_zero() {
            return self.tie_orient2d(plane, a, b, c);
        }
        self.tallied(PredicateKind::Orient2d, sign, stage)
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let (sign, stage) = self.exact.decide_orient3d(a, b, c, d);
        if sign.is_zero() {
            return self.tie_orient3d(a, b, c, d);
        }
        self.tallied(PredicateKind::Orient3d, sign, stage)
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let (sign, stage) = self.exact.decide_incircle(a, b, c, d);
        if sign.is_zero() {
            return self.tie_incircle(a, b, c, d);
        }
        self.tallied(PredicateKind::Incircle, sign, stage)
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        let (sign, stage) = self.exact.decide_insphere(a, b, c, d, e);
        if sign.is_zero() {
            return self.tie_insphere(a, b, c, d, e);
        }
        self.tallied(PredicateKind::Insphere, sign, stage)
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        let single = |&[a, b]: &[_; 2]| self.compare(axis, a, b);
        let exact = |out: &mut [Sign]| self.exact.compare_batch(axis, queries, out);
        let tie = |[a, b]: [Vertex; 2]| {
            let is_input = !a.is_constructed() && !b.is_constructed();
            is_input.then(|| (Sign::from(b.cmp(&a)), 0))
        };
        self.batch(queries, out, single, exact, (tie, tie, |[a, b]| self.compare_constructed(axis, a, b)));
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        let (single, points) = (|&[a, b, c]: &[_; 3]| self.orient2d(plane, a, b, c), self.points);
        let exact = |out: &mut [Sign]| self.exact.orient2d_batch(plane, queries, out);
        // (In space there are no points of the plane, and all ties are left open.)
        let ties = (
            (
                |args| leading::orient2d::<PER_COORDINATE>(points, plane, args),
                |ties: &[_], out: &mut [_]| many::orient2d::<PER_COORDINATE>(points.flat, ties, out),
            ),
            (
                |args| leading::orient2d::<EDELSBRUNNER_MUCKE>(points, plane, args),
                |ties: &[_], out: &mut [_]| many::orient2d::<EDELSBRUNNER_MUCKE>(points.flat, ties, out),
            ),
            |args| self.rest(Question::Orient2d(plane), args),
        );
        self.batch(queries, out, single, exact, ties);
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], vertices: &[Vertex], out: &mut [Sign]) {
        let ([a, b], points) = (line, self.points);
        let exact = |out: &mut [Sign]| self.exact.orient2d_line(plane, line, vertices, out);
        let ties = (
            |c| leading::orient2d::<PER_COORDINATE>(points, plane, [a, b, c]),
            |c| leading::orient2d::<EDELSBRUNNER_MUCKE>(points, plane, [a, b, c]),
            |c| self.rest(Question::Orient2d(plane), [a, b, c]),
        );
        self.batch(vertices, out, |&c| self.orient2d(plane, a, b, c), exact, ties);
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], vertices: &[Vertex], out: &mut [Sign]) {
        let ([a, b, c], points) = (plane, self.points);
        let exact = |out: &mut [Sign]| self.exact.orient3d_plane(plane, vertices, out);
        let ties = (
            |d| leading::orient3d::<PER_COORDINATE>(&self.exact, points, [a, b, c, d]),
            |d| leading::orient3d::<EDELSBRUNNER_MUCKE>(&self.exact, points, [a, b, c, d]),
            |d| self.rest(Question::Orient3d, [a, b, c, d]),
        );
        self.batch(vertices, out, |&d| self.orient3d(a, b, c, d), exact, ties);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let (single, points) = (|&[a, b, c, d]: &[_; 4]| self.orient3d(a, b, c, d), self.points);
        let exact = |out: &mut [Sign]| self.exact.orient3d_batch(queries, out);
        let is_exact = || self.exact.is_double(PredicateKind::Orient3d);
        let ties = (
            (
                |args| leading::orient3d::<PER_COORDINATE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::orient3d::<PER_COORDINATE>(points.solid, ties, out, is_exact()),
            ),
            (
                |args| leading::orient3d::<EDELSBRUNNER_MUCKE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::orient3d::<EDELSBRUNNER_MUCKE>(points.solid, ties, out, is_exact()),
            ),
            |args| self.rest(Question::Orient3d, args),
        );
        self.batch(queries, out, single, exact, ties);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let (single, points) = (|&[a, b, c, d]: &[_; 4]| self.incircle(a, b, c, d), self.points);
        let exact = |out: &mut [Sign]| self.exact.incircle_batch(queries, out);
        let is_exact = || self.exact.is_double(PredicateKind::Incircle);
        let ties = (
            (
                |args| leading::incircle::<PER_COORDINATE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::incircle::<PER_COORDINATE>(points.flat, ties, out, is_exact()),
            ),
            (
                |args| leading::incircle::<EDELSBRUNNER_MUCKE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::incircle::<EDELSBRUNNER_MUCKE>(points.flat, ties, out, is_exact()),
            ),
            |args| self.rest(Question::Incircle, args),
        );
        self.batch(queries, out, single, exact, ties);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let (single, points) = (|&[a, b, c, d, e]: &[_; 5]| self.insphere(a, b, c, d, e), self.points);
        let exact = |out: &mut [Sign]| self.exact.insphere_batch(queries, out);
        let is_exact = || self.exact.is_double(PredicateKind::Insphere);
        let ties = (
            (
                |args| leading::insphere::<PER_COORDINATE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::insphere::<PER_COORDINATE>(points.solid, ties, out, is_exact()),
            ),
            (
                |args| leading::insphere::<EDELSBRUNNER_MUCKE>(&self.exact, points, args),
                |ties: &[_], out: &mut [_]| many::insphere::<EDELSBRUNNER_MUCKE>(points.solid, ties, out, is_exact()),
            ),
            |args| self.rest(Question::Insphere, args),
        );
        self.batch(queries, out, single, exact, ties);
    }
}
