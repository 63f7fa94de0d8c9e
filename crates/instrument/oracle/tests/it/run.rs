//! The outcomes of [`run`](predicament_oracle::run) for backends that answer, decline, always answer the same, or
//! panic.

use std::sync::Arc;

use predicament_corpus::Suite;
use predicament_formats::Manifest;
use predicament_predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};
use predicament_tasks::signs::SignQueries;
use predicament_tasks::{Class, Dispute, Entry};

use crate::common::{judged, judged_by_name, load, loaded, with_case};

/// A backend that answers positive to every query, or panics at the third.
struct Stub {
    panics: bool,
}

struct Session<'s> {
    scene: &'s Scene,
    panics: bool,
}

impl Backend for Stub {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        "stub".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["stub"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        Ok(Session { scene, panics: self.panics })
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn compare(&self, _: Axis, _: Vertex, _: Vertex) -> Sign {
        Sign::Positive
    }

    fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, c: Vertex) -> Sign {
        assert!(!self.panics || c.index() < 3, "third\nquery");
        Sign::Positive
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        Sign::Positive
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        Sign::Positive
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        Sign::Positive
    }
}

/// The loops have a corner in common, so an answer that misses the crossings says that the loops touch.
#[test]
fn a_crossing_whose_signs_are_all_within_the_band_may_be_missed() {
    let text = r#"
title = "t"
[[scene]]
name = "a-vertex-far-away"
task = "distance"
source = "by fuzzing"
analysis = "Every crossing is of an edge with an end at 2^99, which makes the bands of turns wider than the rest."
points = [[2, 1], ["0x1.fffffffffp+98", "0x1p-35"], [1, 3], ["0x1p-50", 1], [1, 3], [3, 3], ["0x1.7ffffffffp+1", "0x1.000000001p+1"], ["0x1.ffffffff8p+0", "0x1.ffffffff8p-1"]]
from = [[3, 1, 0, 2]]
to = [[7, 6, 5, 4]]
"#;
    let suite = Suite::parse(predicament_bundle::vocabulary(), "t.toml", text, None, &Manifest::default()).unwrap();
    let loaded = loaded(&suite.scenes[0]);
    for (backend, class) in [("exact", Class::Agree), ("tolerance", Class::InBand), ("naive", Class::Agree)] {
        assert_eq!(judged_by_name(&loaded, backend).counts.get(class), 1, "{backend}");
    }
}

#[test]
fn constructed_vertices_are_judged_declined_or_found_to_be_rounded() {
    for name in ["kite", "kite-order", "pyramid", "lpi-tpi-near-orient3d"] {
        let loaded = load(name);
        let outcome = |backend: &str| judged_by_name(&loaded, backend);
        let exact = outcome("exact");
        assert_eq!((exact.counts.get(Class::Agree), exact.counts.findings()), (exact.queries, 0), "{name}");
        let sos = outcome("sos");
        assert_eq!(sos.counts.get(Class::Agree) + sos.counts.get(Class::TieBroken), sos.queries, "{name}");
        assert!(sos.counts.get(Class::TieBroken) > 0 && sos.counts.findings() == 0, "{name}");
        for backend in ["sos:edelsbrunner-mucke", "sos:per-mesh", "tolerance", "fault:sos-swapped-term"] {
            let declined = outcome(backend).counts;
            assert_eq!((declined.get(Class::Declined), declined.findings()), (1, 1), "{backend} on {name}");
        }
        for backend in ["naive", "naive:first", "shewchuk", "fault:exact-rounded-vertex"] {
            let outcome = outcome(backend);
            assert!(outcome.counts.findings() > 0, "{backend} on {name}");
            assert!(outcome.findings.iter().any(|finding| finding.query_text().contains(" c")), "{backend} on {name}");
            assert_eq!(outcome.counts.get(Class::Panic), 0, "{backend} on {name}");
        }
        for fault in ["exact-halved-filter", "exact-one-limb", "exact-flushed"] {
            assert_eq!(outcome(&format!("fault:{fault}")).counts.findings(), 0, "{fault} on {name}");
        }
    }
}

#[test]
fn a_panic_is_a_finding_about_the_backend() {
    let outcome = judged(&load("kettner-a1"), &Entry::new(Stub { panics: true }));
    assert_eq!((outcome.counts.get(Class::Panic), outcome.counts.findings()), (1, 1));
    assert!(outcome.findings[0].got.contains("third query"), "{:?}", outcome.findings);
    assert_eq!(outcome.digest, None, "there are no answers");
}

#[test]
fn an_answer_that_is_always_the_same_is_flipped_inconsistent_and_no_zero() {
    let loaded = load("kettner-b2");
    let outcome = judged(&loaded, &Entry::new(Stub { panics: false }));
    assert!(outcome.counts.get(Class::SignFlip) > 0);
    assert!(outcome.counts.get(Class::Inconsistent) > 0);
    assert_eq!(outcome.counts.get(Class::Overreach), 0, "it never says zero");
    let classed: u64 =
        [Class::Agree, Class::SignFlip, Class::MissedZero].map(|class| outcome.counts.get(class)).iter().sum();
    assert!(classed <= outcome.queries && outcome.queries == loaded.count() as u64);
}

#[test]
fn signs_that_came_with_the_data_are_held_against_the_judge() {
    let mut loaded = load("kettner-b2");
    let signs = with_case(&loaded, |case, _| case.truth().downcast_ref::<Vec<Sign>>().unwrap().clone());
    let queries = loaded.content::<SignQueries>().unwrap().queries.clone();
    let mut with = |expected: Vec<Sign>| {
        loaded.content = Arc::new(SignQueries { queries: queries.clone(), expected: Some(expected) });
        with_case(&loaded, |case, _| case.dispute())
    };
    assert_eq!(with(signs.clone()), None);
    let wrong = signs.iter().enumerate().map(|(i, &sign)| if i == 4 { -sign } else { sign }).collect();
    let Some(Dispute::Signs { count, first }) = with(wrong) else { panic!("no dispute about signs") };
    assert_eq!(count, 1);
    assert!(first.contains("at query 4"), "{first}");
}
