//! The checks in reports about overlays of meshes.

use crate::algorithm::overlay::Contradiction;
use predicament_slice::checks::Check as Law;

use predicament_overlay::task::overlay::RULES as ARRANGEMENT;
use predicament_slice::task::{law, rounded};
use predicament_tasks::{Check, Class};
use predicament_triangulate::task::RULES as TRIANGULATION;

/// The invariants that the algorithm checks during its run.
const RULES: &[&str] = Contradiction::RULES;

pub(super) const CHECKS: &[Check] = &[
    Check::topology("vertex not finite", "every vertex is a point"),
    Check::topology("region not closed", "the boundary of each region is closed"),
    Check::topology(
        "sides of a piece",
        "a piece separates the regions of its triangle, inside one region of the other mesh, or those of a triangle \
         of it",
    ),
    Check::topology("operation", "the surface of a result consists of the pieces between its inside and its outside"),
    law(Law::PieceInFace),
    law(Law::PieceOrientation),
    law(Law::FaceArea),
    law(Law::Degenerate),
    law(Law::SelfIntersection),
    rounded(Law::PieceInFace),
    rounded(Law::FaceArea),
    Check::topology("region of a piece", "a piece is in the region of its centroid"),
    Check::topology(
        "point in a result",
        "the surface of a result goes once around its points, and not around any other point",
    ),
    Check::topology("volume", "the volumes of a region's parts add up to its volume"),
    Check::rounded("volume", "the volumes of a region's parts add up to its volume"),
    Check::topology("volumes of results", "the volumes of results add up to the volumes of the meshes"),
    Check::rounded("volumes of results", "the volumes of results add up to the volumes of the meshes"),
    Check::topology("areas of results", "the areas of results add up to the areas of the meshes, triangle by triangle"),
    Check::rounded("areas of results", "the areas of results add up to the areas of the meshes, triangle by triangle"),
    Check::topology("a mesh with itself", "union and intersection equal the mesh; differences have no volume"),
    Check::rounded("a mesh with itself", "union and intersection equal the mesh; differences have no volume"),
    Check::topology(
        "edge of a piece",
        "an edge is inside a triangle, with a piece on each side, or on an edge of a mesh, with a piece of each \
         triangle at that edge",
    ),
    Check::topology(
        "segment of a curve",
        "a segment of a curve has, in each mesh, two pieces of one triangle, one on each side",
    ),
    Check::topology(
        "curve not closed",
        "the number of curve segments that end in a point equals the number of triangles around its edge",
    ),
    Check::topology("result not closed", "the surface of a result is closed and consistently oriented"),
    Check::topology("edge of a result", "an edge has two triangles, or as many as in the meshes"),
    Check::topology("corner of a result", "the triangles at a constructed vertex make one fan"),
    Check::topology(
        "Euler characteristic",
        "the Euler characteristics of results add up to the characteristics of the meshes",
    ),
    Check::topology(
        "faces of contact",
        "solids touch in the common parts of two triangles in one plane, one solid on either side",
    ),
    Check::topology(
        "segments of contact",
        "solids touch in the segments of both surfaces without a common inside or a face of contact",
    ),
    Check::topology(
        "points of contact",
        "solids touch in the points of both surfaces without a common inside, a face or a segment of contact",
    ),
    Check::topology("meshes exchanged", "exchanged meshes give the same results"),
    Check::rounded("meshes exchanged", "exchanged meshes give the same results"),
    Check::topology("difference by complement", "A∖B equals the intersection of A and the complement of B"),
    Check::rounded("difference by complement", "A∖B equals the intersection of A and the complement of B"),
    Check::topology("limit", "a result has a limit if every constructed vertex is a point"),
    Check::topology("vertex of a limit", "every vertex of a limit is a point"),
    Check::topology("vertices of a limit", "two vertices of a limit are not at the same place"),
    Check::topology("areas of a limit", "a limit covers the same areas in each plane as the perturbed result"),
    Check::topology("limit of a mesh with itself", "a mesh less itself is empty"),
    Check::topology("settled result not closed", "a limit, and a result in doubles, is closed"),
    Check::topology("settled result crosses itself", "a limit, and a result in doubles, does not pass through itself"),
    Check::topology("sheet", "each triangle of a limit, and of a result in doubles, occurs only once"),
    Check::topology(
        "place of a rounded vertex",
        "each coordinate in doubles is within one ulp of the exact coordinate",
    ),
    Check::new(
        Class::Declined,
        "touch",
        "for a backend that registers contacts, nothing smaller than an edge and a triangle is in contact",
    ),
    Check::new(
        Class::Declined,
        "own parts",
        "for a backend with exact zeros, triangles of one mesh meet in whole edges and corners only",
    ),
    Check::new(Class::Declined, "memory", "the memory suffices for all pairs of triangles"),
    Check::invariants("cutting triangles does not contradict itself", &[RULES, TRIANGULATION, ARRANGEMENT]),
];
