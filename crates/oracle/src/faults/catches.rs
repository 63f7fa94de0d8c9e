//! Which checks have to find each fault.
//!
//! A fault that another check finds as well shows nothing about the one that
//! was made for it: `selftest` is red if any of these finds nothing.

use predicament_tasks::{Catch, Class};

use super::Fault;

impl Fault {
    /// The checks that have to find it on the embedded corpora.
    #[must_use]
    pub const fn caught_by(self) -> &'static [Catch] {
        match self {
            Fault::SosSwappedTerm => &[
                (Class::SignFlip, "perturbed contact"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
                (Class::Topology, "crossing parity"),
                (Class::Topology, "double"),
                (Class::Topology, "loose ends"),
            ],
            Fault::SosBatchFlipped => &[(Class::SignFlip, "perturbed sign")],
            Fault::SosLateSwappedTerm => &[
                (Class::SignFlip, "half-open rule"),
                (Class::SignFlip, "perturbed sign"),
                (Class::Inconsistent, "grassmann-plucker"),
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
            Fault::SosCollidingLift => &[(Class::SignFlip, "perturbed sign"), (Class::Inconsistent, "never zero")],
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
            Fault::ExactRoundedVertex => {
                &[(Class::Overreach, "sign"), (Class::MissedZero, "sign"), (Class::SignFlip, "sign")]
            }
            Fault::ToleranceNarrow => &[(Class::MissedZero, "sign")],
            Fault::ToleranceWide => &[(Class::Overreach, "sign")],
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
            Fault::ToleranceDoubledKappa => &[(Class::Overreach, "sign"), (Class::MissedZero, "reading")],
            Fault::ToleranceDoubledLambda => &[(Class::MissedZero, "reading")],
            Fault::ToleranceHalvedMu => &[(Class::Overreach, "reading")],
        }
    }
}
