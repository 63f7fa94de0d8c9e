//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use super::{CubeUnion, Union};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<CubeUnion>> {
    vec![
        Spoiled::new(
            "cube-union-adds-to-the-volume",
            "the volume is one unit too large",
            "sos",
            &[(Class::Topology, "volume"), (Class::Topology, "shortcut")],
            |_, _, answer: &mut Union| answer.mass.volume += 1,
        ),
        Spoiled::new(
            "cube-union-adds-to-the-area",
            "the area is one unit too large",
            "sos",
            &[(Class::Topology, "area")],
            |_, _, answer: &mut Union| answer.mass.area += 1,
        ),
        Spoiled::new(
            "cube-union-adds-to-the-edges",
            "the length of the edges is one unit too large",
            "sos",
            &[(Class::Topology, "edge length")],
            |_, _, answer: &mut Union| answer.mass.edge_length += 1,
        ),
        Spoiled::new(
            "cube-union-adds-a-corner",
            "the count of corners is one too large",
            "exact",
            &[(Class::Topology, "euler characteristic"), (Class::Topology, "vertices")],
            |_, _, answer: &mut Union| answer.mass.vertices.corners += 1,
        ),
        Spoiled::new(
            "cube-union-adds-a-part",
            "the counts of vertices have a whole Euler characteristic, with one part too many",
            "exact",
            &[(Class::Topology, "euler characteristic"), (Class::Topology, "vertices")],
            |_, _, answer: &mut Union| answer.mass.vertices.corners += 8,
        ),
    ]
}
