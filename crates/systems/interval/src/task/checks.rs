//! The checks of the cells of a line that are reported.

use crate::checks::PartitionFault;

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology(PartitionFault::Gap.name(), "a point between the first and the last end is in a cell"),
    Check::topology(PartitionFault::Double.name(), "a point is in one cell, and where it is at the end of any in none"),
    Check::topology(PartitionFault::Stray.name(), "a point outside of the first and the last end is in no cell"),
    Check::new(Class::Inconsistent, "never zero", "where ties are broken no point is at an end"),
    Check::new(
        Class::SignFlip,
        "half-open rule",
        "where ties are broken a point is in the cell of the perturbed scene",
    ),
    Check::new(Class::MissedZero, "cells", "a point at an end is found there"),
    Check::new(Class::Overreach, "cells", "a point that is found at an end is there"),
    Check::new(Class::SignFlip, "cells", "a point is in the cell that it is in"),
];
