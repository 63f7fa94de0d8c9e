//! The terms of Simulation of Simplicity against the value at perturbed points, in rationals.

// Small numbers, and random bits of which any part is as good.
#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]

use std::cmp::Ordering;

use predicament_formula::{Formula, Order, exact};
use predicament_judge::formula_value;
use rug::{Integer, Rational};

use crate::common::{HAND_MADE, Input, Random, formula, slices};

/// The sign at points whose coordinates are moved by explicit infinitesimals, from the syntax tree alone.
///
/// Each infinitesimal is a power of 2^-`base`, so small that a larger power cannot undo it: coordinates are integers
/// below 2^3, and the value has few terms.
fn explicit(formula: &Formula, points: &[Vec<f64>], ranks: &[usize], order: Order) -> Ordering {
    let dimension = formula.dimension();
    let degree = formula.polynomial().degree() + 1;
    let names = formula.points().to_vec();
    // The value as a function of moved coordinates: a formula about rationals, so the coordinates are given as
    // integers over one power of two. The judge takes doubles, so the polynomial is evaluated here.
    let moved: Vec<Rational> = (0..names.len() * dimension)
        .map(|variable| {
            let (point, axis) = (variable / dimension, variable % dimension);
            let within = if order == Order::FirstLargest { axis } else { dimension - 1 - axis };
            let place = u32::try_from(ranks[point] * dimension + within).unwrap();
            let exponent = 40 * degree.pow(place);
            Rational::from_f64(points[point][axis]).unwrap() + Rational::from((1, Integer::from(1) << exponent))
        })
        .collect();
    let mut sum = Rational::new();
    for (exponents, coefficient) in formula.polynomial().terms() {
        let mut product = Rational::from(coefficient);
        for (x, &exponent) in moved.iter().zip(exponents) {
            for _ in 0..exponent {
                product *= x;
            }
        }
        sum += product;
    }
    sum.cmp0()
}

fn by_terms(formula: &Formula, points: &[Vec<f64>], ranks: &[usize], order: Order) -> Ordering {
    let slices = slices(points);
    let (sign, _) = formula.unfiltered(&slices);
    if sign.is_ne() {
        return sign;
    }
    let terms = formula.terms(ranks, order).unwrap();
    let signs = terms.programs().iter().map(|program| exact::dyadic(program, &slices));
    signs.into_iter().find(|sign| sign.is_ne()).unwrap_or(Ordering::Equal)
}

#[test]
fn ties_are_broken_as_explicit_infinitesimals_break_them() {
    let formulas = [
        ("det(a - c, b - c)", 2),
        ("sq(p - a) - sq(p - b)", 2),
        ("a.x * b.y - a.y * a.y", 2),
        ("(a.x - b.x) * (a.y - b.y) ^ 2", 2),
    ];
    let mut random = Random(7);
    for (text, dimension) in formulas {
        let formula = formula(text, dimension);
        let mut ties = 0;
        for _ in 0..400 {
            let points: Vec<Vec<f64>> = Input::Grid
                .points(&formula, &mut random)
                .into_iter()
                .map(|p| p.iter().map(|x| x / 3.0).map(f64::trunc).collect())
                .collect();
            let mut ranks: Vec<usize> = (0..formula.arity()).collect();
            ranks.rotate_left(random.below(formula.arity() as u64) as usize);
            for order in [Order::FirstLargest, Order::LastLargest] {
                let found = by_terms(&formula, &points, &ranks, order);
                assert_ne!(found, Ordering::Equal, "{text} at {points:?}");
                assert_eq!(found, explicit(&formula, &points, &ranks, order), "{text} at {points:?}, {ranks:?}");
            }
            ties += usize::from(formula_value(&formula, &slices(&points)).unwrap().is_zero());
        }
        assert!(ties > 20, "{text}: {ties}");
    }
}

/// Arguments that can change places are sorted before terms are derived: the deciding term and its place stay, and the
/// sign turns as the formula does.
#[test]
fn sorted_arguments_have_the_same_terms() {
    let mut random = Random(11);
    let formulas = HAND_MADE.into_iter().map(|(_, text, dimension)| (text, dimension));
    let mut counts = [0; 2];
    for (text, dimension) in formulas.chain([("sq(p - a) - sq(p - b)", 2), ("det(a - c, b - c) * det(a, b)", 2)]) {
        let formula = formula(text, dimension);
        for _ in 0..20 {
            let mut ranks: Vec<usize> = (0..formula.arity()).collect();
            for at in (1..ranks.len()).rev() {
                ranks.swap(at, random.below(at as u64 + 1) as usize);
            }
            let mut sorted = ranks.clone();
            let turns = formula.sort(&mut sorted, |a, b| a < b);
            counts[usize::from(turns)] += 1;
            let terms = [&ranks, &sorted].map(|ranks| formula.terms(ranks, Order::FirstLargest).unwrap());
            assert_eq!(terms[0].programs().len(), terms[1].programs().len(), "{text}: {ranks:?}");
            let points: Vec<Vec<f64>> = Input::Grid.points(&formula, &mut random);
            let moved: Vec<Vec<f64>> = sorted
                .iter()
                .map(|rank| points[ranks.iter().position(|other| other == rank).unwrap()].clone())
                .collect();
            let [given, found] = [(&terms[0], &points), (&terms[1], &moved)].map(|(terms, points)| {
                let signs = terms.programs().iter().map(|program| exact::dyadic(program, &slices(points)));
                signs.zip(0..).find(|(sign, _)| sign.is_ne())
            });
            let expected = given.map(|(sign, place)| (if turns { sign.reverse() } else { sign }, place));
            assert_eq!(found, expected, "{text} at {points:?}, {ranks:?}");
        }
    }
    assert!(counts.iter().all(|&count| count > 30), "{counts:?}");
}

#[test]
fn every_list_ends_with_a_constant() {
    for (name, text, dimension) in HAND_MADE {
        let formula = formula(text, dimension);
        let ranks: Vec<usize> = (0..formula.arity()).rev().collect();
        for order in [Order::FirstLargest, Order::LastLargest] {
            let terms = formula.terms(&ranks, order).unwrap();
            assert_eq!(terms.coefficients().last().unwrap().degree(), 0, "{name}");
            assert!(terms.programs().len() < 200, "{name}: {}", terms.programs().len());
        }
    }
}

#[test]
fn one_vertex_twice_can_leave_a_tie() {
    let formula = formula("det(a - c, b - c)", 2);
    assert!(formula.terms(&[0, 0, 1], Order::FirstLargest).unwrap().programs().is_empty());
    assert!(!formula.terms(&[1, 0, 2], Order::FirstLargest).unwrap().programs().is_empty());
}

#[test]
fn a_moved_mesh_keeps_the_ties_within_it() {
    let formula = formula("det(a - d, b - d, c - d)", 3);
    assert!(formula.moved_terms(&[true; 4]).unwrap().programs().is_empty());
    assert!(formula.moved_terms(&[false; 4]).unwrap().programs().is_empty());
    // The plane of a, b, c stays and d moves by (ε, ε², ε³): first x of the normal, then y, then z.
    let terms = formula.moved_terms(&[false, false, false, true]).unwrap();
    assert_eq!(terms.programs().len(), 3);
    assert!(terms.coefficients().iter().all(|term| term.degree() == 2));
}

/// The linear term of y and the quadratic one of x both have ε².
#[test]
fn terms_of_a_lower_degree_in_the_move_come_first() {
    let formula = formula("(a.x - b.x) * (a.x - b.x) - (a.y - b.y) * (a.y - b.y)", 2);
    let terms = formula.moved_terms(&[false, true]).unwrap();
    assert_eq!(terms.coefficients().iter().map(|term| term.degree()).collect::<Vec<_>>(), [1, 1, 0, 0]);
}
