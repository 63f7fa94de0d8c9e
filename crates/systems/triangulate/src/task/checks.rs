//! The checks in reports of triangulated polygons.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

/// The invariants that the algorithm checks during its run.
pub const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("vertices", "the corners of each triangle are three vertices of the polygon"),
    Check::topology("count", "there are n + 2h − 2 triangles"),
    Check::topology("positive", "each triangle is counterclockwise, or flat if loops touch there or ties are broken"),
    Check::topology("area", "the areas of the triangles add up to the area of the polygon"),
    Check::topology("boundary", "each edge of the polygon is a side of one triangle"),
    Check::topology("diagonals", "each other side belongs to two triangles, in opposite directions"),
    Check::topology("overlap", "two triangles have no inner point in common"),
    Check::topology(
        "perturbed triangles",
        "if ties are broken, flat triangles are counterclockwise in the perturbed scene",
    ),
    Check::topology(
        "area of the limit",
        "if loops cross once they are perturbed, the areas of the triangles, without signs, add up to the polygon's",
    ),
    Check::topology(
        "inside of the limit",
        "if loops cross once they are perturbed, triangles cover each inner point once, and no outer point",
    ),
    Check::invariants("walks and ears, or a sweep, do not contradict themselves", &[RULES]),
];
