//! The checks in reports about arrangements and overlays.

use crate::algorithm::overlay::Contradiction;
use crate::checks::overlay::Check as Law;

use predicament_tasks::Check;

/// The invariants that the algorithm checks during its run.
pub const RULES: &[&str] = Contradiction::RULES;

const fn law(law: Law) -> Check {
    Check::topology(law.name(), law.law())
}

/// The check for a law that only rounding violates.
const fn rounded(law: Law) -> Check {
    Check::rounded(law.name(), law.law())
}

pub(super) const CHECKS: &[Check] = &[
    law(Law::Nodes),
    law(Law::Chain),
    law(Law::OnSegment),
    law(Law::Edges),
    law(Law::Crossing),
    law(Law::Euler),
    law(Law::Boundary),
    law(Law::Nesting),
    law(Law::Winding),
    law(Law::Orientation),
    law(Law::ResultCrossing),
    law(Law::Area),
    law(Law::Membership),
    rounded(Law::OnSegment),
    rounded(Law::Area),
    Check::topology("shortcut", "what meets nothing can be left out without a change of the result"),
    Check::topology("vertex not finite", "every node is a point"),
    Check::invariants("the sweep and the winding numbers do not contradict themselves", &[RULES]),
];
