//! The checks in reports about points in maps.

use crate::checks::Fault;

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology(Fault::Gap.name(), "a point of a tiling is in a region"),
    Check::topology(Fault::Double.name(), "a point is in two regions where these overlap only"),
    Check::topology(Fault::Misplaced.name(), "a point is in regions that are around it"),
    Check::new(Class::Overreach, Fault::FalseBoundary.name(), "a boundary that a point is found on is there"),
    Check::new(Class::MissedZero, Fault::MissedBoundary.name(), "a point on boundaries is found on all of them"),
    Check::new(Class::Inconsistent, Fault::UnbrokenTie.name(), "where ties are broken no point is on a boundary"),
    Check::topology("shortcut", "the way that users go gives the same answer"),
    Check::new(Class::SignFlip, "exact location", "a point that touches nothing is in the regions that it is in"),
    Check::new(Class::MissedZero, "exact location", "a point is on as many boundaries as it is"),
    Check::new(Class::Overreach, "exact location", "a point is in and on no others than those that it is in and on"),
];
