//! Constructing during a run: each backend does what it declares, planted faults are found, and ids do not depend on
//! the number of threads.

mod cases;
mod complaints;
mod faults;
mod threads;

use complaints::complaints;
use faults::{Fault, Faulty};
use predicament_controls::{Epsilon, ExactRational, Naive, Pivot, Shewchuk};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Constructs};
use predicament_sos::{PerMesh, Scheme, Sos};
use predicament_tolerance::Tolerance;

fn holds<B: Backend>(backend: &B, declared: Constructs) {
    assert_eq!(backend.constructs(), declared, "{}", backend.name());
    let complaints = complaints(backend);
    assert!(complaints.is_empty(), "{}: {complaints:#?}", backend.name());
}

/// Checks the table that the backends' pages show.
#[test]
fn every_backend_does_what_it_declares() {
    holds(&Exact, Constructs::Keeps);
    holds(&ExactRational, Constructs::Keeps);
    holds(&Sos::default(), Constructs::KeepsFirst);
    holds(&Sos { scheme: Scheme::EdelsbrunnerMucke }, Constructs::Declines);
    holds(&PerMesh, Constructs::KeepsFirst);
    holds(&Tolerance, Constructs::Declines);
    holds(&Tolerance::<f32>::new(), Constructs::Declines);
    holds(&Naive::default(), Constructs::Rounds);
    holds(&Naive { pivot: Pivot::First }, Constructs::Rounds);
    holds(&Epsilon::default(), Constructs::Rounds);
    holds(&Shewchuk, Constructs::Rounds);
}

/// Each planted fault is found by the check made for it.
#[test]
fn planted_faults_are_found() {
    assert!(complaints(&Faulty(Fault::None)).is_empty(), "the wrapper alone is no fault");
    for (fault, check) in [
        (Fault::ForgetsToIntern, "interned"),
        (Fault::Sorts, "ids"),
        (Fault::KeepsThePrefix, "all or nothing"),
        (Fault::RoundsTheSecondLevel, "truth"),
        (Fault::RoundsWhatIsNew, "prepared"),
        (Fault::RoundsInBatches, "batches"),
        (Fault::DeclinesInstead, "declared"),
        (Fault::ConstructsInSecret, "declared"),
        (Fault::TakesParallels, "degenerate"),
    ] {
        let found = complaints(&Faulty(fault));
        assert!(found.iter().any(|complaint| complaint.starts_with(check)), "{fault:?} by `{check}`: {found:#?}");
    }
}
