//! The audit of each algorithm's single tests, with pairs at the test's tolerance.

use predicament_contacts::checks::audit::{Bands, Readings, Symbol, Verdict};
use predicament_contacts::task::thresholds;
use predicament_corpus::Random;
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::Float;
use rayon::prelude::*;

use super::stream::{CHUNK, draw, exactly, length, violation};
use super::tally::Violation;
use super::{Row, Scheme};
use crate::Precision;

/// The relative distance within which a value counts as being at a limit, 2⁻¹⁰.
pub const NEAR_LIMIT: f64 = 1.0 / 1024.0;

/// The results of the pairs at one tolerance of one algorithm.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Reads {
    /// The number of pairs that the algorithm decided.
    pub asked: u64,
    /// The number of pairs that it registered.
    pub registered: u64,
    /// The number of values at T₋, T and T₊: up to the limit, and beyond.
    pub hits: [[u64; 2]; 3],
    /// The number of answers that contradict the single test.
    pub misread: u64,
    /// The first such answer.
    pub first: Option<Violation>,
}

impl Reads {
    /// Returns true if every limit was hit on both sides.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.hits.as_flattened().iter().all(|&hits| hits > 0)
    }

    fn plus(mut self, later: Reads) -> Reads {
        self.asked += later.asked;
        self.registered += later.registered;
        self.misread += later.misread;
        for (hits, more) in self.hits.as_flattened_mut().iter_mut().zip(later.hits.as_flattened()) {
            *hits += more;
        }
        self.first = self.first.or(later.first);
        self
    }
}

/// Queries a row's algorithm about pairs at one of the tolerances that it reads, whatever their sub-pairs are.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts pairs.
///
/// # Panics
/// If the algorithm does not read the tolerance.
pub fn read(row: Row, symbol: Symbol, pairs: u64, seed: u64, watch: &Watch) -> Result<Reads, Stop> {
    let what = format!("read {}", symbol.name());
    let chunk = |at: u64| {
        let count = CHUNK.min(pairs - at * CHUNK);
        let drawn = draw(&what, row, seed, at);
        let reads = match row.precision {
            Precision::Double => judge::<f64>(row, symbol, count, drawn),
            Precision::Single => judge::<f32>(row, symbol, count, drawn),
        };
        watch.done(count).map(|()| reads)
    };
    let chunks = (0..pairs.div_ceil(CHUNK)).into_par_iter().map(chunk);
    chunks.try_reduce(Reads::default, |reads, later| Ok(reads.plus(later)))
}

fn judge<F: Float>(row: Row, symbol: Symbol, count: u64, [seed, bits]: [u64; 2]) -> Reads {
    let dimension = row.algorithm.dimension;
    let kind = row.algorithm.kind;
    let scheme = Scheme::<F>::new(dimension, length(row.precision, bits), row.form);
    let published = scheme.published();
    let bands = Bands::published(published.clone());
    let mut random = Random::new("thresholds", "reads", seed);
    let mut reads = Reads { asked: count, ..Reads::default() };
    let away = scheme.tolerances.length().wide() / 4.0;
    for _ in 0..count {
        // Three of four are about the origin, where coordinates have the most digits.
        let origin = if random.one_in(4) { [(); 3].map(|()| random.between(-away, away)) } else { [0.0; 3] };
        let place = |point: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|i| if i < dimension.count() { F::nearest(point[i] + origin[i]).wide() } else { 0.0 })
        };
        let [first, second] = thresholds::pair(&mut random, &published, kind, symbol)
            .map(|simplex| simplex.into_iter().map(place).collect::<Vec<_>>());
        let registered = scheme.ask(&first, &second).is_some();
        let pair = exactly(dimension, &first, &second);
        for hit in Readings::of(&published, &pair).hits(&published, NEAR_LIMIT).filter(|hit| hit.symbol == symbol) {
            reads.hits[hit.limit][usize::from(hit.beyond)] += 1;
        }
        reads.registered += u64::from(registered);
        if bands.misreads(&pair, registered) {
            reads.misread += 1;
            let length = scheme.tolerances.length().wide();
            reads.first.get_or_insert_with(|| violation(Verdict::Misread, length, &pair, [first, second]));
        }
    }
    reads
}
