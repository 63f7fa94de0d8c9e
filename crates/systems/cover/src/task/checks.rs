//! The checks in reports about covers.

use predicament_tasks::Check;

use crate::checks::Law;

pub(super) const CHECKS: &[Check] = &[
    check(Law::Disk),
    check(Law::Edge),
    check(Law::Flat),
    check(Law::Crossing),
    check(Law::Least),
    check(Law::Uncovered),
];

const fn check(law: Law) -> Check {
    Check::topology(name(law), means(law))
}

/// The name of a law in findings.
pub(super) const fn name(law: Law) -> &'static str {
    match law {
        Law::Disk => "disk",
        Law::Edge => "edge of a cover",
        Law::Flat => "flat triangle",
        Law::Crossing => "cover crosses",
        Law::Least => "least area",
        Law::Uncovered => "uncovered",
    }
}

/// The law in one line.
pub(super) const fn means(law: Law) -> &'static str {
    match law {
        Law::Disk => "the triangles of a cover are a disk on the loop's vertices, and its border is the loop",
        Law::Edge => "an edge inside a cover is not an edge of the mesh or of another cover",
        Law::Flat => "each triangle of a cover has an area",
        Law::Crossing => "triangles of a cover have only vertices and edges in common, with each other and the mesh",
        Law::Least => "no other cover has less area, beyond the error of areas in doubles",
        Law::Uncovered => "a loop is not covered only if there is no cover, and the reason is right",
    }
}
