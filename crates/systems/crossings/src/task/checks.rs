//! The checks of crossings along segments that are reported.

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::new(
        Class::SignFlip,
        "perturbed crossings",
        "where ties are broken a segment has the crossings of the perturbed scene, in order",
    ),
    Check::new(Class::MissedZero, "crossings", "segments that only touch do not cross"),
    Check::new(Class::SignFlip, "crossings", "a segment crosses those that it crosses"),
    Check::new(Class::MissedZero, "order", "crossings at one place are told to be at one place"),
    Check::new(Class::Overreach, "order", "crossings at different places are told apart"),
    Check::new(Class::SignFlip, "order", "crossings are in their order along the segment"),
];
