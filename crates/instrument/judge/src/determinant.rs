//! The judge: exact signs by the textbook determinants.
//!
//! The judge shares no code with any backend: no filter, no expansion, no translated copy of a published formula. The
//! judge has only `rug`, integers of 128 bits where these hold everything (`short.rs`), and the definition. Slowness is
//! acceptable here. Constructed vertices first become rational points, by linear equations.
//!
//! [`verdict`] computes in rationals, term by term. [`sign`] and [`is_within`] are for millions of queries: they use
//! rationals over common denominators, that is, integers. Runs check samples of the second computation against the
//! first. The tests check both against a third computation by another method: fraction-free elimination of the
//! homogeneous matrix. [`Points`](crate::Points) does the same for a whole scene.

use std::borrow::Cow;

use predicament_predicates::{Axis, Plane, Question, Scene, Sign, Vertex};
use rug::{Integer, Rational};

use crate::constructed::{certain_row, point};
use crate::row::Row;
use crate::{formula, integers};

/// An exact determinant and its permanent-like magnitude.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The exact value of the predicate's determinant; the predicate is its sign.
    pub determinant: Rational,
    /// The permanent: the determinant's expression with the absolute value of every product and difference term.
    /// Rounding errors are relative to this scale.
    pub permanent: Rational,
}

impl Verdict {
    /// The sign of the determinant.
    #[must_use]
    pub fn sign(&self) -> Sign {
        sign_of(&self.determinant)
    }
}

fn sign_of(value: &Rational) -> Sign {
    value.cmp0().into()
}

/// The exact value of a finite double.
///
/// # Panics
/// If `x` is not finite; scenes hold finite coordinates only.
#[must_use]
pub fn rational(x: f64) -> Rational {
    Rational::from_f64(x).expect("scenes hold finite coordinates only")
}

/// The exact sign of a query.
///
/// # Panics
/// If the query does not fit the scene (wrong number of vertices, no such vertex, no such axis), or if it uses a
/// construction that gives no point, which scenes of suites don't have.
#[must_use]
pub fn sign(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    sign_of_rows(scene, question, args, |v| Cow::Owned(certain_row(scene, v)))
}

/// The exact sign of a query, with the points from `row` if a vertex is constructed.
pub(crate) fn sign_of_rows<'r>(
    scene: &Scene,
    question: Question,
    args: &[Vertex],
    row: impl Fn(Vertex) -> Cow<'r, Row>,
) -> Sign {
    if let Question::Derived(derived) = question {
        return sign_of(&formula::value(scene, derived, args));
    }
    if args.iter().any(|v| v.is_constructed()) {
        assert_arity(question, args);
        let rows: Vec<_> = args.iter().map(|&v| row(v)).collect();
        return integers::sign_of_rows(&rows, axes(&question), question.kind().is_lifted());
    }
    scaled(scene, question, args, |determinant, _| determinant.cmp0().into())
}

/// Calls a function with the exact determinant of a query about input vertices: an integer, and the exponent of the
/// power of two that scales it.
fn scaled<R>(scene: &Scene, question: Question, args: &[Vertex], then: impl FnOnce(&Integer, i32) -> R) -> R {
    let flat = |plane: Plane| move |v| scene.point2(plane, v);
    let solid = |v| scene.point3(v);
    match (question, args) {
        (Question::Compare(axis), &[a, b]) => {
            integers::scaled([a, b].map(|v| [scene.coordinate(axis, v)]), false, then)
        }
        (Question::Orient2d(plane), &[a, b, c]) => integers::scaled([a, b, c].map(flat(plane)), false, then),
        (Question::Orient3d, &[a, b, c, d]) => integers::scaled([a, b, c, d].map(solid), false, then),
        (Question::Incircle, &[a, b, c, d]) => integers::scaled([a, b, c, d].map(flat(Plane::Xy)), true, then),
        (Question::Insphere, &[a, b, c, d, e]) => integers::scaled([a, b, c, d, e].map(solid), true, then),
        _ => panic!("{} takes {} vertices", question.kind(), question.kind().arity()),
    }
}

/// True if the magnitude of the exact determinant of a query is at most `limit`.
///
/// # Panics
/// As [`sign`], or if `limit` is not finite.
#[must_use]
pub fn is_within(scene: &Scene, question: Question, args: &[Vertex], limit: f64) -> bool {
    if let Question::Derived(derived) = question {
        return formula::value(scene, derived, args).abs() <= rational(limit);
    }
    if args.iter().any(|v| v.is_constructed()) {
        return verdict(scene, question, args).determinant.abs() <= rational(limit);
    }
    scaled(scene, question, args, |determinant, exponent| integers::is_at_most(determinant, exponent, limit))
}

/// The exact determinant of a query with its permanent.
///
/// # Panics
/// As [`sign`].
#[must_use]
pub fn verdict(scene: &Scene, question: Question, args: &[Vertex]) -> Verdict {
    if let Question::Derived(derived) = question {
        return formula::verdict(scene, derived, args);
    }
    verdict_of(question, args, |v| Cow::Owned(point(scene, v).unwrap_or_else(|| panic!("{v} is not a point"))))
}

/// The exact determinant of a query with its permanent, with the coordinates from `point`.
pub(crate) fn verdict_of<'p>(
    question: Question,
    args: &[Vertex],
    point: impl Fn(Vertex) -> Cow<'p, [Rational]>,
) -> Verdict {
    assert_arity(question, args);
    if let (Question::Compare(axis), &[a, b]) = (question, args) {
        let [a, b] = [a, b].map(|v| point(v)[axis.index()].clone());
        return Verdict { permanent: Rational::from(a.abs_ref()) + Rational::from(b.abs_ref()), determinant: a - b };
    }
    let rows = rows(question, args, point);
    let permanent = permanent(&rows);
    Verdict { determinant: determinant(&rows), permanent }
}

fn assert_arity(question: Question, args: &[Vertex]) {
    let arity = question.kind().arity();
    assert_eq!(args.len(), arity, "{} takes {arity} vertices", question.kind());
}

/// The axes whose coordinates are columns of the matrix.
pub(crate) fn axes(question: &Question) -> &[Axis] {
    match question {
        Question::Compare(axis) => std::slice::from_ref(axis),
        Question::Orient2d(Plane::Xy) | Question::Incircle => &[Axis::X, Axis::Y],
        Question::Orient2d(Plane::Yz) => &[Axis::Y, Axis::Z],
        Question::Orient2d(Plane::Zx) => &[Axis::Z, Axis::X],
        Question::Orient3d | Question::Insphere => &[Axis::X, Axis::Y, Axis::Z],
        Question::Derived(derived) => panic!("{} is not a determinant of rows", derived.formula().name()),
    }
}

/// The matrix of differences to the last vertex, with the lifted column for circles and spheres.
fn rows<'p>(question: Question, args: &[Vertex], point: impl Fn(Vertex) -> Cow<'p, [Rational]>) -> Vec<Vec<Rational>> {
    let (last, others) = args.split_last().expect("no predicate takes no vertex");
    let axes = axes(&question);
    let exact = |&v: &Vertex| {
        let point = point(v);
        axes.iter().map(|axis| point[axis.index()].clone()).collect::<Vec<_>>()
    };
    let origin = exact(last);
    let lifted = question.kind().is_lifted();
    let row = |v: &Vertex| {
        let mut row: Vec<Rational> = exact(v).into_iter().zip(&origin).map(|(x, o)| x - o).collect();
        if lifted {
            row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
        }
        row
    };
    others.iter().map(row).collect()
}

/// The determinant by Laplace expansion along the first column: the definition, term by term.
#[must_use]
pub fn determinant(rows: &[Vec<Rational>]) -> Rational {
    expand(rows, 0, &mut (0..rows.len()).collect::<Vec<_>>(), &|term, odd| if odd { -term } else { term })
}

/// The permanent of a matrix: Laplace expansion with the absolute value of each term.
fn permanent(rows: &[Vec<Rational>]) -> Rational {
    let positive: Vec<Vec<Rational>> =
        rows.iter().map(|row| row.iter().map(|x| Rational::from(x.abs_ref())).collect()).collect();
    expand(&positive, 0, &mut (0..rows.len()).collect::<Vec<_>>(), &|term, _| term)
}

fn expand(
    rows: &[Vec<Rational>],
    column: usize,
    left: &mut Vec<usize>,
    signed: &dyn Fn(Rational, bool) -> Rational,
) -> Rational {
    if left.is_empty() {
        return Rational::from(1);
    }
    let mut sum = Rational::new();
    for at in 0..left.len() {
        let row = left.remove(at);
        let entry = &rows[row][column];
        if entry.cmp0().is_ne() {
            sum += signed(expand(rows, column + 1, left, signed) * entry, at % 2 == 1);
        }
        left.insert(at, row);
    }
    sum
}

/// log2(|determinant| / permanent), which measures how degenerate a query is: 0 is not degenerate. `None` for an exact
/// zero.
///
/// Accurate to about 1e-9. Plots use it as a coordinate; no decision depends on it.
#[must_use]
pub fn log2_relative(verdict: &Verdict) -> Option<f64> {
    // The permanent is zero only if the determinant is zero.
    let value = Rational::from(verdict.determinant.abs_ref());
    if value.cmp0().is_eq() { None } else { Some(log2(&(value / &verdict.permanent))) }
}

/// log2 of a positive rational, also if it is far outside the range of doubles.
pub(crate) fn log2(x: &Rational) -> f64 {
    let part = |n: &rug::Integer| {
        let bits = n.significant_bits();
        let shift = bits.saturating_sub(60);
        // Rounds 60 bits to 53, which is precise enough: the logarithm is shown with two decimals.
        rug::Integer::from(n >> shift).to_f64().log2() + f64::from(shift)
    };
    part(x.numer()) - part(x.denom())
}
