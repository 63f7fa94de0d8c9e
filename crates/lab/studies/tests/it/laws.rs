//! The laws hold for our backends, and detect every planted fault without a judge.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

use predicament_effort::some_or_all;
use predicament_laws::axioms::Law;
use predicament_oracle::faults::Fault;
use predicament_studies::laws::{Row, Survey, survey};
use predicament_tasks::{Stop, Watch};

use crate::backend;

fn rows(name: &str, plan: Survey) -> Vec<Row> {
    let (flag, told) = (AtomicBool::new(false), AtomicU64::new(0));
    let tell = |tuples: u64| {
        told.fetch_add(tuples, Relaxed);
    };
    let rows = survey(backend(name).as_ref(), plan, &Watch::new(&flag, None, &tell)).unwrap();
    assert_eq!(told.into_inner(), plan.total(), "what progress was promised");
    rows
}

const SOME: Survey = Survey { tuples: 5_000, seed: 1 };

/// The broken laws that need no reference.
fn broken(rows: &[Row]) -> Vec<Law> {
    let mut laws: Vec<Law> =
        rows.iter().filter(|row| !row.holds() && row.law != Law::Reference).map(|row| row.law).collect();
    laws.dedup();
    laws
}

#[test]
fn what_is_proved_keeps_every_law() {
    for name in ["exact", "sos", "sos:edelsbrunner-mucke", "tolerance"] {
        let rows = rows(name, SOME);
        for row in &rows {
            assert!(row.holds(), "{name}: {row:?}");
        }
        let on_sphere = |law: Law| rows.iter().any(|row| row.law == law && row.subject == "orient_on_sphere");
        assert!([Law::Antisymmetry, Law::GrassmannPlucker].into_iter().all(on_sphere), "a determinant of vectors");
        let declined: Vec<Law> = rows.iter().filter(|row| row.is_declined()).map(|row| row.law).collect();
        match name {
            "exact" => assert!(declined.iter().all(|&law| law == Law::NeverZero), "{declined:?}"),
            "tolerance" => assert!(declined.len() < rows.len() / 2, "{declined:?}"),
            _ => {
                assert_eq!(declined, []);
                assert_eq!(rows.iter().map(|row| row.tuples).sum::<u64>(), SOME.total());
            }
        }
    }
}

/// This test does not compare the faults with the truth or a judge of ties.
#[test]
fn every_wrong_perturbation_is_condemned_by_the_laws_alone() {
    let zero = Law::NeverZero;
    let anti = Law::Antisymmetry;
    let (plucker, mixed) = (Law::GrassmannPlucker, Law::MixedGrassmannPlucker);
    let faults: [(Fault, &[Law]); 9] = [
        (Fault::SosSwappedTerm, &[plucker, mixed]),
        (Fault::SosDroppedParity, &[anti, plucker, mixed]),
        (Fault::SosPlaceAsIdentity, &[anti]),
        (Fault::SosDroppedLastParity, &[anti, plucker, mixed]),
        (Fault::SosFirstOrderOnly, &[zero, plucker, mixed]),
        (Fault::SosFirstOrderThenParity, &[plucker, mixed]),
        (Fault::SosCollidingLift, &[zero, plucker, mixed]),
        (Fault::SosMixedOrders, &[mixed]),
        (Fault::CompareGreaterOnTies, &[anti, mixed]),
    ];
    // Each of them takes a second, and the report card of `selftest` has them all.
    for (fault, laws) in faults.into_iter().step_by(some_or_all(5, 1)) {
        let rows = rows(&format!("fault:{}", fault.name()), SOME);
        let reference = rows.iter().find(|row| row.law == Law::Reference && !row.holds());
        assert_eq!(reference, None, "{}: it is wrong about ties only", fault.name());
        assert_eq!(broken(&rows), laws, "{}", fault.name());
    }
}

#[test]
fn another_seed_makes_other_scenes() {
    let few = Survey { tuples: some_or_all(5_000, 20_000), seed: 3 };
    let one = rows("naive", few);
    assert!(one.iter().any(|row| row.violations > 0 && row.first.is_some()));
    assert_ne!(one, rows("naive", Survey { seed: 4, ..few }));
}

#[test]
fn a_violation_can_be_repeated_by_hand() {
    let rows = rows("fault:compare-greater-on-ties", Survey { tuples: 0, seed: 1 });
    let first = rows.iter().find(|row| row.law == Law::Antisymmetry).and_then(|row| row.first.clone()).unwrap();
    assert!(first.to_string().starts_with("antisymmetry broken: compare("), "{first}");
    assert!(first.to_string().ends_with("[exhaustive]"), "{first}");
    assert_eq!(first.points.len(), 2);
    assert_eq!(first.points[0].1.iter().zip(&first.points[1].1).filter(|(a, b)| a == b).count(), 1, "a tie: {first}");
}

#[test]
fn an_interrupt_is_heard() {
    let flag = AtomicBool::new(true);
    let quiet = |_: u64| {};
    let stopped = survey(backend("exact").as_ref(), SOME, &Watch::new(&flag, None, &quiet));
    assert_eq!(stopped, Err(Stop::Interrupted));
}
