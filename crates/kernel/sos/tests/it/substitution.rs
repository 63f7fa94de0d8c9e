//! A third computation: a small number in place of ε.
//!
//! Coordinates are small integers. A nonzero coefficient is then at least 1 in magnitude, all others together stay
//! below 2^32, and exponents differ by 1 at least. So with ε = 2^-40 the largest monomial outweighs the rest, and the
//! sign of the determinant is that of its coefficient. Numbers are integers over a common power of two, which may have
//! a million bits.

use crate::common::{Random, first, grid_scene, questions, words};
use predicament_predicates::{Backend, Off, Question, Scene, Sign};
use predicament_sos::{Scheme, Sos};
use rug::{Complete, Integer};

const BITS: u32 = 40;

/// The sign of the determinant of all vertices of the scene, in index order, after the move.
///
/// Coordinate n = 0, 1… moves by ε^(base^n) and only the first `moving` of them move at all.
fn substituted(scheme: Scheme, scene: &Scene, question: Question, base: u32, moving: usize) -> Sign {
    let axes: Vec<usize> = match question {
        Question::Compare(axis) => vec![axis.index()],
        Question::Orient2d(plane) => plane.axes().map(|axis| axis.index()).to_vec(),
        _ => (0..scene.dimension().count()).collect(),
    };
    let lifted = matches!(question, Question::Incircle | Question::Insphere);
    let stride = scene.dimension().count() + usize::from(lifted && scheme == Scheme::EdelsbrunnerMucke);
    let precision = BITS * base.pow(u32::try_from(moving - 1).unwrap());
    // x·2^precision + ε^(base^n)·2^precision
    let moved = |x: &Integer, vertex: usize, coordinate: usize| {
        let within = if scheme == Scheme::PerCoordinate { coordinate } else { stride - 1 - coordinate };
        let number = vertex * stride + within;
        let fixed = (x << precision).complete();
        if number < moving {
            fixed + (Integer::from(1) << (precision - BITS * base.pow(u32::try_from(number).unwrap())))
        } else {
            fixed
        }
    };
    let rows: Vec<Vec<Integer>> = (0..question.kind().arity())
        .map(|vertex| {
            let point: Vec<Integer> = scene
                .point(predicament_predicates::Vertex::input(vertex))
                .iter()
                .map(|&x| Integer::from_f64(x).unwrap())
                .collect();
            let mut row: Vec<Integer> = axes.iter().map(|&axis| moved(&point[axis], vertex, axis)).collect();
            if lifted {
                let lift = match scheme {
                    Scheme::PerCoordinate => row.iter().map(|x| x.square_ref().complete()).sum(),
                    Scheme::EdelsbrunnerMucke => {
                        let lift: Integer = point.iter().map(|x| x.square_ref().complete()).sum();
                        moved(&lift, vertex, stride - 1)
                    }
                };
                row.push(lift);
            }
            row.push(Integer::from(1));
            row
        })
        .collect();
    Sign::from(determinant(rows).cmp0())
}

/// The determinant of a square matrix.
///
/// The last row is subtracted from all others, which strikes it and the ones; the rest is expanded along the first
/// column.
fn determinant(mut rows: Vec<Vec<Integer>>) -> Integer {
    fn expand(rows: &[&[Integer]]) -> Integer {
        if rows.is_empty() {
            return Integer::from(1);
        }
        let mut sum = Integer::new();
        for place in 0..rows.len() {
            let others: Vec<&[Integer]> =
                (0..rows.len()).filter(|&other| other != place).map(|other| &rows[other][1..]).collect();
            let product = expand(&others) * &rows[place][0];
            if place % 2 == 0 { sum += product } else { sum -= product }
        }
        sum
    }
    let last = rows.pop().unwrap();
    for row in &mut rows {
        row.pop();
        row.iter_mut().zip(&last).for_each(|(entry, subtrahend)| *entry -= subtrahend);
    }
    expand(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

fn check(scheme: Scheme, scene: &Scene, question: Question, base: u32, moving: usize) {
    let sos = Sos { scheme };
    let answer = question.ask(&sos.prepare(scene, Off).unwrap(), &first(question.kind().arity()));
    let number = substituted(scheme, scene, question, base, moving);
    assert_eq!(answer, number, "{scheme} {question:?} base {base} {scene:?}");
}

/// In base 2, as in the papers, and in base 3: the signs are the same.
#[test]
fn multilinear_in_both_bases() {
    for scheme in Scheme::ALL {
        for base in [2, 3] {
            for numbers in words(9, 3) {
                let scene = grid_scene(2, 3, &numbers);
                for question in questions(2).into_iter().filter(|q| q.kind().arity() <= 3) {
                    check(scheme, &scene, question, base, 6);
                }
            }
        }
    }
}

/// In base 2 all twelve coordinates move, in base 3 only the first nine.
///
/// The product of one coordinate of each of the first three vertices has a constant coefficient, and outweighs all
/// monomials of the last vertex.
#[test]
fn in_space_in_both_bases() {
    let mut random = Random(6);
    for _ in 0..predicament_effort::some_or_all(15, 60) {
        let scene = grid_scene(3, 2, &random.numbers(8, 4));
        for scheme in Scheme::ALL {
            for question in questions(3).into_iter().filter(|q| q.kind().arity() <= 4) {
                check(scheme, &scene, question, 2, 12);
                check(scheme, &scene, question, 3, 9);
            }
        }
    }
}

#[test]
fn circles() {
    let mut random = Random(7);
    for _ in 0..predicament_effort::some_or_all(50, 200) {
        let scene = grid_scene(2, 3, &random.numbers(9, 4));
        check(Scheme::PerCoordinate, &scene, Question::Incircle, 3, 8);
        check(Scheme::EdelsbrunnerMucke, &scene, Question::Incircle, 2, 12);
    }
}

/// The smallest infinitesimals are omitted, as their numbers would be too long.
///
/// The monomials with constant coefficients, e(0,z)·e(1,y)·e(2,x)²·e(3,x) and e(0,x)·e(1,y)·e(2,z)·e(3,lift), outweigh
/// all monomials with them.
#[test]
fn spheres() {
    let mut random = Random(8);
    for _ in 0..predicament_effort::some_or_all(3, 12) {
        let scene = grid_scene(3, 2, &random.numbers(8, 5));
        check(Scheme::PerCoordinate, &scene, Question::Insphere, 3, 10);
        check(Scheme::EdelsbrunnerMucke, &scene, Question::Insphere, 2, 13);
    }
}

/// Base 2 is another scheme if the lift has the squares of ε^(2^i).
///
/// Monomials collide, and some signs differ. This is why the base is 3.
#[test]
fn base_two_fails_for_a_lift_that_moves() {
    let sos = Sos::default();
    let differs = words(4, 4).any(|numbers| {
        let scene = grid_scene(2, 2, &numbers);
        let answer = Question::Incircle.ask(&sos.prepare(&scene, Off).unwrap(), &first(4));
        answer != substituted(Scheme::PerCoordinate, &scene, Question::Incircle, 2, 8)
    });
    assert!(differs);
}
