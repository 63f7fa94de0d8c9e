//! The checks of the cells of a line that are reported.

use crate::checks::PartitionFault;

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology(PartitionFault::Gap.name(), "a point between the first and the last end is in a cell"),
    Check::topology(
        PartitionFault::Double.name(),
        "a point is inside at most one cell; a point at the end of a cell is not inside any cell",
    ),
    Check::topology(PartitionFault::Stray.name(), "a point beyond the first or the last end is in no cell"),
    Check::new(Class::Inconsistent, "never zero", "if ties are broken, points are not at an end"),
    Check::new(Class::SignFlip, "half-open rule", "if ties are broken, a point is in its cell of the perturbed scene"),
    Check::new(Class::MissedZero, "cells", "a point at an end is reported there"),
    Check::new(Class::Overreach, "cells", "a point that is reported at an end is there"),
    Check::new(Class::SignFlip, "cells", "a point is reported in its cell"),
];
