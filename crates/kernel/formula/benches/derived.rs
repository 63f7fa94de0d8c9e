//! Derived predicates beside hand-made ones, on the same queries: `orient3d` and `incircle`.
//!
//! * `hand-made`: `predicament_exact::raw`.
//! * `derived`: the code that `predicament derive` writes; a test holds the files in `derived/` to the generator.
//!
//! Points are uniform: filters settle all queries, and so the estimate and its filter are timed. Both take coordinates
//! from memory in order. The two alternate pass by pass before Criterion times them, and the ratio is printed.

#[path = "derived/incircle.rs"]
#[rustfmt::skip] // the generator writes it
mod incircle;
#[path = "derived/orient3d.rs"]
#[rustfmt::skip]
mod orient3d;

use std::cmp::Ordering;
use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use predicament_exact::raw;

/// The number of queries of a pass.
const QUERIES: usize = 1 << 12;

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

fn race(name: &str, criterion: &mut Criterion, ways: [(&str, &dyn Fn() -> i32); 2]) {
    let mut best = [Duration::MAX; 2];
    let mut sums = [0; 2];
    for _ in 0..PASSES {
        for (at, (_, way)) in ways.iter().enumerate() {
            let start = Instant::now();
            sums[at] = black_box(way());
            best[at] = best[at].min(start.elapsed());
        }
    }
    assert_eq!(sums[0], sums[1], "{name}: the two disagree");
    let [hand_made, derived] = best.map(|time| time.as_secs_f64() * 1e9 / QUERIES as f64);
    println!("{name}: hand-made {hand_made:.2} ns, derived {derived:.2} ns, ratio {:.2}", derived / hand_made);
    let mut group = criterion.benchmark_group(name);
    for (way, run) in ways {
        group.bench_function(way, |bencher| bencher.iter(run));
    }
    group.finish();
}

fn all(criterion: &mut Criterion) {
    let flat: Vec<[f64; 2]> = numbers(QUERIES * 8).as_chunks().0.to_vec();
    let solid: Vec<[f64; 3]> = numbers(QUERIES * 12).as_chunks().0.to_vec();
    let sign = |sign: predicament_predicates::Sign| i32::from(sign.as_i8());
    let hand = || pass(&solid, |p: [[f64; 3]; 4]| sign(raw::orient3d(p)));
    let derived = || pass(&solid, |[a, b, c, d]| number(orient3d::orient3d(a, b, c, d)));
    race("orient3d", criterion, [("hand-made", &hand), ("derived", &derived)]);
    let hand = || pass(&flat, |p: [[f64; 2]; 4]| sign(raw::incircle(p)));
    let derived = || pass(&flat, |[a, b, c, d]| number(incircle::incircle(a, b, c, d)));
    race("incircle", criterion, [("hand-made", &hand), ("derived", &derived)]);
}

criterion_group!(benches, all);
criterion_main!(benches);
