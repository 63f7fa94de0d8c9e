//! The checks in reports about signs.

use predicament_laws::axioms::Law;

use crate::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::new(Class::SignFlip, "sign", "no sign is the opposite of the exact one"),
    Check::new(Class::Overreach, "sign", "no zero is answered beyond what the backend may call zero"),
    Check::new(Class::MissedZero, "sign", "no sign is answered to what the backend has to call zero"),
    Check::new(Class::Nan, "sign", "no zero stands for a NaN"),
    Check::new(Class::Inconsistent, "never zero", "where ties are broken no answer is zero"),
    Check::new(Class::SignFlip, "perturbed sign", "a broken tie has the sign of the perturbed determinant"),
    Check::new(Class::Inconsistent, Law::Antisymmetry.name(), "a sign changes with each exchange of two arguments"),
    Check::new(Class::Inconsistent, Law::Transitivity.name(), "comparisons along an axis are an order"),
    Check::new(
        Class::Inconsistent,
        Law::GrassmannPlucker.name(),
        "the three-term relations between the answers to six queries hold",
    ),
    Check::new(
        Class::Inconsistent,
        Law::MixedGrassmannPlucker.name(),
        "so do those with points at infinity, between different predicates",
    )
    .with_time(),
    Check::new(Class::Inconsistent, Law::Place.name(), "an answer is the same alone and anywhere in a batch")
        .with_time(),
    Check::new(
        Class::Inconsistent,
        Law::LaterVertices.name(),
        "an answer is the same without the later half of the vertices",
    )
    .with_time(),
];
