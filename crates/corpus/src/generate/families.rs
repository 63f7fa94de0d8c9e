//! The families by name.

use crate::Task;

/// A family of generated scenes, for listings.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FamilyInfo {
    /// The name in `[[generate]]` tables.
    pub name: &'static str,
    /// The name in `throughput.csv`.
    pub reported_as: &'static str,
    /// The tasks that it can generate for.
    pub tasks: &'static [Task],
    /// The parameters that it takes besides `n`, `seed` and the question's.
    pub parameters: &'static [&'static str],
    /// What it is, in one line.
    pub about: &'static str,
}

const SIGNS: &[Task] = &[Task::Compare, Task::Orient2d, Task::Orient3d, Task::Incircle, Task::Insphere];
const LINES: &[Task] = &[Task::Interval];
const MAPS: &[Task] = &[Task::PolygonLocate];
const CUBES: &[Task] = &[Task::CubeUnion];
const FLAT: &[Task] = &[Task::Compare, Task::Orient2d];
const PLANE_CONTACTS: &[Task] = &[Task::Contacts2d];
const SPACE_CONTACTS: &[Task] = &[Task::Contacts3d];
const SOLID: &[Task] = &[Task::Compare, Task::Orient2d, Task::Orient3d];

const fn family(
    name: &'static str,
    reported_as: &'static str,
    tasks: &'static [Task],
    parameters: &'static [&'static str],
    about: &'static str,
) -> FamilyInfo {
    FamilyInfo { name, reported_as, tasks, parameters, about }
}

pub(super) const FAMILIES: [FamilyInfo; 41] = [
    family("uniform", "uniform", SIGNS, &[], "multiples of 2^-53, uniform in [0, 1)"),
    family("grid", "grid", SIGNS, &[], "integers from 0 to 15: many ties, all arithmetic short"),
    family("near", "near", SIGNS, &["ulps"], "moved by at most so many ulps off a line, plane, circle or sphere"),
    family(
        "kettner",
        "kettner",
        SIGNS,
        &[],
        "0.5 + k·2^-53, k < 256, against a line, plane, circle or sphere through 0.5",
    ),
    family("degen", "degen", SIGNS, &[], "exactly degenerate in general position: every answer is 0"),
    family(
        "decimal-collinear",
        "decimal-collinear",
        &[Task::Orient2d],
        &["digits"],
        "collinear decimals, rounded to doubles",
    ),
    family(
        "decimal-coplanar",
        "decimal-coplanar",
        &[Task::Orient3d],
        &["digits"],
        "coplanar decimals, rounded to doubles",
    ),
    family(
        "decimal-cocircular",
        "decimal-cocircular",
        &[Task::Incircle],
        &["digits"],
        "cocircular decimals, rounded to doubles",
    ),
    family(
        "decimal-cospherical",
        "decimal-cospherical",
        &[Task::Insphere],
        &["digits"],
        "cospherical decimals, rounded to doubles",
    ),
    family(
        "midpoint-collinear",
        "midpoint-collinear",
        &[Task::Orient2d, Task::Orient3d],
        &[],
        "two points and their rounded midpoint; in 3D with any fourth",
    ),
    family("wide-scaled", "wide", SIGNS, &[], "uniform, near and degen queries scaled by 2^k, subnormal to 2^1023"),
    family("wide-mixed", "wide", SIGNS, &[], "every coordinate with its own exponent, subnormal to 2^1023"),
    family("far", "far", SIGNS, &[], "unit clusters 2^20 to 2^45 away from the origin"),
    family(
        "band",
        "band",
        &[Task::Orient2d, Task::Orient3d],
        &[],
        "determinants around the tolerance scheme's thresholds",
    ),
    family(
        "pixel-map",
        "pixel-map",
        &[Task::Orient2d],
        &["p", "q", "r", "side", "step"],
        "a square of neighbours of p against fixed q and r (Kettner et al.)",
    ),
    family(
        "ssi-uniform",
        "ssi-uniform",
        FLAT,
        &[],
        "two lines' meeting points and input points, all uniform in [0, 1)",
    ),
    family("ssi-near", "ssi-near", FLAT, &["ulps"], "two lines' meeting points at most so many ulps beside a tie"),
    family("ssi-degen", "ssi-degen", FLAT, &[], "two lines' meeting points in exact ties: every answer is 0"),
    family(
        "lpi-uniform",
        "lpi-uniform",
        SOLID,
        &[],
        "meeting points of lines and planes and input points, all uniform in [0, 1)",
    ),
    family(
        "lpi-near",
        "lpi-near",
        SOLID,
        &["ulps"],
        "meeting points of lines and planes at most so many ulps beside a tie",
    ),
    family("lpi-degen", "lpi-degen", SOLID, &[], "meeting points of lines and planes in exact ties: every answer is 0"),
    family(
        "tpi-uniform",
        "tpi-uniform",
        SOLID,
        &[],
        "three planes' meeting points and input points, all uniform in [0, 1)",
    ),
    family("tpi-near", "tpi-near", SOLID, &["ulps"], "three planes' meeting points at most so many ulps beside a tie"),
    family("tpi-degen", "tpi-degen", SOLID, &[], "three planes' meeting points in exact ties: every answer is 0"),
    family(
        "lpi-tpi-uniform",
        "lpi-tpi-uniform",
        SOLID,
        &[],
        "both kinds of meeting points in space and input points, all uniform in [0, 1)",
    ),
    family(
        "lpi-tpi-near",
        "lpi-tpi-near",
        SOLID,
        &["ulps"],
        "both kinds of meeting points in space at most so many ulps beside a tie",
    ),
    family(
        "lpi-tpi-degen",
        "lpi-tpi-degen",
        SOLID,
        &[],
        "both kinds of meeting points in space in exact ties: every answer is 0",
    ),
    family("cells-uniform", "cells-uniform", LINES, &[], "cells of a line with ends uniform in [0, 1)"),
    family("cells-degen", "cells-degen", LINES, &[], "cells of a line with ends on few integers: many have no length"),
    family(
        "cubes-uniform",
        "cubes-uniform",
        CUBES,
        &["density"],
        "cubes anywhere in a cube, so many around a point on average",
    ),
    family(
        "cubes-lattice",
        "cubes-lattice",
        CUBES,
        &["pitch", "edge"],
        "a lattice of cubes in no order: apart, touching or overlapping",
    ),
    family(
        "cubes-degen",
        "cubes-degen",
        CUBES,
        &["edge"],
        "cubes on few integers: common faces, edges, corners, and identical cubes",
    ),
    family("tiling", "tiling", MAPS, &[], "a jittered n×n quadrilateral tiling with lakes, islands and sea"),
    family("bricks", "bricks", MAPS, &[], "n courses of n bricks: axis-parallel borders and collinear runs"),
    family(
        "polygons-uniform",
        "polygons-uniform",
        PLANE_CONTACTS,
        &["bits"],
        "two simple polygons that cross all the way round, in general position",
    ),
    family(
        "polygons-near",
        "polygons-near",
        PLANE_CONTACTS,
        &[],
        "a polygon with its vertices within a few sigma of another's vertices and edges",
    ),
    family(
        "polygons-degen",
        "polygons-degen",
        PLANE_CONTACTS,
        &[],
        "skylines on integers: shared vertices, vertices on edges, overlapping edges",
    ),
    family(
        "copy-shifted",
        "copy-shifted",
        PLANE_CONTACTS,
        &["shift"],
        "a polygon against a copy moved by so many sigma",
    ),
    family(
        "surfaces-uniform",
        "surfaces-uniform",
        SPACE_CONTACTS,
        &["bits"],
        "two closed surfaces that cross everywhere, in general position",
    ),
    family(
        "surfaces-degen",
        "surfaces-degen",
        SPACE_CONTACTS,
        &[],
        "boxes on integers that share corners, edges and parts of faces",
    ),
    family(
        "surfaces-shifted",
        "surfaces-shifted",
        SPACE_CONTACTS,
        &["shift"],
        "a closed surface against a copy moved by so many sigma",
    ),
];

/// Every family, for listings.
#[must_use]
pub fn families() -> &'static [FamilyInfo] {
    &FAMILIES
}
