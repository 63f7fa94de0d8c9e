//! Questions as data: a predicate with its descriptor, its parameters besides vertices, and sets of queries.

use alloc::vec::Vec;
use core::sync::atomic::{Ordering, compiler_fence};

use crate::{Axis, Derived, Dimension, Plane, Predicates, Sign, UnknownName, Vertex};

/// A sign predicate: one of the five with methods of their own, or one from a formula.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PredicateKind {
    /// The order of two vertices along an axis.
    Compare,
    /// The turn of three vertices in a coordinate plane.
    Orient2d,
    /// The side of the plane of three vertices on which a fourth vertex lies.
    Orient3d,
    /// The position of a fourth vertex relative to the circle through three.
    Incircle,
    /// The position of a fifth vertex relative to the sphere through four.
    Insphere,
    /// A predicate from a formula.
    Derived(Derived),
}

impl PredicateKind {
    /// The number of different values of [`PredicateKind::index`].
    pub const COUNT: usize = 6;

    /// The five predicates with methods of their own, in the order of their degrees.
    pub const ALL: [PredicateKind; 5] = [
        PredicateKind::Compare,
        PredicateKind::Orient2d,
        PredicateKind::Orient3d,
        PredicateKind::Incircle,
        PredicateKind::Insphere,
    ];

    /// The predicates of [`PredicateKind::ALL`] that multiply coordinates: a comparison needs no arithmetic.
    pub const DETERMINANTS: [PredicateKind; 4] =
        [PredicateKind::Orient2d, PredicateKind::Orient3d, PredicateKind::Incircle, PredicateKind::Insphere];

    /// The predicate's name in suites, CSV files and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            PredicateKind::Derived(derived) => derived.name(),
            PredicateKind::Compare => "compare",
            PredicateKind::Orient2d => "orient2d",
            PredicateKind::Orient3d => "orient3d",
            PredicateKind::Incircle => "incircle",
            PredicateKind::Insphere => "insphere",
        }
    }

    /// The number of vertices of a query.
    #[must_use]
    pub fn arity(self) -> usize {
        match self {
            PredicateKind::Derived(derived) => derived.arity(),
            PredicateKind::Compare => 2,
            PredicateKind::Orient2d => 3,
            PredicateKind::Orient3d | PredicateKind::Incircle => 4,
            PredicateKind::Insphere => 5,
        }
    }

    /// The index in [`PredicateKind::ALL`]; the number behind it for all predicates from formulas.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            PredicateKind::Compare => 0,
            PredicateKind::Orient2d => 1,
            PredicateKind::Orient3d => 2,
            PredicateKind::Incircle => 3,
            PredicateKind::Insphere => 4,
            PredicateKind::Derived(_) => 5,
        }
    }

    /// The degree of the polynomial in coordinates.
    #[must_use]
    pub fn degree(self) -> u32 {
        match self {
            PredicateKind::Compare => 1,
            PredicateKind::Orient2d => 2,
            PredicateKind::Orient3d => 3,
            PredicateKind::Incircle => 4,
            PredicateKind::Insphere => 5,
            PredicateKind::Derived(derived) => derived.degree(),
        }
    }

    /// The dimension of the scenes that the predicate is about; `None` if there are several.
    #[must_use]
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            PredicateKind::Compare | PredicateKind::Orient2d => None,
            PredicateKind::Orient3d | PredicateKind::Insphere => Some(Dimension::Three),
            PredicateKind::Incircle => Some(Dimension::Two),
            PredicateKind::Derived(derived) => Some(derived.dimension()),
        }
    }

    /// Returns true if the determinant has a column of squared lengths.
    #[must_use]
    pub const fn is_lifted(self) -> bool {
        matches!(self, PredicateKind::Incircle | PredicateKind::Insphere)
    }

    /// The formula of the predicate from which it could be derived; one of several, for predicates in a plane.
    #[must_use]
    pub fn formula_text(self) -> &'static str {
        match self {
            PredicateKind::Compare => "a.x - b.x",
            PredicateKind::Orient2d => "det(a - c, b - c)",
            PredicateKind::Orient3d => "det(a - d, b - d, c - d)",
            PredicateKind::Incircle => "det([a - d, sq(a - d)], [b - d, sq(b - d)], [c - d, sq(c - d)])",
            PredicateKind::Insphere => {
                "det([a - e, sq(a - e)], [b - e, sq(b - e)], [c - e, sq(c - e)], [d - e, sq(d - e)])"
            }
            PredicateKind::Derived(derived) => derived.text(),
        }
    }

    /// The meaning of the sign, in one line.
    #[must_use]
    pub fn about(self) -> &'static str {
        match self {
            PredicateKind::Compare => "the order of two vertices along an axis",
            PredicateKind::Orient2d => "the turn of three vertices in a coordinate plane",
            PredicateKind::Orient3d => "the side of a plane through three vertices on which a fourth lies",
            PredicateKind::Incircle => "whether a vertex is in the circle through three",
            PredicateKind::Insphere => "whether a vertex is in the sphere through four",
            PredicateKind::Derived(derived) => derived.about(),
        }
    }

    /// The question with the first axis or plane, if the predicate has these parameters.
    #[must_use]
    pub const fn first_question(self) -> Question {
        match self {
            PredicateKind::Compare => Question::Compare(Axis::X),
            PredicateKind::Orient2d => Question::Orient2d(Plane::Xy),
            PredicateKind::Orient3d => Question::Orient3d,
            PredicateKind::Incircle => Question::Incircle,
            PredicateKind::Insphere => Question::Insphere,
            PredicateKind::Derived(derived) => Question::Derived(derived),
        }
    }
}

impl core::fmt::Display for PredicateKind {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}

impl core::str::FromStr for PredicateKind {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<PredicateKind, UnknownName> {
        PredicateKind::ALL
            .into_iter()
            .find(|kind| kind.name() == name)
            .or_else(|| Derived::named(name).map(PredicateKind::Derived))
            .ok_or_else(|| UnknownName::new("predicate", name))
    }
}

/// A predicate with its parameters besides vertices.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Question {
    /// [`Predicates::compare`] along an axis.
    Compare(Axis),
    /// [`Predicates::orient2d`] in a plane.
    Orient2d(Plane),
    /// [`Predicates::orient3d`].
    Orient3d,
    /// [`Predicates::incircle`].
    Incircle,
    /// [`Predicates::insphere`].
    Insphere,
    /// [`Predicates::sign`] of a formula.
    Derived(Derived),
}

impl Question {
    /// The predicate of this question.
    #[inline]
    #[must_use]
    pub const fn kind(self) -> PredicateKind {
        match self {
            Question::Compare(_) => PredicateKind::Compare,
            Question::Orient2d(_) => PredicateKind::Orient2d,
            Question::Orient3d => PredicateKind::Orient3d,
            Question::Incircle => PredicateKind::Incircle,
            Question::Insphere => PredicateKind::Insphere,
            Question::Derived(derived) => PredicateKind::Derived(derived),
        }
    }

    /// The coordinates that the predicate reads, as indices of a point's coordinates; weights are not among them.
    #[must_use]
    pub fn coordinates(self) -> &'static [usize] {
        match self {
            Question::Compare(axis) => match axis {
                Axis::X => &[0],
                Axis::Y => &[1],
                Axis::Z => &[2],
            },
            Question::Orient2d(plane) => match plane {
                Plane::Xy => &[0, 1],
                Plane::Yz => &[1, 2],
                Plane::Zx => &[2, 0],
            },
            Question::Incircle => &[0, 1],
            Question::Orient3d | Question::Insphere => &[0, 1, 2],
            Question::Derived(derived) => &[0, 1, 2][..derived.dimension().count()],
        }
    }

    /// Asks one query.
    ///
    /// # Panics
    /// If the length of `args` is not the predicate's arity.
    #[inline]
    pub fn ask<P: Predicates + ?Sized>(self, session: &P, args: &[Vertex]) -> Sign {
        match (self, args) {
            (Question::Compare(axis), &[a, b]) => session.compare(axis, a, b),
            (Question::Orient2d(plane), &[a, b, c]) => session.orient2d(plane, a, b, c),
            (Question::Orient3d, &[a, b, c, d]) => session.orient3d(a, b, c, d),
            (Question::Incircle, &[a, b, c, d]) => session.incircle(a, b, c, d),
            (Question::Insphere, &[a, b, c, d, e]) => session.insphere(a, b, c, d, e),
            (Question::Derived(derived), args) if args.len() == derived.arity() => session.sign(derived, args),
            _ => panic!("{} takes {} vertices, not {}", self.kind(), self.kind().arity(), args.len()),
        }
    }
}

impl Question {
    /// Asks many queries in order by the session's batch call; `args` has their vertices, query after query.
    ///
    /// # Panics
    /// If the length of `out` is not the number of queries.
    pub fn ask_batch<P: Predicates + ?Sized>(self, session: &P, args: &[Vertex], out: &mut [Sign]) {
        assert_eq!(args.len(), out.len() * self.kind().arity(), "one place for each answer");
        match self {
            Question::Compare(axis) => session.compare_batch(axis, args.as_chunks().0, out),
            Question::Orient2d(plane) => session.orient2d_batch(plane, args.as_chunks().0, out),
            Question::Orient3d => session.orient3d_batch(args.as_chunks().0, out),
            Question::Incircle => session.incircle_batch(args.as_chunks().0, out),
            Question::Insphere => session.insphere_batch(args.as_chunks().0, out),
            Question::Derived(derived) => session.sign_batch(derived, args, out),
        }
    }

    /// Asks many queries in order, one at a time, as a loop in user code does; `args` has their vertices, query after
    /// query.
    ///
    /// The compiler cannot merge queries: each answer is stored before the next query is read.
    ///
    /// # Panics
    /// If the length of `out` is not the number of queries.
    pub fn ask_singly<P: Predicates + ?Sized>(self, session: &P, args: &[Vertex], out: &mut [Sign]) {
        assert_eq!(args.len(), out.len() * self.kind().arity(), "one place for each answer");
        match self {
            Question::Compare(axis) => singly(args, out, |&[a, b]| session.compare(axis, a, b)),
            Question::Orient2d(plane) => singly(args, out, |&[a, b, c]| session.orient2d(plane, a, b, c)),
            Question::Orient3d => singly(args, out, |&[a, b, c, d]| session.orient3d(a, b, c, d)),
            Question::Incircle => singly(args, out, |&[a, b, c, d]| session.incircle(a, b, c, d)),
            Question::Insphere => singly(args, out, |&[a, b, c, d, e]| session.insphere(a, b, c, d, e)),
            Question::Derived(derived) => {
                for (query, out) in args.chunks_exact(derived.arity()).zip(out) {
                    *out = session.sign(derived, query);
                    compiler_fence(Ordering::SeqCst);
                }
            }
        }
    }
}

#[inline(always)]
fn singly<const N: usize>(args: &[Vertex], out: &mut [Sign], ask: impl Fn(&[Vertex; N]) -> Sign) {
    for (query, out) in args.as_chunks().0.iter().zip(out) {
        *out = ask(query);
        // Not an instruction: the compiler moves no memory access across it.
        compiler_fence(Ordering::SeqCst);
    }
}

/// Many queries of one kind, their vertices in one flat array.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct QuerySet {
    question: Question,
    args: Vec<Vertex>,
}

impl QuerySet {
    /// A set of queries from vertices, query after query.
    ///
    /// # Panics
    /// If `args` does not divide into whole queries.
    #[must_use]
    pub fn new(question: Question, args: Vec<Vertex>) -> QuerySet {
        let arity = question.kind().arity();
        assert!(args.len().is_multiple_of(arity), "{} vertices don't divide into queries of {arity}", args.len());
        QuerySet { question, args }
    }

    /// The question of all queries.
    #[inline]
    #[must_use]
    pub fn question(&self) -> Question {
        self.question
    }

    /// The predicate of all queries.
    #[inline]
    #[must_use]
    pub fn kind(&self) -> PredicateKind {
        self.question.kind()
    }

    /// The number of queries.
    #[inline]
    #[must_use]
    pub fn len(&self) -> usize {
        self.args.len() / self.kind().arity()
    }

    /// Returns true if the set is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.args.is_empty()
    }

    /// The vertices of one query.
    ///
    /// # Panics
    /// If `query` is out of range.
    #[inline]
    #[must_use]
    pub fn args(&self, query: usize) -> &[Vertex] {
        let arity = self.kind().arity();
        &self.args[query * arity..][..arity]
    }

    /// The vertices of all queries, one after another.
    #[inline]
    #[must_use]
    pub fn flat(&self) -> &[Vertex] {
        &self.args
    }

    /// Answers the queries of `range` in order through the session's batch calls.
    ///
    /// # Panics
    /// If `out` is not as long as `range`, or `range` reaches past the end.
    pub fn ask_batch<P: Predicates + ?Sized>(&self, session: &P, range: core::ops::Range<usize>, out: &mut [Sign]) {
        assert_eq!(range.len(), out.len(), "one place for each answer");
        let arity = self.kind().arity();
        self.question.ask_batch(session, &self.args[range.start * arity..range.end * arity], out);
    }
}
