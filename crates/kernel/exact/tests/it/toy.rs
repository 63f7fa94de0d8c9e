//! Tiny floating-point formats, in which every input is tried: the formulas of filters are written over any numbers.
//!
//! The difference of two numbers is the rounded exact difference. So a query depends on its exact differences only, and
//! all queries are the pairs (in space, triples) of what two (three) coordinates of all points can differ by. Mirrored
//! queries round alike, so that differences along an axis begin with a positive one.
//!
//! * The filter for any doubles is never wrong, with its constant computed for the format, subnormal numbers and
//!   overflow included. Turns only: with so few bits, filters of higher degree are never certain ([`space`] samples
//!   them in formats of more bits).
//! * Errors are within ((1 + u)ⁿ − 1)·P and the loss by underflow, which is what the constants are made of.

mod linear;
mod space;

pub(crate) use space::exact as determinant_of;

use std::collections::BTreeSet;
use std::ops::{Add, Mul, Sub};

use predicament_arithmetic::Number;
use predicament_exact::{anywhere, estimate};

/// A number of the format with `P` bits, `K` exponents above the subnormal ones, and the quantum 2^−Q.
///
/// (Every exact result of one operation is a double.)
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
struct Toy<const P: i32, const K: i32, const Q: i32>(f64);

impl<const P: i32, const K: i32, const Q: i32> Toy<P, K, Q> {
    /// The largest number, in quanta: all bits, at the highest exponent.
    const MOST: i64 = ((1 << P) - 1) << (K - 1);

    /// The nearest number, ties to even; infinite beyond the largest one.
    fn rounded(x: f64) -> Self {
        if x == 0.0 || !x.is_finite() {
            return Toy(x);
        }
        let highest = i32::try_from(x.abs().to_bits() >> 52).expect("11 bits") - 1023;
        let unit = 2_f64.powi((highest + 1 - P).max(-Q));
        let rounded = (x / unit).round_ties_even() * unit;
        let most = i32::try_from(Self::MOST).map_or(f64::NAN, f64::from) * 2_f64.powi(-Q);
        Toy(if rounded.abs() > most { f64::INFINITY.copysign(x) } else { rounded })
    }

    /// The number of so many quanta, rounded.
    fn of(quanta: i64) -> Self {
        Toy::rounded(i32::try_from(quanta).map_or(f64::NAN, f64::from) * 2_f64.powi(-Q))
    }

    /// The number, or the next above it that the format has.
    fn above(x: f64) -> Self {
        let near = Toy::rounded(x);
        let next = 2_f64.powi(1 - P) * near.0;
        if near.0 < x { Toy::rounded(near.0 + next) } else { near }
    }

    /// The numbers of so many exponents above 2^`lowest` quanta, and zero, with all signs.
    fn all([lowest, exponents]: [i32; 2]) -> Vec<i64> {
        let of = |k: i32| (0..1_i64 << P).map(move |m| m << (lowest + k));
        let positive: BTreeSet<i64> = (0..exponents).flat_map(of).collect();
        positive.iter().map(|x| -x).rev().chain(positive.iter().copied().skip(1)).collect()
    }
}

macro_rules! operation {
    ($($trait:ident $method:ident),*) => {$(
        impl<const P: i32, const K: i32, const Q: i32> $trait for Toy<P, K, Q> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Toy::rounded(self.0.$method(other.0))
            }
        }
    )*};
}

operation!(Add add, Sub sub, Mul mul);

impl<const P: i32, const K: i32, const Q: i32> Number for Toy<P, K, Q> {
    const ONE: Self = Toy(1.0);
    fn abs(self) -> Self {
        Toy(self.0.abs())
    }
}

/// The differences of `N` points from a last one along an axis, in quanta; the first that is not zero is positive.
fn differences<const N: usize>(all: &[i64]) -> Vec<[i64; N]> {
    let mut found = BTreeSet::new();
    for &last in all {
        let mut at = [0; N];
        'queries: loop {
            let differences = at.map(|at: usize| all[at] - last);
            if differences.iter().find(|&&x| x != 0).is_none_or(|&x| x > 0) {
                found.insert(differences);
            }
            for place in &mut at {
                *place += 1;
                if *place < all.len() {
                    continue 'queries;
                }
                *place = 0;
            }
            break;
        }
    }
    found.into_iter().collect()
}

/// The constant of orient2d for the filter for any numbers of a format, by the proof's formula, rounded up.
///
/// (1 + u)³ − 1 before the last sum, whose rounding and the four of the permanent come on top, and one for B·p and for
/// the slack each.
fn constant(u: f64) -> f64 {
    ((1.0 + u).powi(3) - 1.0) * (1.0 + u) / (1.0 - u).powi(6)
}

/// Tries the turns of the numbers in a range, of every `step`-th row all; returns the numbers of queries, and of those
/// that the filter decides.
fn every_turn<const P: i32, const K: i32, const Q: i32>(
    range: [i32; 2],
    step: usize,
    constant: f64,
) -> Result<[u64; 2], String> {
    let rows = differences::<2>(&Toy::<P, K, Q>::all(range));
    let constant = Toy::<P, K, Q>::above(constant);
    // Two products lose half a quantum each, and the permanent too.
    let slack = Toy::<P, K, Q>::of(4);
    let mut count = [0; 2];
    let zero = Toy::of(0);
    for (index, &[ax, bx]) in rows.iter().enumerate().step_by(step) {
        let [fx, gx] = [Toy::of(ax), Toy::of(bx)];
        // (The axes exchanged: the same products, exchanged.)
        for &[ay, by] in &rows[index..] {
            let bounded = anywhere::orient2d_by([[fx, Toy::of(ay)], [gx, Toy::of(by)], [zero, zero]], constant, slack);
            count[0] += 1;
            if bounded.determinant.0.abs() > bounded.bound.0 {
                count[1] += 1;
                let truth = ax * by - ay * bx;
                if (bounded.determinant.0 > 0.0) != (truth > 0) || truth == 0 {
                    return Err(format!("({ax}, {ay}) and ({bx}, {by}): {bounded:?}, and exactly {truth}"));
                }
            }
        }
    }
    Ok(count)
}

/// Products of these formats are normal; or many underflow; or many overflow.
///
/// A twentieth by day; at night also formats of more bits and exponents.
#[test]
fn no_turn_of_a_tiny_format_is_certain_and_wrong() {
    let step = predicament_effort::divisor();
    let [three, four, five] = [3, 4, 5].map(|bits| constant(2_f64.powi(-bits)));
    let mut counts = vec![
        every_turn::<4, 20, 8>([8, 2], step, four),
        every_turn::<4, 20, 8>([3, 2], step, four),
        every_turn::<4, 11, 8>([7, 2], step, four),
        every_turn::<3, 6, 4>([0, 3], 1, three),
    ];
    if predicament_effort::whole() {
        counts.push(every_turn::<3, 6, 5>([0, 6], 1, three));
        counts.push(every_turn::<5, 22, 9>([9, 2], 1, five));
        counts.push(every_turn::<5, 22, 9>([4, 2], 1, five));
    }
    for count in counts {
        let [all, decided] = count.unwrap_or_else(|why| panic!("{why}"));
        println!("{decided} of {all} turns are certain");
        assert!(all > 100_000 && decided > all / 100, "{decided} of {all}");
    }
}

#[test]
fn a_constant_that_is_too_small_is_found() {
    assert!(every_turn::<4, 20, 8>([8, 2], 1, 1.0 / 16.0).is_err());
}

/// The bound on an error: n + 1 roundings of the permanent, and what underflow loses, with n roundings after it.
fn bound([permanent, lost]: [f64; 2], u: f64, n: i32) -> f64 {
    ((1.0 + u).powi(n + 1) - 1.0) * permanent + lost * (1.0 + u).powi(n)
}

/// Tries the circles of the numbers in a range: errors are within `n` roundings before the last sum, and the loss by
/// underflow.
fn every_circle<const P: i32, const K: i32, const Q: i32>(range: [i32; 2], step: usize, n: i32) -> Result<u64, String> {
    let rows = differences::<3>(&Toy::<P, K, Q>::all(range));
    let u = 2_f64.powi(-P);
    let quantum = 2_f64.powi(-Q);
    let zero = Toy::of(0);
    let mut count = 0;
    for (index, x) in rows.iter().enumerate().step_by(step) {
        for y in &rows[index..] {
            let point = |at: usize| [Toy::of(x[at]), Toy::of(y[at])];
            let found = estimate::incircle::<Toy<P, K, Q>>(point(0), point(1), point(2), [zero, zero]);
            if !found.permanent.0.is_finite() {
                continue;
            }
            count += 1;
            let lift = |at: usize| x[at] * x[at] + y[at] * y[at];
            let products = |a: usize, b: usize| [x[a] * y[b], x[b] * y[a]];
            let terms = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(a, b, c)| (lift(a), products(b, c)));
            let exact: i64 = terms.iter().map(|(lift, [l, r])| lift * (l - r)).sum();
            let permanent: i64 = terms.iter().map(|(lift, [l, r])| lift * (l.abs() + r.abs())).sum();
            let lifts: i64 = (0..3).map(lift).sum();
            #[allow(clippy::cast_precision_loss)] // below 2^53
            let [exact, permanent] = [exact, permanent].map(|x| x as f64 * quantum.powi(4));
            #[allow(clippy::cast_precision_loss)]
            let lost = quantum * 8.0 * (lifts as f64 * quantum.powi(2) + 1.0);
            // One more rounding than before the last sum, as d itself is compared.
            let bound = bound([permanent, lost], u, n);
            if (found.determinant.0 - exact).abs() > bound {
                return Err(format!("{x:?}, {y:?}: {found:?}, and exactly {exact} of {permanent}"));
            }
        }
    }
    Ok(count)
}

#[test]
fn errors_of_circles_in_a_tiny_format_are_counted() {
    let step = predicament_effort::divisor();
    let normal = every_circle::<2, 20, 0>([0, 2], step, 10);
    for count in [normal, every_circle::<2, 20, 3>([0, 2], step, 10), every_circle::<2, 8, 0>([0, 2], step, 10)] {
        let count = count.unwrap_or_else(|why| panic!("{why}"));
        println!("{count} circles");
        assert!(count > 10_000);
    }
    assert!(every_circle::<2, 20, 0>([0, 2], step, -1).is_err(), "without any rounding");
}
