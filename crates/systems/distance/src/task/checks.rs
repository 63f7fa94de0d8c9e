//! The checks in reports about distances.

use predicament_tasks::{Check, Class};

pub(super) const KIND: &str = "kind of distance";
pub(super) const NEAREST: &str = "nearest pair";
pub(super) const TIES: &str = "ties of distances";

pub(super) const CHECKS: &[Check] = &[
    Check::new(Class::MissedZero, KIND, "objects that have a common point are not apart"),
    Check::new(Class::Overreach, KIND, "objects without a common point are apart"),
    Check::new(Class::SignFlip, KIND, "objects that touch, cross or contain one another are told apart"),
    Check::new(
        Class::SignFlip,
        NEAREST,
        "a reported pair is at the distance of the objects, by points inside both features",
    ),
    Check::new(Class::MissedZero, TIES, "all nearest pairs are reported"),
    Check::new(Class::Overreach, TIES, "beside a nearest pair, only pairs at the same distance are reported"),
];
