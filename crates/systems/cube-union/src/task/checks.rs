//! The checks of unions of cubes that are reported.

use predicament_tasks::Check;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("volume", "the volume is that of all sections"),
    Check::topology("area", "the area is that of all sections"),
    Check::topology("edge length", "the length of the edges is that of all sections"),
    Check::topology("vertices", "where ties are broken there are as many vertices of each kind as the definition says"),
    Check::topology("euler characteristic", "the counts of vertices give a whole Euler characteristic"),
    Check::topology("part", "of many cubes a part is measured as the definition says"),
];
