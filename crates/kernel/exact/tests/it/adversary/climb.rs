//! A search for points whose roundings all go the same way.
//!
//! Rounding errs most just above powers of two, where half an ulp is nearly u times the number, and if every rounding
//! moves by half an ulp. So points start with differences just above given powers of two, and a pivot whose coordinates
//! are sums of half ulps of them. The pivot sets the direction of every difference's rounding at once. Annealing in the
//! lower bits then drives the roundings of products and sums to their limit.

use super::traced::{Formula, Traced};
use crate::common::Random;

const U: f64 = f64::EPSILON / 2.0;

/// The role of a difference of coordinates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The difference belongs to a term that should come out too large.
    Over,
    /// The difference belongs to a term that should come out too small.
    Under,
    /// The difference is tiny and steers roundings of sums; its sign doesn't matter.
    Steer,
}

/// An initial difference of coordinates.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The role of the difference.
    pub side: Side,
    /// True if the difference is negative.
    pub negative: bool,
    /// The exponent: the difference is just above two to this power.
    pub exponent: i32,
}

/// A difference of a term that should come out too large.
pub const fn over(exponent: i32) -> Entry {
    Entry { side: Side::Over, negative: false, exponent }
}

/// A difference of a term that should come out too small.
pub const fn under(exponent: i32) -> Entry {
    Entry { side: Side::Under, negative: false, exponent }
}

/// A difference that makes sums inexact.
pub const fn steer(exponent: i32) -> Entry {
    Entry { side: Side::Steer, negative: false, exponent }
}

/// The negative of a difference.
pub const fn minus(entry: Entry) -> Entry {
    Entry { negative: true, ..entry }
}

/// The parameters of a search.
pub struct Recipe<const D: usize, const N: usize> {
    /// The determinant.
    pub formula: Formula<D, N>,
    /// The differences from the pivot, which is the last point: N − 1 of them, and one unused.
    pub entries: [[Entry; D]; N],
    /// The binary logarithm of the largest initial distance above a power of two.
    pub spread: i32,
    /// The cost of |x + y| in units of u: large for errors at near ties.
    pub price: f64,
    /// The number of changes; the first seven tenths have a temperature.
    pub steps: u32,
}

/// The score of these points: (|error| − price·u·|x + y|) over u times the permanent.
pub fn badness([x, y]: [Traced; 2], price: f64) -> f64 {
    let (error, sum) = ((x.error + y.error).abs(), (x.value + y.value).abs());
    (error / U - price * sum) / (x.magnitude + y.magnitude)
}

impl<const D: usize, const N: usize> Recipe<D, N> {
    /// The final points of one run.
    pub fn climb(&self, seed: u64) -> [[f64; D]; N] {
        let mut random = Random(seed);
        let mut points = self.start(&mut random);
        let mut score = badness((self.formula)(&points), self.price);
        for step in 0..self.steps {
            let progress = f64::from(step) / (0.7 * f64::from(self.steps));
            let cooling = (1.0 - progress).max(0.0);
            let temperature = 0.08 * cooling * cooling;
            let mut moved = points;
            self.change(&mut moved, &mut random);
            let moved_score = badness((self.formula)(&moved), self.price);
            // NaN if a change has gone too far: never accepted.
            if moved_score >= score - temperature * patience(&mut random) {
                points = moved;
                score = moved_score;
            }
        }
        points
    }

    fn start(&self, random: &mut Random) -> [[f64; D]; N] {
        let mut points = [[0.0; D]; N];
        for (point, entries) in points.iter_mut().zip(&self.entries).take(N - 1) {
            for (coordinate, entry) in point.iter_mut().zip(entries) {
                let negative = if entry.side == Side::Steer { random.below(2) == 0 } else { entry.negative };
                let magnitude = power(entry.exponent) * (1.0 + random.unit() * power(self.spread));
                *coordinate = if negative { -magnitude } else { magnitude };
            }
        }
        points[N - 1] = std::array::from_fn(|axis| self.pivot(axis));
        points
    }

    /// A coordinate with half an ulp, or nearly, of each difference on this axis that matters.
    fn pivot(&self, axis: usize) -> f64 {
        let mut entries: Vec<Entry> = self.entries[..N - 1].iter().map(|entry| entry[axis]).collect();
        entries.retain(|entry| entry.side != Side::Steer);
        entries.sort_by_key(|entry| entry.exponent);
        entries.dedup_by_key(|entry| entry.exponent);
        let mut pivot = 0f64;
        for (i, entry) in entries.iter().enumerate() {
            let half = power(entry.exponent - 53);
            let half = if entry.negative == (entry.side == Side::Over) { -half } else { half };
            // Slightly less than the half, where rounding would reverse; but by whole ulps of the value so far.
            pivot += match i.checked_sub(1) {
                None => half * (1.0 - power(-10)),
                Some(below) if pivot.is_sign_negative() == half.is_sign_negative() => {
                    half - half.signum() * power(entries[below].exponent - 52)
                }
                Some(_) => half,
            };
        }
        pivot
    }

    fn change(&self, points: &mut [[f64; D]; N], random: &mut Random) {
        let (row, axis) = (random.below(N - 1), random.below(D));
        let entry = self.entries[row][axis];
        let pivot = points[N - 1][axis];
        let scaled = |x: f64, factor: f64| (x - pivot) * factor + pivot;
        let x = points[row][axis];
        match random.below(8) {
            0..=2 => {
                let row = random.below(N);
                points[row][axis] = jiggled(points[row][axis], random);
            }
            3 => points[row][axis] = scaled(x, 0.5 + random.unit()),
            4 => points[row][axis] = scaled(x, 1.0 + small(random, 26)),
            5 if entry.side == Side::Steer => points[row][axis] = scaled(x, -1.0),
            5 => points[N - 1][axis] *= 1.0 + small(random, 20),
            6 => points[N - 1][axis] += power(entry.exponent - 53) * small(random, 14),
            _ => {
                points[row][axis] = jiggled(x, random);
                let (row, axis) = (random.below(N), random.below(D));
                points[row][axis] = jiggled(points[row][axis], random);
            }
        }
    }
}

/// A nearly exponential random number, the same on every machine, as the logarithm isn't.
fn patience(random: &mut Random) -> f64 {
    std::f64::consts::LN_2 * (f64::from(random.bits().leading_zeros()) + random.unit())
}

/// The number x with some of its lower 27 bits changed.
fn jiggled(x: f64, random: &mut Random) -> f64 {
    let bits = random.below(27);
    let ulps = random.bits() % (1 << bits);
    let up = random.below(2) == 0;
    f64::from_bits(if up { x.to_bits().wrapping_add(ulps) } else { x.to_bits().wrapping_sub(ulps) })
}

/// A random number between −½ and ½, of any size down to 2^−`bits`.
fn small(random: &mut Random, bits: usize) -> f64 {
    let exponent = i32::try_from(random.below(bits)).expect("a small number");
    (random.unit() - 0.5) * power(-exponent)
}

fn power(exponent: i32) -> f64 {
    2f64.powi(exponent)
}
