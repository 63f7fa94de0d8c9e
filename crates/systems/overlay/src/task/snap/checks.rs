//! The checks in reports about rounded drawings.

use super::Contradiction;
use crate::task::overlay::RULES as ARRANGEMENT;
use predicament_tasks::Check;

/// The invariants that the algorithm checks during its run.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("ends", "a chain begins and ends in the pixels of its segment's ends"),
    Check::topology("hot pixels only", "a chain passes through hot pixels only"),
    Check::topology("all hot pixels", "a chain passes all hot pixels that its segment meets"),
    Check::topology("own hot pixels only", "a chain passes only hot pixels that its segment meets"),
    Check::topology("one way", "a chain is monotone along each axis, as its segment is"),
    Check::topology("no new crossing", "two chains do not cross"),
    Check::topology("no vertex near an edge", "an edge of a chain meets only the hot pixels of its ends"),
    Check::invariants("the arrangement does not contradict itself", &[RULES, ARRANGEMENT]),
];
