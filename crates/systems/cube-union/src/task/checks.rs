//! The checks of unions of cubes that are reported.

use predicament_tasks::Check;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("volume", "the volume equals the sum over all sections"),
    Check::topology("area", "the area equals the sum over all sections"),
    Check::topology("edge length", "the length of the edges equals the sum over all sections"),
    Check::topology("vertices", "if ties are broken, the number of vertices of each kind is as defined"),
    Check::topology("euler characteristic", "the counts of vertices give a whole Euler characteristic"),
    Check::topology("part", "the measures of a part of the cubes are as defined, if there are many cubes"),
];
