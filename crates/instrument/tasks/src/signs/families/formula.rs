//! Queries near and on the zero set of a formula, for predicates that nobody has written a family for.
//!
//! Most formulas have degree 1 in some coordinate: the value is a·x + b, and the root −b/a is a rational number. The
//! judge evaluates a and b. Where no coordinate has degree 1, bisection over the doubles finds a place where the exact
//! sign changes.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two, step};
use predicament_judge::formula_value;
use predicament_predicates::formula::Formula;
use rug::Rational;

/// The number of draws of small integers before a tie is looked for in another way.
const DRAWS: usize = 4000;

/// A query whose value would vanish if one coordinate were not rounded, moved by at most `ulps` ulps.
pub(super) fn near(formula: &Formula, ulps: i64, rng: &mut Random, out: &mut Vec<f64>) {
    let width = formula.coordinates();
    let mut all: Vec<f64> = (0..formula.arity() * width).map(|_| rng.unit()).collect();
    if let Some((at, root)) = root(formula, &mut all, rng)
        && root.to_f64().is_finite()
    {
        all[at] = root.to_f64();
        let moved = step(all[at], rng.integer(-ulps, ulps));
        all[at] = if moved.is_finite() { moved } else { all[at] };
    } else {
        bisect(formula, &mut all, rng);
    }
    out.extend(all);
}

/// A query whose value is zero: integers, or integers over one power of two.
pub(super) fn tie(formula: &Formula, rng: &mut Random, out: &mut Vec<f64>) {
    let width = formula.coordinates();
    let count = formula.arity() * width;
    for draw in 0..DRAWS {
        let size = 3 + i64::try_from(draw / 64).unwrap_or(0);
        let mut all: Vec<f64> = (0..count).map(|_| integer(rng.integer(-size, size))).collect();
        if small_value(formula, &all) != Some(0) && !to_the_zero(formula, &mut all, rng) {
            continue;
        }
        let points: Vec<&[f64]> = all.chunks(width).collect();
        let places: Vec<&[f64]> = points.iter().map(|point| &point[..formula.dimension()]).collect();
        let are_different = places.iter().enumerate().all(|(at, place)| !places[..at].contains(place));
        if are_different && formula_value(formula, &points).is_some_and(|value| value.is_zero()) {
            let unit = if formula.polynomial().is_homogeneous() { power_of_two(rng.integer(-40, 40)) } else { 1.0 };
            out.extend(all.into_iter().map(|x| x * unit));
            return;
        }
    }
    // No tie was found: the value at one place for all vertices vanishes for formulas in differences.
    out.extend((0..count).map(|at| if at % width == 0 { 1.0 } else { 0.0 }));
}

/// The value at small integers, if doubles have computed it without rounding.
fn small_value(formula: &Formula, all: &[f64]) -> Option<i64> {
    let width = formula.coordinates();
    let value = formula.program().estimate(|point, axis| all[point * width + axis]);
    // Every intermediate is a whole number; a sum of many below 2^40 is far from rounding.
    #[allow(clippy::cast_possible_truncation)] // whole and below 2^40
    (value.abs() < power_of_two(40)).then_some(value as i64)
}

/// Solves for one coordinate of small integers, and multiplies all by the root's denominator; false if that fails.
fn to_the_zero(formula: &Formula, all: &mut [f64], rng: &mut Random) -> bool {
    let count = all.len();
    let Ok(last) = i64::try_from(count - 1) else { return false };
    let start = usize::try_from(rng.integer(0, last)).unwrap_or(0);
    let Some(at) = (0..count).map(|next| (start + next) % count).find(|&at| formula.polynomial().degree_in(at) == 1)
    else {
        return false;
    };
    let [b, ab] = [0.0, 1.0].map(|x| {
        all[at] = x;
        small_value(formula, all)
    });
    let (Some(b), Some(ab)) = (b, ab) else { return false };
    let a = ab - b;
    if a == 0 {
        return false;
    }
    let common = gcd(a.unsigned_abs(), b.unsigned_abs()).cast_signed();
    let (numerator, denominator) = (-b / common * a.signum(), a.abs() / common);
    // A homogeneous formula stays zero if all coordinates are multiplied by one number.
    if denominator != 1 && !formula.polynomial().is_homogeneous() {
        return false;
    }
    all.iter_mut().for_each(|x| *x *= integer(denominator));
    all[at] = integer(numerator);
    true
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A coordinate in which the formula has degree 1, and the root: the value of it for which the formula vanishes.
fn root(formula: &Formula, all: &mut [f64], rng: &mut Random) -> Option<(usize, Rational)> {
    let (count, width) = (all.len(), formula.coordinates());
    let start = usize::try_from(rng.integer(0, i64::try_from(count).ok()? - 1)).ok()?;
    for at in (0..count).map(|next| (start + next) % count) {
        if formula.polynomial().degree_in(at) != 1 {
            continue;
        }
        let before = all[at];
        let [b, ab] = [0.0, 1.0].map(|x| {
            all[at] = x;
            formula_value(formula, &all.chunks(width).collect::<Vec<_>>()).unwrap_or_default()
        });
        all[at] = before;
        let a = ab - &b;
        if !a.is_zero() {
            return Some((at, -b / a));
        }
    }
    None
}

/// Moves one coordinate to a place where the exact sign changes, if there is one between 0 and 1.
fn bisect(formula: &Formula, all: &mut [f64], rng: &mut Random) {
    let (count, width) = (all.len(), formula.coordinates());
    let Ok(last) = i64::try_from(count - 1) else { return };
    for _ in 0..8 {
        let at = usize::try_from(rng.integer(0, last)).unwrap_or(0);
        let sign = |all: &[f64]| formula.sign(&all.chunks(width).collect::<Vec<_>>());
        let before = all[at];
        let mut ends = [-1.0, 2.0];
        let [low, high] = ends.map(|x| {
            all[at] = x;
            sign(all)
        });
        if low != high {
            while ends[0].next_up() < ends[1] {
                let middle = f64::midpoint(ends[0], ends[1]);
                all[at] = middle;
                ends[usize::from(sign(all) != low)] = middle;
            }
            all[at] = ends[usize::from(rng.one_in(2))];
            return;
        }
        all[at] = before;
    }
}
