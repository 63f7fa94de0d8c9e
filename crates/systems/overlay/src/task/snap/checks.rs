//! The checks in reports about rounded drawings.

use super::Contradiction;
use crate::task::overlay::RULES as ARRANGEMENT;
use predicament_tasks::Check;

/// The invariants that the algorithm checks during its run.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("ends", "a chain begins and ends in the pixels of its segment's ends"),
    Check::topology("hot pixels only", "a chain passes through hot pixels only"),
    Check::topology("all hot pixels", "a chain has all hot pixels that its segment meets"),
    Check::topology("own hot pixels only", "a chain has no pixel that its segment does not meet"),
    Check::topology("one way", "a chain goes one way along each axis, as its segment does"),
    Check::topology("no new crossing", "no two chains cross"),
    Check::topology("no vertex near an edge", "no edge of a chain meets a hot pixel that it does not end in"),
    Check::invariants("the arrangement does not contradict itself", &[RULES, ARRANGEMENT]),
];
