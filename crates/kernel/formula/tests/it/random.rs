//! Random polynomials: filter and exact stages against rationals, on inputs near and on the zero set.

// Small numbers, and random bits of which any part is as good.
#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]

use std::cmp::Ordering;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread;

use predicament_effort::{some_or_all, whole};
use predicament_formula::{Definition, Formula};
use predicament_judge::formula_value;

use crate::common::{HAND_MADE, Input, Random, formula, slices, solve};

/// A random formula of degree up to 6 in up to 12 coordinates.
fn random_formula(random: &mut Random) -> Formula {
    loop {
        let dimension = 1 + random.below(3) as usize;
        let points = (2 + random.below(4) as usize).min(12 / dimension);
        let terms = 2 + random.below(3);
        let mut text = String::new();
        for term in 0..terms {
            if term > 0 {
                text += if random.below(2) == 0 { " + " } else { " - " };
            }
            for factor in 0..1 + random.below(6) {
                let name = |random: &mut Random| (b'a' + random.below(points as u64) as u8) as char;
                let axis = |random: &mut Random| ["x", "y", "z"][random.below(dimension as u64) as usize];
                if factor > 0 {
                    text += " * ";
                }
                let (p, q, axis) = (name(random), name(random), axis(random));
                text += &match random.below(7) {
                    0 => format!("{p}.{axis}"),
                    1 if factor == 0 => format!("{} * {p}.{axis}", 2 + random.below(7)),
                    2 => format!("({p}.{axis} + {q}.{axis})"),
                    3 => {
                        let (r, s) = (name(random), name(random));
                        format!("(({p}.{axis} - {q}.{axis}) * ({r}.{axis} - {s}.{axis}) - ({p}.{axis} - {s}.{axis}))")
                    }
                    _ => format!("({p}.{axis} - {q}.{axis})"),
                };
            }
        }
        let definition = Definition { dimension: Some(dimension), ..Definition::anonymous(&text) };
        if let Ok(formula) = Formula::new(definition)
            && (2..=6).contains(&formula.polynomial().degree())
        {
            return formula;
        }
    }
}

/// The numbers of inputs, of certain signs and of ties among some inputs of a formula; panics at a wrong sign.
fn check(formula: &Formula, inputs: usize, random: &mut Random) -> [usize; 3] {
    let mut seen = [0; 3];
    for at in 0..inputs {
        let kind = Input::ALL[at % Input::ALL.len()];
        let mut points = kind.points(formula, random);
        if (at / Input::ALL.len()).is_multiple_of(2)
            && matches!(kind, Input::Uniform | Input::Far | Input::Mixed | Input::Grid | Input::Faint)
        {
            solve(formula, &mut points, random);
        }
        let slices = slices(&points);
        let truth = formula_value(formula, &slices).expect("finite").cmp0();
        let context = || format!("{} at {points:?} ({kind:?})", formula.text());
        let certain = formula.certain(&slices);
        assert!(certain.is_none_or(|sign| sign == truth), "filter: {}", context());
        assert_eq!(formula.unfiltered(&slices).0, truth, "exact: {}", context());
        seen[0] += 1;
        seen[1] += usize::from(certain.is_some());
        seen[2] += usize::from(truth == Ordering::Equal);
    }
    seen
}

/// The sum of what [`check`] has seen for this many random formulas, each with a seed of its own.
///
/// In full, a thread runs on each core: the formulas take about five minutes on one.
fn check_random(formulas: usize, inputs: usize) -> [usize; 3] {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut seen = [0; 3];
        loop {
            let at = next.fetch_add(1, Relaxed);
            if at >= formulas {
                return seen;
            }
            let mut random = Random(2026 + at as u64);
            let one = check(&random_formula(&mut random), inputs, &mut random);
            seen = std::array::from_fn(|i| seen[i] + one[i]);
        }
    };
    let threads = if whole() { thread::available_parallelism().map_or(1, usize::from) } else { 1 };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let join = |worker: thread::ScopedJoinHandle<'_, _>| worker.join().unwrap_or_else(|why| resume_unwind(why));
        workers.into_iter().map(join).fold([0; 3], |sum, one| std::array::from_fn(|i| sum[i] + one[i]))
    })
}

#[test]
fn signs_of_random_polynomials_are_right() {
    let all @ [inputs, certain, ties] = check_random(50, some_or_all(700, 100_000));
    println!("{inputs} inputs, {certain} settled by the filter, {ties} ties, 0 wrong");
    assert!(certain > inputs / 4 && ties > inputs / 100, "{all:?}");
}

#[test]
fn signs_of_the_determinants_are_right() {
    let mut random = Random(4);
    for (name, text, dimension) in HAND_MADE {
        let [inputs, certain, ties] = check(&formula(text, dimension), some_or_all(3000, 300_000), &mut random);
        assert!(certain > inputs / 4 && ties > inputs / 30, "{name}: {inputs} {certain} {ties}");
    }
}
