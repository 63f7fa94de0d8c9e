//! The checks in reports about signs.

use predicament_laws::axioms::Law;

use crate::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::new(Class::SignFlip, "sign", "no answer has the sign opposite to the exact sign"),
    Check::new(Class::Overreach, "sign", "the answer is zero only where the backend's promise allows zero"),
    Check::new(Class::MissedZero, "sign", "the answer is zero wherever the backend's promise requires zero"),
    Check::new(Class::Nan, "sign", "a NaN is not answered as zero"),
    Check::new(Class::Unstable, "repeat", "a query that is asked again gets the same answer"),
    Check::new(Class::Inconsistent, "never zero", "a backend that breaks ties never answers zero"),
    Check::new(Class::SignFlip, "perturbed sign", "a broken tie has the sign of the perturbed determinant"),
    Check::new(Class::Inconsistent, Law::Antisymmetry.name(), "the sign changes if two arguments are exchanged"),
    Check::new(Class::Inconsistent, Law::Transitivity.name(), "comparisons along an axis are an order"),
    Check::new(
        Class::Inconsistent,
        Law::GrassmannPlucker.name(),
        "the three-term relations between the answers to six queries hold",
    ),
    Check::new(
        Class::Inconsistent,
        Law::MixedGrassmannPlucker.name(),
        "the three-term relations between different predicates, with points at infinity, hold",
    )
    .with_time(),
    Check::new(Class::Inconsistent, Law::Place.name(), "an answer is the same alone and anywhere in a batch")
        .with_time(),
    Check::new(
        Class::Inconsistent,
        Law::LaterVertices.name(),
        "an answer is the same in a scene without the later half of the vertices",
    )
    .with_time(),
];
