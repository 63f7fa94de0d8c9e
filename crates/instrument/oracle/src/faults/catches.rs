//! The checks that must detect each fault.
//!
//! A fault that another check detects too proves nothing about the check that was made for it: `selftest` fails if any
//! of these checks does not detect its fault.

use predicament_predicates::{Derived, Dimension};
use predicament_tasks::{Catch, Class};
use predicament_tolerance::Misscaled;

use super::Fault;

impl Fault {
    /// The checks that must detect the fault on the embedded corpora.
    #[must_use]
    pub fn caught_by(self) -> &'static [Catch] {
        match self {
            Fault::SosSwappedTerm => &[
                (Class::SignFlip, "perturbed contact"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Topology, "crossing parity"),
                (Class::Topology, "double"),
                (Class::Topology, "loose ends"),
            ],
            Fault::SosBatchFlipped => {
                &[(Class::SignFlip, "perturbed sign"), (Class::Inconsistent, "independence-of-place")]
            }
            Fault::SosLateSwappedTerm => &[
                (Class::SignFlip, "half-open rule"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Inconsistent, "independence-of-later-vertices"),
                (Class::Topology, "double"),
                (Class::Topology, "vertices"),
            ],
            Fault::SosDroppedParity => &[
                (Class::SignFlip, "half-open rule"),
                (Class::SignFlip, "perturbed contact"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Inconsistent, "argument order"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Topology, "double"),
                (Class::Topology, "loose ends"),
                (Class::Topology, "vertices"),
            ],
            Fault::SosPlaceAsIdentity => &[
                (Class::SignFlip, "half-open rule"),
                (Class::SignFlip, "perturbed contact"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Inconsistent, "argument order"),
                (Class::Topology, "crossing parity"),
                (Class::Topology, "double"),
                (Class::Topology, "loose ends"),
                (Class::Topology, "vertices"),
            ],
            Fault::SosDroppedLastParity => &[
                (Class::SignFlip, "half-open rule"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Inconsistent, "argument order"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Topology, "double"),
                (Class::Topology, "vertices"),
            ],
            Fault::SosFirstOrderOnly => &[
                (Class::SignFlip, "perturbed contact"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Inconsistent, "never degenerate"),
                (Class::Inconsistent, "never zero"),
                (Class::Inconsistent, "unbroken-tie"),
                (Class::Topology, "crossing parity"),
            ],
            Fault::SosFirstOrderThenParity => &[
                (Class::SignFlip, "perturbed contact"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Topology, "crossing parity"),
                (Class::Topology, "loose ends"),
            ],
            Fault::SosMixedOrders => &[(Class::SignFlip, "perturbed sign")],
            Fault::ExactTightFilter => &[(Class::SignFlip, "sign")],
            Fault::SosCollidingLift => &[
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "never zero"),
                (Class::Inconsistent, "mixed-grassmann-plucker"),
                (Class::Topology, "empty"),
            ],
            Fault::SosCircularTies => &[(Class::Inconsistent, "transitivity")],
            Fault::SosAloneOnSphere => {
                &[(Class::SignFlip, "perturbed sign"), (Class::Inconsistent, "grassmann-plucker")]
            }
            Fault::ExactRelativeFilter => &[(Class::SignFlip, "sign"), (Class::MissedZero, "sign")],
            Fault::ExactStaleBound => &[(Class::SignFlip, "sign")],
            Fault::ExactNan => &[(Class::Nan, "sign")],
            Fault::ExactHalvedFilter => &[(Class::SignFlip, "sign"), (Class::Inconsistent, "antisymmetry")],
            Fault::ExactOneLimb => &[
                (Class::SignFlip, "sign"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Inconsistent, "grassmann-plucker"),
            ],
            Fault::ExactUnguarded => &[
                (Class::Overreach, "sign"),
                (Class::MissedZero, "sign"),
                (Class::SignFlip, "sign"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Inconsistent, "grassmann-plucker"),
            ],
            Fault::ExactFlushed => &[
                (Class::Overreach, "cells"),
                (Class::Overreach, "false-boundary"),
                (Class::Overreach, "sign"),
                (Class::Inconsistent, "grassmann-plucker"),
            ],
            Fault::ExactRoundedVertex => &[
                (Class::Overreach, "sign"),
                (Class::MissedZero, "sign"),
                (Class::SignFlip, "sign"),
                (Class::Topology, "cap not in its plane"),
                (Class::Topology, "node off its segment"),
                (Class::Topology, "undiscovered crossing"),
                (Class::Topology, "winding"),
            ],
            Fault::ToleranceNarrow => &[(Class::MissedZero, "sign")],
            Fault::ToleranceWide | Fault::ToleranceBoastfulFormula => &[(Class::Overreach, "sign")],
            Fault::CompareGreaterOnTies => &[
                (Class::SignFlip, "half-open rule"),
                (Class::Inconsistent, "antisymmetry"),
                (Class::Topology, "double"),
                (Class::Topology, "vertices"),
            ],
            Fault::ContactsEndlessEdge => &[(Class::Overreach, "contact"), (Class::Topology, "crossing parity")],
            Fault::ContactsOneSided => &[(Class::SignFlip, "contact"), (Class::Topology, "crossing parity")],
            Fault::ToleranceNarrowContacts => &[(Class::MissedZero, "band"), (Class::MissedZero, "unguarded")],
            Fault::ToleranceWideContacts => &[(Class::Overreach, "band")],
            Fault::ToleranceAsPrinted => &[
                (Class::Overreach, "band"),
                (Class::MissedZero, "band"),
                (Class::SignFlip, "band"),
                (Class::Topology, "crossing parity"),
            ],
            Fault::ToleranceMirroredWeight => &[(Class::Inconsistent, "weights"), (Class::Topology, "crossing parity")],
            Fault::UnsteadyAgain => &[(Class::Unstable, "repeat")],
            Fault::Misscaled(misscaled) => misscaled_caught_by(misscaled),
        }
    }

    /// The task of the check, if several tasks declare a check of this class and name.
    #[must_use]
    pub fn caught_in(self, (_, check): Catch) -> Option<&'static str> {
        match (self, check) {
            (_, "never zero") => Some("orient2d"),
            (Fault::SosSwappedTerm | Fault::SosLateSwappedTerm, "double") => Some("polygon-locate"),
            (_, "double") => Some("interval"),
            (_, "vertices") => Some("cube-union"),
            _ => None,
        }
    }

    /// True if the fault can show in a task, given by name: a fault in the queries about pairs of simplices shows only
    /// in tasks that make them, and a fault of the five predicates not in tasks of formulas.
    #[must_use]
    pub fn shows_in(self, task: &str) -> bool {
        match self {
            Fault::Misscaled(Misscaled { dimension: Dimension::Two, symbol, .. }) => {
                task == "contacts2d" || symbol == "κ" && task == "orient2d"
            }
            Fault::Misscaled(Misscaled { dimension: Dimension::Three, symbol, .. }) => {
                task == "contacts3d" || symbol == "ξ" && task == "orient3d"
            }
            Fault::ToleranceBoastfulFormula => Derived::named(task).is_some(),
            Fault::SosAloneOnSphere => Derived::named(task).is_some_and(|derived| derived.formula().is_determinant()),
            Fault::ContactsEndlessEdge
            | Fault::ContactsOneSided
            | Fault::ToleranceNarrowContacts
            | Fault::ToleranceWideContacts
            | Fault::ToleranceAsPrinted
            | Fault::ToleranceMirroredWeight => task.starts_with("contacts"),
            Fault::UnsteadyAgain => task == "orient2d",
            _ => Derived::named(task).is_none(),
        }
    }
}

/// The checks for a wrongly scaled tolerance. They depend on its use: registered up to it, or not beyond it, and
/// whether a predicate's band uses it.
fn misscaled_caught_by(misscaled: Misscaled) -> &'static [Catch] {
    match (misscaled.symbol, misscaled.halved) {
        ("σ", false) => &[(Class::Overreach, "band")],
        ("σ", true) => &[(Class::MissedZero, "band")],
        ("τ" | "δ" | "γ", false) => &[(Class::Overreach, "reading")],
        ("τ", true) => &[(Class::MissedZero, "reading")],
        ("δ" | "γ", true) => &[(Class::MissedZero, "band")],
        ("κ" | "ξ", false) => &[(Class::Overreach, "sign"), (Class::MissedZero, "reading")],
        (_, false) => &[(Class::MissedZero, "reading")],
        (_, true) => &[(Class::Overreach, "reading")],
    }
}
