//! Derived predicates beside hand-made ones, on the same queries: `orient3d` and `incircle`.
//!
//! * `hand-made`: `predicament_exact::raw`.
//! * `derived`: the code that `predicament derive` writes; a test holds the files in `derived/` to the generator.
//! * `fpg`: the filter as FPG writes it (Meyer and Pion 2008): maxima by axis, two guards of the range, one product.
//! * `attene`: the filter of Attene's converter (2020): one maximum of all differences, and its power.
//!
//! The last two have the constants of the rule that both generators use (the test `peers`), the estimate of the derived
//! code, and exact signs of ours behind them.
//!
//! Points are uniform: filters settle all queries, and so the estimate and its filter are timed. Both take coordinates
//! from memory in order. All alternate pass by pass before Criterion times them, and the ratios are printed.

#[path = "derived/incircle.rs"]
#[rustfmt::skip] // the generator writes it
#[allow(clippy::all, clippy::pedantic)]
mod incircle;
#[path = "derived/orient3d.rs"]
#[rustfmt::skip]
#[allow(clippy::all, clippy::pedantic)]
mod orient3d;

use std::cmp::Ordering;
use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use predicament_exact::raw;

/// The number of queries of a pass.
const QUERIES: u16 = 1 << 12;

/// The number of passes whose fastest counts.
const PASSES: usize = 400;

/// Uniform doubles in [0, 1), the same in every run.
fn numbers(count: usize) -> Vec<f64> {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        f64::from_bits((state >> 12) | 1.0_f64.to_bits()) - 1.0
    };
    (0..count).map(|_| next()).collect()
}

fn pass<const D: usize, const N: usize>(points: &[[f64; D]], sign: impl Fn([[f64; D]; N]) -> i32) -> i32 {
    points.as_chunks::<N>().0.iter().map(|&query| sign(black_box(query))).sum()
}

fn number(ordering: Ordering) -> i32 {
    ordering as i32
}

/// Times ways of computing one predicate; the first is the yardstick.
fn race(name: &str, criterion: &mut Criterion, ways: &[(&str, &dyn Fn() -> i32)]) {
    let mut best = vec![Duration::MAX; ways.len()];
    let mut sums = vec![0; ways.len()];
    for _ in 0..PASSES {
        for (at, (_, way)) in ways.iter().enumerate() {
            let start = Instant::now();
            sums[at] = black_box(way());
            best[at] = best[at].min(start.elapsed());
        }
    }
    assert!(sums.iter().all(|&sum| sum == sums[0]), "{name}: two ways disagree");
    let times: Vec<f64> = best.iter().map(|time| time.as_secs_f64() * 1e9 / f64::from(QUERIES)).collect();
    for ((way, _), time) in ways.iter().zip(&times) {
        println!("{name}: {way} {time:.2} ns, ratio {:.2}", time / times[0]);
    }
    let mut group = criterion.benchmark_group(name);
    for (way, run) in ways {
        group.bench_function(*way, |bencher| bencher.iter(run));
    }
    group.finish();
}

/// The largest magnitude.
#[inline(always)]
fn largest<const N: usize>(numbers: [f64; N]) -> f64 {
    let mut most = numbers[0].abs();
    for number in &numbers[1..] {
        if most < number.abs() {
            most = number.abs();
        }
    }
    most
}

/// The sign by two comparisons, as the generators write it.
#[inline(always)]
fn beyond(value: f64, bound: f64) -> Option<i32> {
    if value > bound {
        Some(1)
    } else if value < -bound {
        Some(-1)
    } else {
        None
    }
}

/// The unit roundoff.
const U: f64 = f64::EPSILON / 2.0;

#[inline(always)]
fn differences<const D: usize>(point: [f64; D], last: [f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| point[axis] - last[axis])
}

#[inline(always)]
fn fpg_orient3d([a, b, c, d]: [[f64; 3]; 4]) -> Option<i32> {
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [a, b, c].map(|p| differences(p, d));
    let value = (az * (bx * cy - by * cx) - bz * (ax * cy - ay * cx)) + cz * (ax * by - ay * bx);
    let [x, y, z] = [largest([ax, bx, cx]), largest([ay, by, cy]), largest([az, bz, cz])];
    let (mut low, mut high) = (x, x);
    for most in [y, z] {
        if most < low {
            low = most;
        } else if most > high {
            high = most;
        }
    }
    if low < 1e-97 || high > 1e102 { None } else { beyond(value, 44.1 * U * x * y * z) }
}

#[inline(always)]
fn circle([a, b, c, d]: [[f64; 2]; 4]) -> (f64, [[f64; 2]; 3]) {
    let all @ [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|p| differences(p, d));
    let lift = |x: f64, y: f64| x * x + y * y;
    let value =
        (lift(ax, ay) * (bx * cy - by * cx) - lift(bx, by) * (ax * cy - ay * cx)) + lift(cx, cy) * (ax * by - ay * bx);
    (value, all)
}

#[inline(always)]
fn fpg_incircle(points: [[f64; 2]; 4]) -> Option<i32> {
    let (value, [[ax, ay], [bx, by], [cx, cy]]) = circle(points);
    let [x, y] = [largest([ax, bx, cx]), largest([ay, by, cy])];
    let (low, high) = if x < y { (x, y) } else { (y, x) };
    if low < 1e-73 || high > 1e76 { None } else { beyond(value, 124.1 * U * x * y * (high * high)) }
}

#[inline(always)]
fn attene_incircle(points: [[f64; 2]; 4]) -> Option<i32> {
    let (value, [[ax, ay], [bx, by], [cx, cy]]) = circle(points);
    let most = largest([ax, ay, bx, by, cx, cy]);
    let square = most * most;
    beyond(value, 124.0 * U * (square * square))
}

fn all(criterion: &mut Criterion) {
    let flat: Vec<[f64; 2]> = numbers(usize::from(QUERIES) * 8).as_chunks().0.to_vec();
    let solid: Vec<[f64; 3]> = numbers(usize::from(QUERIES) * 12).as_chunks().0.to_vec();
    let sign = |sign: predicament_predicates::Sign| i32::from(sign.as_i8());
    let hand = || pass(&solid, |p: [[f64; 3]; 4]| sign(raw::orient3d(p)));
    let derived = || pass(&solid, |[a, b, c, d]| number(orient3d::orient3d(a, b, c, d)));
    let fpg = || pass(&solid, |p| fpg_orient3d(p).unwrap_or_else(|| sign(raw::orient3d(p))));
    race("orient3d", criterion, &[("hand-made", &hand), ("derived", &derived), ("fpg", &fpg)]);
    let hand = || pass(&flat, |p: [[f64; 2]; 4]| sign(raw::incircle(p)));
    let derived = || pass(&flat, |[a, b, c, d]| number(incircle::incircle(a, b, c, d)));
    let fpg = || pass(&flat, |p| fpg_incircle(p).unwrap_or_else(|| sign(raw::incircle(p))));
    let attene = || pass(&flat, |p| attene_incircle(p).unwrap_or_else(|| sign(raw::incircle(p))));
    let ways: [(&str, &dyn Fn() -> i32); 4] =
        [("hand-made", &hand), ("derived", &derived), ("fpg", &fpg), ("attene", &attene)];
    race("incircle", criterion, &ways);
}

criterion_group!(benches, all);
criterion_main!(benches);
