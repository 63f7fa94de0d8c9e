//! The checks in reports about the parts of a mesh.

use crate::algorithm::Contradiction;
use crate::checks::Check as Law;

use predicament_tasks::Check;
use predicament_triangulate::task::RULES as TRIANGULATION;

/// The invariants that the algorithm checks during its run.
const RULES: &[&str] = Contradiction::RULES;

/// The check that corresponds to a law.
pub const fn law(law: Law) -> Check {
    Check::topology(law.name(), law.law())
}

/// The check for a law that only rounding violates.
pub const fn rounded(law: Law) -> Check {
    Check::rounded(law.name(), law.law())
}

pub(super) const CHECKS: &[Check] = &[
    law(Law::Closed),
    law(Law::Side),
    law(Law::CapInPlane),
    law(Law::CapOrientation),
    law(Law::PieceInFace),
    law(Law::PieceOrientation),
    law(Law::FaceArea),
    law(Law::Volume),
    law(Law::Degenerate),
    law(Law::SelfIntersection),
    rounded(Law::Side),
    rounded(Law::CapInPlane),
    rounded(Law::PieceInFace),
    rounded(Law::FaceArea),
    rounded(Law::Volume),
    Check::topology("vertex not finite", "every vertex of the parts is a point"),
    Check::invariants("cutting faces and covering caps does not contradict itself", &[RULES, TRIANGULATION]),
];
