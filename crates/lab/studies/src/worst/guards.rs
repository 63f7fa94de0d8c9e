//! The lemmas: the smallest value of a guarded quantity if no sub-pair is registered.
//!
//! The lemmas assume that the pair is within T₊ or crosses and no sub-pair is within T₋, by exact distances; other
//! places are forbidden. The search maximizes the inverse of the smallest quotient of a guarded quantity and its bound.

use predicament_contacts::checks::audit::PairKind;
use predicament_corpus::Random;
use predicament_formats::bits::power_of_two;
use predicament_predicates::Dimension;
use predicament_tasks::{Stop, Watch};
use predicament_tolerance::Float;
use rayon::prelude::*;

use super::climb::climb;
use crate::Precision;
use crate::audit::{Algorithm, Form, Scheme, ThresholdPairs, exactly};

/// The least guard of an algorithm.
#[derive(Clone, PartialEq, Debug)]
pub struct Guard {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// The precision whose ε determines the tolerances, as parts of L.
    pub precision: Precision,
    /// The smallest quotient found of a guarded quantity and its bound.
    pub least: f64,
    /// The pair with that quotient.
    pub pair: [Vec<[f64; 3]>; 2],
}

type Pair = [Vec<[f64; 3]>; 2];

/// Searches for the least guard of each algorithm that has any, with L = 1.
///
/// # Errors
/// [`Stop`] if the watch says so; it counts algorithms.
pub fn guards(effort: [u64; 2], seed: u64, watch: &Watch) -> Result<Vec<Guard>, Stop> {
    let with_any = Algorithm::all().filter(|algorithm| algorithm.kind != PairKind::VertexVertex);
    let rows: Vec<(Algorithm, Precision)> =
        with_any.flat_map(|a| Precision::ALL.map(|precision| (a, precision))).collect();
    let one = |(algorithm, precision): (Algorithm, Precision)| {
        let found = match precision {
            Precision::Double => search::<f64>(algorithm, effort, seed),
            Precision::Single => search::<f32>(algorithm, effort, seed),
        };
        watch.done(1)?;
        Ok(found.map(|(height, pair)| Guard { algorithm, precision, least: 1.0 / height, pair }))
    };
    let found: Result<Vec<Option<Guard>>, Stop> = rows.into_par_iter().map(one).collect();
    Ok(found?.into_iter().flatten().collect())
}

fn search<F: Float>(algorithm: Algorithm, [climbs, steps]: [u64; 2], seed: u64) -> Option<(f64, Pair)> {
    let dimension = algorithm.dimension;
    let scheme = Scheme::<F>::new(dimension, 1.0, Form::Corrected);
    let (bands, thresholds) = (scheme.bands(), scheme.thresholds());
    let value = |pair: &Pair| {
        let [first, second] = pair;
        let fits = (0..3).all(|axis| {
            let all = || first.iter().chain(second).map(|point| point[axis]);
            all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min) <= 1.0
        });
        let guard = bands.guard(&exactly(dimension, first, second)).filter(|_| fits)?;
        Some(1.0 / guard.sqrt())
    };
    let unit = thresholds.tau[1];
    let change = |random: &mut Random, from: &Pair| {
        let mut to = from.clone();
        let by = |random: &mut Random| unit * random.between(-1.0, 1.0) * power_of_two(-random.integer(0, 20));
        if random.one_in(4) {
            // all of it larger or smaller
            let factor = 1.0 + random.between(-1.0, 1.0) * power_of_two(-random.integer(3, 20));
            to.iter_mut().flatten().flatten().for_each(|x| *x *= factor);
        } else {
            let count = from[0].len() + from[1].len();
            let at = usize::try_from(random.integer(0, i64::try_from(count).expect("few") - 1)).expect("not negative");
            let vertex = to.iter_mut().flatten().nth(at).expect("one of the vertices");
            vertex[..dimension.count()].iter_mut().for_each(|x| *x += by(random));
        }
        to
    };
    let mut random = Random::new("worst", &format!("guard {}", algorithm.number()), seed);
    let mut pairs = ThresholdPairs::new(seed, thresholds, |x| x);
    let mut draw = || -> Pair {
        loop {
            let pair: Pair = match dimension {
                Dimension::Two => pairs
                    .plane(algorithm.kind.ranks())
                    .map(|simplex| simplex.into_iter().map(|[x, y]| [x, y, 0.0]).collect()),
                Dimension::Three => pairs.space(algorithm.kind.ranks()),
            };
            // about the origin, so that changes of size change nothing else
            let origin = pair[1][0];
            let pair = pair.map(|simplex| {
                simplex.into_iter().map(|point| std::array::from_fn(|i| point[i] - origin[i])).collect()
            });
            if value(&pair).is_some() {
                return pair;
            }
        }
    };
    let mut best: Option<(f64, Pair)> = None;
    for _ in 0..climbs {
        // the best of some random starts
        let beginnings: Vec<Pair> = (0..20).map(|_| draw()).collect();
        let start =
            beginnings.into_iter().max_by(|a, b| f64::total_cmp(&value(a).unwrap_or(0.0), &value(b).unwrap_or(0.0)));
        let start = start.expect("twenty");
        let found = climb(&mut random, [1, steps], |_| start.clone(), change, value);
        if found.as_ref().map(|(height, _)| *height) > best.as_ref().map(|(height, _)| *height) {
            best = found;
        }
    }
    best
}
