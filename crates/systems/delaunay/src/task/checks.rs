//! The checks of Delaunay triangulations that are reported.

use crate::algorithm::Contradiction;
use predicament_tasks::Check;

/// The invariants that the algorithm checks itself.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("vertices", "the corners of each triangle are three vertices of the scene"),
    Check::topology("copies", "each vertex is a corner, or in the place of a smaller one that is"),
    Check::topology("chain", "where all points are in one line they are in order, and else there is no such list"),
    Check::topology("positive", "each triangle is counterclockwise"),
    Check::topology("edges", "an edge is one of two triangles, in both directions, or on the hull"),
    Check::topology("hull", "the edges of one triangle make one cycle"),
    Check::topology("convex", "the cycle of the hull does not turn to the right"),
    Check::topology("wound once", "the cycle of the hull goes around once"),
    Check::topology("area", "areas add up to that of the hull"),
    Check::topology("constraint", "each constraint is a chain of edges"),
    Check::topology("crossing", "where constraints cross there is a point"),
    Check::topology("empty circle", "no circle of a triangle has the opposite vertex of a neighbour inside"),
    Check::topology("fan", "faces of vertices on one circle are fans from their smallest vertex"),
    Check::topology("empty", "no circle of a triangle has any vertex inside"),
    Check::invariants("adding points and constraints does not contradict itself", &[RULES]),
];
