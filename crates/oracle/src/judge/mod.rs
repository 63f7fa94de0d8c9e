//! The judge: the textbook determinants, straight from the definition.
//!
//! It shares no code with any backend: no filter, no expansion, no translated
//! copy of anybody's formula, only `rug` and the definition. It is slow and
//! that is its virtue.
//!
//! [`verdict`] computes in rationals, term by term. [`sign`] is for millions of
//! queries: rationals over one common denominator, which are integers.
//! [`signs::truth`](crate::signs::truth) holds samples of the second against the first; both are
//! held against a third computation by another method in `tests/judge.rs`: the
//! homogeneous matrix by fraction-free elimination.

mod integers;

use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use rug::Rational;

/// An exact determinant and its permanent-like magnitude.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The exact value of the determinant that the predicate is the sign of.
    pub determinant: Rational,
    /// The same expression with every product and difference term taken
    /// absolutely: the scale that rounding errors are relative to.
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
/// If the query does not fit the scene: wrong number of vertices, no such vertex, no such axis.
#[must_use]
pub fn sign(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let flat = |plane: Plane| move |v| scene.point2(plane, v);
    let solid = |v| scene.point3(v);
    match (question, args) {
        (Question::Compare(axis), &[a, b]) => integers::sign([a, b].map(|v| [scene.coordinate(axis, v)]), false),
        (Question::Orient2d(plane), &[a, b, c]) => integers::sign([a, b, c].map(flat(plane)), false),
        (Question::Orient3d, &[a, b, c, d]) => integers::sign([a, b, c, d].map(solid), false),
        (Question::Incircle, &[a, b, c, d]) => integers::sign([a, b, c, d].map(flat(Plane::Xy)), true),
        (Question::Insphere, &[a, b, c, d, e]) => integers::sign([a, b, c, d, e].map(solid), true),
        _ => panic!("{} takes {} vertices", question.kind(), question.kind().arity()),
    }
}

/// The exact determinant of a query with its permanent.
///
/// # Panics
/// As [`sign`].
#[must_use]
pub fn verdict(scene: &Scene, question: Question, args: &[Vertex]) -> Verdict {
    if let (Question::Compare(axis), &[a, b]) = (question, args) {
        let (a, b) = (rational(scene.coordinate(axis, a)), rational(scene.coordinate(axis, b)));
        return Verdict { permanent: Rational::from(a.abs_ref()) + Rational::from(b.abs_ref()), determinant: a - b };
    }
    let rows = rows(scene, question, args);
    let permanent = permanent(&rows);
    Verdict { determinant: determinant(&rows), permanent }
}

/// The matrix of differences to the last vertex, with the lifted column where there is one.
fn rows(scene: &Scene, question: Question, args: &[Vertex]) -> Vec<Vec<Rational>> {
    let arity = question.kind().arity();
    assert_eq!(args.len(), arity, "{} takes {arity} vertices", question.kind());
    let (last, others) = args.split_last().expect("no predicate takes no vertex");
    let exact = |v: &Vertex| -> Vec<Rational> {
        match question {
            Question::Orient2d(plane) => scene.point2(plane, *v).map(rational).to_vec(),
            Question::Incircle => scene.point2(Plane::Xy, *v).map(rational).to_vec(),
            _ => scene.point3(*v).map(rational).to_vec(),
        }
    };
    let origin = exact(last);
    let lifted = matches!(question, Question::Incircle | Question::Insphere);
    let row = |v: &Vertex| {
        let mut row: Vec<Rational> = exact(v).into_iter().zip(&origin).map(|(x, o)| x - o).collect();
        if lifted {
            row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
        }
        row
    };
    others.iter().map(row).collect()
}

/// Laplace expansion along the first column: the definition, term by term.
fn determinant(rows: &[Vec<Rational>]) -> Rational {
    expand(rows, 0, &mut (0..rows.len()).collect::<Vec<_>>(), &|term, odd| if odd { -term } else { term })
}

/// The same expansion with everything positive.
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

/// log2(|determinant| / permanent): how degenerate a query is, 0 for not at
/// all. `None` for an exact zero.
///
/// Good to about 1e-9: it is a coordinate in plots, nothing is decided by it.
#[must_use]
pub fn log2_relative(verdict: &Verdict) -> Option<f64> {
    // The permanent is zero only where the determinant is.
    let value = Rational::from(verdict.determinant.abs_ref());
    if value.cmp0().is_eq() { None } else { Some(log2(&(value / &verdict.permanent))) }
}

/// log2 of a positive rational, also far outside the range of doubles.
fn log2(x: &Rational) -> f64 {
    let part = |n: &rug::Integer| {
        let bits = n.significant_bits();
        let shift = bits.saturating_sub(60);
        // Rounds (60 bits into 53): fine for a logarithm that is shown with two decimals.
        rug::Integer::from(n >> shift).to_f64().log2() + f64::from(shift)
    };
    part(x.numer()) - part(x.denom())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_convention_is_the_one_stated() {
        let v = Vertex::input;
        let plane = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5]]).unwrap();
        let ask = |question, args: &[usize]| sign(&plane, question, &args.iter().map(|&i| v(i)).collect::<Vec<_>>());
        assert_eq!(ask(Question::Orient2d(Plane::Xy), &[0, 1, 2]), Sign::Positive);
        assert_eq!(ask(Question::Incircle, &[0, 1, 2, 3]), Sign::Positive);
        let space = Scene::from_points3(&[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, -1.0],
            [0.1, 0.1, -0.1],
        ])
        .unwrap();
        let all: Vec<Vertex> = space.vertices().collect();
        assert_eq!(sign(&space, Question::Orient3d, &all[..4]), Sign::Positive, "d is below");
        assert_eq!(sign(&space, Question::Insphere, &all), Sign::Positive, "e is inside");
    }

    #[test]
    fn degeneracy_is_measured_far_outside_the_range_of_doubles() {
        let tiny = f64::from_bits(1);
        let scene = Scene::from_points2(&[[tiny, 0.0], [0.0, tiny], [0.0, 0.0]]).unwrap();
        let args: Vec<Vertex> = scene.vertices().collect();
        let found = verdict(&scene, Question::Orient2d(Plane::Xy), &args);
        assert_eq!(log2(&found.determinant), -2148.0);
        assert_eq!(log2_relative(&found), Some(0.0));
        let origin = Scene::from_points2(&[[0.0, 0.0]; 3]).unwrap();
        let found = verdict(&origin, Question::Orient2d(Plane::Xy), &args);
        assert_eq!(log2_relative(&found), None, "neither determinant nor permanent");
    }
}
