//! Inputs that round as badly as the constants of the filters allow.
//!
//! A constant is right if no input errs more than it says, and it is the best one if some input errs that much. A
//! search finds inputs within two percent of each constant; they expose a filter whose constant is two percent too
//! small.

mod climb;
mod fixed_scene;
mod lemma;
mod traced;
mod verdict;

use crate::common::{self, Random};
use crate::rational;
use climb::{Recipe, minus, over, steer, under};
use predicament_arithmetic::bound;
use predicament_exact::{estimate, side::Side};
use predicament_predicates::Sign;
use traced::Formula;
use verdict::Verdict;

/// The recipe for (a − c) × (b − c): both products, one too large and one too small.
const ORIENT2D: Recipe<2, 3> = Recipe {
    formula: traced::orient2d,
    entries: [[over(0), minus(under(0))], [minus(under(0)), over(0)], [steer(0); 2]],
    spread: -20,
    price: 15.0,
    steps: 1_000_000,
};

/// The recipe with the products a_z·b_x·c_y and c_z·a_x·b_y; all others are half an ulp of those, and steer.
const ORIENT3D: Recipe<3, 4> = Recipe {
    formula: traced::orient3d,
    entries: [
        [under(0), steer(-53), over(0)],
        [minus(over(0)), under(0), steer(-53)],
        [steer(-53), minus(over(0)), minus(under(0))],
        [steer(0); 3],
    ],
    spread: -20,
    price: 15.0,
    steps: 3_000_000,
};

/// The recipe for the side of the first point on the line from the last to the second: as `ORIENT2D`.
const LINE: Recipe<2, 3> = Recipe { formula: traced::line, ..ORIENT2D };

/// The recipe for the side of the first point on the plane of the others.
///
/// It is as `ORIENT3D`, with rows and columns exchanged.
const PLANE: Recipe<3, 4> = Recipe {
    formula: traced::plane,
    entries: [
        [over(0), steer(-53), under(0)],
        [minus(under(0)), minus(over(0)), steer(-53)],
        [steer(-53), under(0), minus(over(0))],
        [steer(0); 3],
    ],
    spread: -12,
    ..ORIENT3D
};

/// The recipe with the terms a_x²·b_x·c_y and c_x²·a_x·b_y.
const INCIRCLE: Recipe<2, 4> = Recipe {
    formula: traced::incircle,
    entries: [[over(0), steer(-26)], [over(-11), minus(under(-26))], [under(11), over(7)], [steer(0); 2]],
    spread: -20,
    price: 15.0,
    steps: 3_000_000,
};

/// The recipe with the terms b_x²·(a_x·c_y·d_z) and d_x²·(a_z·b_y·c_x), far from a tie.
///
/// The constant's proof does not need a near tie either.
const INSPHERE: Recipe<3, 5> = Recipe {
    formula: traced::insphere,
    entries: [
        [over(3), steer(-28), under(-16)],
        [over(28), under(22), steer(9)],
        [minus(under(3)), over(-15), steer(-28)],
        [minus(under(28)), steer(8), over(21)],
        [steer(0); 3],
    ],
    spread: -20,
    price: 0.0,
    steps: 1_500_000,
};

/// The same recipe at near ties.
const INSPHERE_NEAR: Recipe<3, 5> = Recipe {
    entries: [
        [over(3), steer(-18), under(-10)],
        [over(20), under(15), steer(3)],
        [minus(under(3)), minus(over(-10)), steer(-19)],
        [minus(under(20)), steer(1), over(15)],
        [steer(0); 3],
    ],
    spread: -8,
    price: 4.0,
    steps: 3_000_000,
    ..INSPHERE
};

/// Runs a recipe with these seeds: nothing errs beyond the constant, and something errs beyond `share` of it.
///
/// `share` is the planted fault. The first seed finds it. The remaining seeds run only at full effort.
fn hunt<const D: usize, const N: usize>(
    recipe: &Recipe<D, N>,
    (first, seeds): (u64, std::ops::Range<u64>),
    [constant, share]: [f64; 2],
    truth: fn(&[[f64; D]; N]) -> rational::Value,
) {
    let mut worst = 0f64;
    let mut caught = false;
    let whole = predicament_effort::whole();
    for seed in [first].into_iter().chain(seeds.filter(|&seed| seed != first)) {
        if caught && !whole {
            break;
        }
        let points = recipe.climb(seed);
        let verdict = Verdict::new(recipe.formula, &points, &truth(&points));
        assert!(verdict.within(constant, recipe.price), "{points:?} errs more than the constant says");
        caught |= !verdict.within(share * constant, recipe.price);
        worst = worst.max(verdict.badness(recipe.price));
    }
    println!("{worst:.4} u of {:.4} u", constant / bound::UNIT_ROUNDOFF);
    assert!(caught, "{worst} u at most: {share} of the constant would go unnoticed");
}

#[test]
fn two_percent_of_orient2d_are_caught() {
    hunt(&ORIENT2D, (10, 1..13), [bound::ORIENT2D, 0.98], |&[a, b, c]| rational::orient2d(a, b, c));
}

#[test]
fn two_percent_of_orient3d_are_caught() {
    hunt(&ORIENT3D, (2, 1..5), [bound::ORIENT3D, 0.98], |&[a, b, c, d]| rational::orient3d(a, b, c, d));
}

#[test]
fn two_percent_of_a_line_are_caught() {
    hunt(&LINE, (10, 1..13), [bound::ORIENT2D, 0.98], |&[c, b, a]| rational::orient2d(c, b, a));
}

#[test]
fn two_percent_of_a_plane_are_caught() {
    hunt(&PLANE, (7, 1..9), [bound::ORIENT3D, 0.98], |&[d, b, c, a]| rational::orient3d(d, b, c, a));
}

#[test]
fn two_percent_of_incircle_are_caught() {
    hunt(&INCIRCLE, (4, 1..7), [bound::INCIRCLE, 0.98], |&[a, b, c, d]| rational::incircle(a, b, c, d));
}

#[test]
fn two_percent_of_insphere_are_caught() {
    hunt(&INSPHERE, (3, 1..4), [bound::INSPHERE, 0.98], |&[a, b, c, d, e]| rational::insphere(a, b, c, d, e));
}

#[test]
fn seven_percent_of_insphere_are_caught_at_near_ties() {
    hunt(&INSPHERE_NEAR, (2, 1..5), [bound::INSPHERE, 0.93], |&[a, b, c, d, e]| rational::insphere(a, b, c, d, e));
}

/// The search is only as good as its model: it must compute the crate's estimates, bit by bit, and the true errors, as
/// rationals compute them.
#[test]
fn the_search_sees_what_the_filters_do() {
    fn check<const D: usize, const N: usize>(
        formula: Formula<D, N>,
        points: &[[f64; D]; N],
        determinant: f64,
        truth: &rational::Value,
        judge: Sign,
    ) {
        let [x, y] = formula(points);
        assert_eq!((x.value + y.value).to_bits(), determinant.to_bits(), "{points:?}");
        assert_eq!(truth.sign(), judge, "{points:?}");
        let verdict = Verdict::new(formula, points, truth);
        let seen = climb::badness([x, y], 0.0);
        assert!((verdict.badness(0.0) - seen).abs() < 1e-6, "{seen} at {points:?}");
    }
    let mut random = Random(20);
    for _ in 0..2000 {
        let p @ [a, b, c] = random.points(Random::unit);
        let d = estimate::orient2d(a, b, c).determinant;
        check(traced::orient2d, &p, d, &rational::orient2d(a, b, c), common::orient2d(&p));
        let p @ [a, b, c, d] = random.points(Random::unit);
        let determinant = estimate::orient3d(a, b, c, d).determinant;
        check(traced::orient3d, &p, determinant, &rational::orient3d(a, b, c, d), common::orient3d(&p));
        // The last point is not the pivot: rows are relative to the first point of the line or plane.
        let p @ [c, b, a] = random.points(Random::unit);
        let d = -Side::of_line([a, b], [1.0; 2]).determinant(c);
        check(traced::line, &p, d, &rational::orient2d(c, b, a), common::orient2d(&p));
        let p @ [d, b, c, a] = random.points(Random::unit);
        let determinant = -Side::of_plane([a, b, c], [1.0; 3]).determinant(d);
        check(traced::plane, &p, determinant, &rational::orient3d(d, b, c, a), common::orient3d(&p));
        let p @ [a, b, c, d] = random.points(Random::unit);
        let determinant = estimate::incircle(a, b, c, d).determinant;
        check(traced::incircle, &p, determinant, &rational::incircle(a, b, c, d), common::incircle(&p));
        let p @ [a, b, c, d, e] = random.points(Random::unit);
        let determinant = estimate::insphere(a, b, c, d, e).determinant;
        check(traced::insphere, &p, determinant, &rational::insphere(a, b, c, d, e), common::insphere(&p));
    }
}
