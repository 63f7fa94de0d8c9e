//! The checks in reports of triangulated polygons.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

/// The invariants that the algorithm checks during its run.
pub const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("loops do not cross", "what is to be triangulated is a polygon"),
    Check::topology("vertices", "the corners of each triangle are three vertices of the polygon"),
    Check::topology("count", "there are n + 2h − 2 triangles"),
    Check::topology("positive", "each triangle is counterclockwise; flat only where loops touch, or ties are broken"),
    Check::topology("area", "areas add up to that of the polygon"),
    Check::topology("boundary", "each edge of the polygon is a side of one triangle"),
    Check::topology("diagonals", "each other side is one of two triangles, in both directions"),
    Check::topology("overlap", "no two triangles have an inner point in common"),
    Check::topology("perturbed triangles", "where ties are broken flat triangles are counterclockwise once perturbed"),
    Check::invariants("walks and ears, or a sweep, do not contradict themselves", &[RULES]),
];
