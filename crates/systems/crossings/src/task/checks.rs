//! The checks of crossings along segments that are reported.

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::new(
        Class::SignFlip,
        "perturbed crossings",
        "if ties are broken, a segment has the crossings of the perturbed scene, in order",
    ),
    Check::new(Class::MissedZero, "crossings", "segments that only touch do not cross"),
    Check::new(Class::SignFlip, "crossings", "a segment has all its crossings and no others"),
    Check::new(Class::MissedZero, "order", "crossings at one place are reported as equal"),
    Check::new(Class::Overreach, "order", "crossings at different places are reported as different"),
    Check::new(Class::SignFlip, "order", "crossings are in their order along the segment"),
];
