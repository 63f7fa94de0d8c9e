//! The checks of unions of cubes that are reported.

use predicament_tasks::Check;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("volume", "the volume equals the sum over all sections"),
    Check::topology("area", "the area equals the sum over all sections"),
    Check::topology("edge length", "the length of the edges equals the sum over all sections"),
    Check::topology(
        "vertices",
        "the number of vertices of each kind is as defined, if there are few enough cubes to count them",
    ),
    Check::topology(
        "euler characteristic",
        "the counts of vertices give a whole Euler characteristic; of closed cubes, that of the counted cells",
    ),
    Check::topology("shortcut", "the sums by cells, which ask no session, are those of proved signs"),
    Check::topology("part", "the measures of a part of the cubes are as defined, if there are many cubes"),
];
