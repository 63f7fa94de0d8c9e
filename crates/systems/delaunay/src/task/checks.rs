//! The checks of Delaunay triangulations that are reported.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

/// The invariants that the algorithm checks itself.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("vertices", "the corners of each triangle are three vertices of the scene"),
    Check::topology("copies", "each vertex is a corner, or a copy of a smaller vertex that is a corner"),
    Check::topology(
        "chain",
        "if all points are on one line, the chain lists them in order; otherwise the chain is empty",
    ),
    Check::topology("positive", "each triangle is counterclockwise"),
    Check::topology("edges", "an edge belongs to two triangles, in opposite directions, or is on the hull"),
    Check::topology("hull", "the edges with one triangle make one cycle"),
    Check::topology("convex", "the cycle of the hull does not turn to the right"),
    Check::topology("wound once", "the cycle of the hull goes around once"),
    Check::topology("area", "the areas of the triangles add up to the area of the hull"),
    Check::topology("constraint", "each constraint is a chain of edges"),
    Check::topology("crossing", "constraints cross in a vertex"),
    Check::topology("empty circle", "the circle of a triangle does not contain the opposite vertex of a neighbour"),
    Check::topology("fan", "faces of vertices on one circle are fans from their smallest vertex"),
    Check::topology("empty", "the circle of a triangle does not contain any vertex"),
    Check::topology("removal", "half of the vertices, removed and inserted again, leave no trace"),
    Check::invariants("adding points and constraints does not contradict itself", &[RULES]),
];
