//! Pairs at the thresholds, one after the other, on all threads.
//!
//! A stream is cut into chunks of a fixed size, each with a separate seed and L, so the counts do not depend on the
//! number of threads.

use crate::audit::ThresholdPairs;
use predicament_contacts::checks::audit::{Pair, Verdict};
use predicament_predicates::Dimension;
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::Float;
use rayon::prelude::*;
use sha2::{Digest, Sha256};

use super::tally::{NEAR, Tally, Violation};
use super::{Row, Scheme};
use crate::Precision;

/// The number of decisions in a chunk.
pub(super) const CHUNK: u64 = 1 << 12;

/// The counts of a row's decisions, each judged.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts decisions.
pub fn audit(row: Row, decisions: u64, seed: u64, watch: &Watch) -> Result<Tally, Stop> {
    let chunk = |at: u64| {
        let count = CHUNK.min(decisions - at * CHUNK);
        let tally = match row.precision {
            Precision::Double => judge::<f64>(row, count, draw("audit", row, seed, at)),
            Precision::Single => judge::<f32>(row, count, draw("audit", row, seed, at)),
        };
        watch.done(count).map(|()| tally)
    };
    let chunks = (0..decisions.div_ceil(CHUNK)).into_par_iter().map(chunk);
    chunks.try_reduce(Tally::default, |tally, later| Ok(tally.plus(later)))
}

/// The seed of a chunk, and a number that determines its L.
pub(super) fn draw(what: &str, row: Row, seed: u64, chunk: u64) -> [u64; 2] {
    let name = format!("{what} {} {} {} {seed} {chunk}", row.algorithm.number(), row.precision.name(), row.variant());
    let digest: [u8; 32] = Sha256::digest(name).into();
    [0, 8].map(|at| u64::from_le_bytes(std::array::from_fn(|i| digest[at + i])))
}

/// A random length in [2⁻¹⁰⁰, 2¹⁰⁰), in single precision in [2⁻¹², 2¹⁶).
///
/// All powers of two are equally likely. The limits keep L⁶ a normal number.
pub(super) fn length(precision: Precision, bits: u64) -> f64 {
    let [low, high]: [i32; 2] = match precision {
        Precision::Double => [-100, 100],
        Precision::Single => [-12, 16],
    };
    #[allow(clippy::cast_precision_loss)] // 52 bits fit
    let fraction = (bits >> 12) as f64 * 2.0_f64.powi(-52);
    let span = u64::from(low.abs_diff(high));
    let halvings = i32::try_from(bits % span).expect("less than the span");
    (1.0 + fraction) * 2.0_f64.powi(low + halvings)
}

/// The counts of one chunk.
fn judge<F: Float>(row: Row, decisions: u64, [seed, bits]: [u64; 2]) -> Tally {
    let dimension = row.algorithm.dimension;
    let scheme = Scheme::<F>::new(dimension, length(row.precision, bits), row.form);
    let mut pairs = ThresholdPairs::new(seed, scheme.thresholds(), |x| F::nearest(x).wide());
    let bands = scheme.bands();
    let mut tally = Tally::default();
    while tally.decisions() < decisions {
        let ranks = row.algorithm.kind.ranks();
        let [first, second] = match dimension {
            Dimension::Two => pairs.plane(ranks).map(|simplex| simplex.into_iter().map(|[x, y]| [x, y, 0.0]).collect()),
            Dimension::Three => pairs.space(ranks),
        };
        if scheme.has_registered_faces(&first, &second) {
            tally.ended += 1;
            continue;
        }
        let got = scheme.ask(&first, &second);
        let pair = exactly(dimension, &first, &second);
        let judgement = bands.judge(&pair, got.as_ref());
        let is_near = |off: Option<f64>| off.is_some_and(|off| off <= NEAR);
        let near = if pair.is_top() {
            pair.facets().iter().any(|facet| is_near(bands.from_threshold(facet)))
        } else {
            is_near(judgement.from_threshold)
        };
        tally.note(&judgement, got.is_some(), near);
        if !judgement.verdict.is_legal() && tally.first.is_none() {
            let length = scheme.tolerances.length().wide();
            tally.first = Some(violation(judgement.verdict, length, &pair, [first, second]));
        }
    }
    tally
}

/// The record of a decision that broke the guarantee.
pub(super) fn violation(verdict: Verdict, length: f64, exact: &Pair, pair: [Vec<[f64; 3]>; 2]) -> Violation {
    Violation { verdict, length, pair, distance: exact.distance_squared().to_f64().sqrt() }
}

/// The pair in integers; points of the plane have z = 0.
#[must_use]
pub fn exactly(dimension: Dimension, first: &[[f64; 3]], second: &[[f64; 3]]) -> Pair {
    match dimension {
        Dimension::Two => {
            let flat = |simplex: &[[f64; 3]]| simplex.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>();
            Pair::new(&flat(first), &flat(second))
        }
        Dimension::Three => Pair::new(first, second),
    }
}
