//! The checks in reports about points in maps.

use crate::checks::Fault;

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology(Fault::Gap.name(), "a point of a tiling is in a region"),
    Check::topology(Fault::Double.name(), "a point is in two regions only if these overlap"),
    Check::topology(Fault::Misplaced.name(), "a point is only in regions around it"),
    Check::new(Class::Overreach, Fault::FalseBoundary.name(), "a point that is reported on a boundary is on it"),
    Check::new(Class::MissedZero, Fault::MissedBoundary.name(), "a point on boundaries is reported on all of them"),
    Check::new(Class::Inconsistent, Fault::UnbrokenTie.name(), "if ties are broken, points are not on a boundary"),
    Check::topology("shortcut", "the public function gives the same answer"),
    Check::new(Class::SignFlip, "exact location", "a point that is not on a boundary is reported in its regions"),
    Check::new(Class::MissedZero, "exact location", "a point is reported on all its boundaries"),
    Check::new(Class::Overreach, "exact location", "a point is reported only in its regions and on its boundaries"),
];
