//! Every algorithm in both precisions at the edges of its guarantee.

use predicament_checks::audit::{Judgement, Pair, PairKind, Verdict};
use predicament_corpus::ThresholdPairs;
use predicament_predicates::Dimension;
use predicament_tolerance::Float;
use rayon::prelude::*;

use crate::algorithms::{Scheme, Simplex, kinds};

const DIMENSIONS: [Dimension; 2] = [Dimension::Two, Dimension::Three];

/// What came of the pairs of one kind.
#[derive(Default, Debug)]
struct Found {
    ended: u64,
    verdicts: [u64; Verdict::ALL.len()],
    registered: u64,
    weight_error: f64,
}

impl Found {
    fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    fn asked(&self) -> u64 {
        self.verdicts.iter().sum()
    }

    fn illegal(&self) -> u64 {
        Verdict::ALL.into_iter().filter(|verdict| !verdict.is_legal()).map(|verdict| self.count(verdict)).sum()
    }

    fn note(&mut self, Judgement { verdict, weight_error }: Judgement, registered: bool) {
        self.verdicts[verdict as usize] += 1;
        self.registered += u64::from(registered);
        self.weight_error = self.weight_error.max(weight_error.unwrap_or(0.0));
    }
}

/// Judges this many answers about one kind of pair.
fn check<F: Float>(scheme: &Scheme<F>, kind: PairKind, seed: u64, answers: u64) -> Found {
    let mut pairs = ThresholdPairs::new(seed, scheme.thresholds(), |x| F::nearest(x).wide());
    let bands = scheme.bands();
    let mut found = Found::default();
    while found.asked() < answers {
        let [first, second]: [Simplex; 2] = match scheme.dimension() {
            Dimension::Two => pairs.plane(kind.ranks()).map(|s| s.into_iter().map(|[x, y]| [x, y, 0.0]).collect()),
            Dimension::Three => pairs.space(kind.ranks()),
        };
        if scheme.has_registered_faces(&first, &second) {
            found.ended += 1;
            continue;
        }
        let got = scheme.ask(&first, &second);
        let pair = match scheme.dimension() {
            Dimension::Two => {
                let flat = |s: &Simplex| s.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>();
                Pair::new(&flat(&first), &flat(&second))
            }
            Dimension::Three => Pair::new(&first, &second),
        };
        found.note(bands.judge(&pair, got.as_ref()), got.is_some());
    }
    found
}

/// All kinds of pairs in all spaces, for one L.
fn check_all<F: Float>(length: f64, printed: bool, answers: u64) -> Vec<(Dimension, PairKind, Found)> {
    let tasks: Vec<_> = DIMENSIONS.into_iter().flat_map(|d| kinds(d).map(move |kind| (d, kind))).collect();
    let check =
        |(dimension, kind)| (dimension, kind, check(&Scheme::<F>::new(dimension, length, printed), kind, 7, answers));
    tasks.into_par_iter().map(check).collect()
}

fn assert_held<F: Float>(length: f64, answers: u64) {
    for (dimension, kind, found) in check_all::<F>(length, false, answers) {
        let name = format!("{} {dimension:?} {} at L = {length:e}: {found:?}", F::NAME, kind.name());
        assert_eq!(found.illegal(), 0, "{name}");
        assert!(found.registered > answers / 50 && found.registered < answers - answers / 50, "{name}");
        assert_eq!(found.count(Verdict::InBand) > answers / 50, !kind.is_top(dimension), "{name}");
    }
}

#[test]
fn the_guarantee_holds_in_double_precision() {
    assert_held::<f64>(1.0, 3000);
    assert_held::<f64>(1.7e40, 1000);
}

#[test]
fn the_guarantee_holds_in_single_precision() {
    assert_held::<f32>(1.0, 3000);
    assert_held::<f32>(1234.5, 1000);
}

#[test]
fn as_printed_feet_are_on_the_wrong_side() {
    for found in [check_all::<f64>(1.0, true, 1000), check_all::<f32>(1.0, true, 1000)] {
        let mut above = 0;
        for (_, kind, found) in found {
            match kind {
                PairKind::VertexVertex => assert_eq!(found.illegal(), 0),
                PairKind::EdgeVertex => {
                    assert!(found.count(Verdict::Missed) > 0 && found.count(Verdict::Overreach) > 0, "{found:?}");
                }
                _ => above += found.illegal(),
            }
        }
        assert!(above > 0, "what rests on \"no degeneracy was registered\" falls with it");
    }
}

/// A million answers for each algorithm and precision, as a table:
/// `cargo test --release -p predicament-checks --test audit -- --ignored --nocapture million`
#[test]
#[ignore = "takes minutes"]
fn a_million_answers_each() {
    println!("precision,dimension,pair,form,asked,ended,registered,{},max_weight_error_over_epsilon", header());
    for printed in [false, true] {
        let answers = if printed { 100_000 } else { 1_000_000 };
        table::<f64>(printed, answers);
        table::<f32>(printed, answers);
    }
}

fn header() -> String {
    Verdict::ALL.map(Verdict::name).join(",")
}

fn table<F: Float>(printed: bool, answers: u64) {
    for (dimension, kind, found) in check_all::<F>(1.0, printed, answers) {
        let form = if printed { "as_printed" } else { "corrected" };
        let counts = found.verdicts.map(|count| count.to_string()).join(",");
        println!(
            "{},{dimension:?},{},{form},{},{},{},{counts},{:.3e}",
            F::NAME,
            kind.name(),
            found.asked(),
            found.ended,
            found.registered,
            found.weight_error / F::EPSILON.wide()
        );
        assert!(printed || found.illegal() == 0);
    }
}
