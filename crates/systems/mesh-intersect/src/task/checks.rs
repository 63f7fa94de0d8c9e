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
    Check::topology("sides of a piece", "a piece is between the regions of its triangle, in one of the other mesh"),
    Check::topology("operation", "a result's surface is the pieces between its inside and its outside"),
    law(Law::PieceInFace),
    law(Law::PieceOrientation),
    law(Law::FaceArea),
    law(Law::Degenerate),
    law(Law::SelfIntersection),
    rounded(Law::PieceInFace),
    rounded(Law::FaceArea),
    Check::topology("region of a piece", "a piece is in the region that its middle is in"),
    Check::topology(
        "point in a result",
        "a result goes once around what the operation says is in it, and not around anything else",
    ),
    Check::topology("volume", "the volumes of a region's parts add up to its volume"),
    Check::rounded("volume", "the volumes of a region's parts add up to its volume"),
    Check::topology("volumes of results", "volumes of results add up to those of the meshes"),
    Check::rounded("volumes of results", "volumes of results add up to those of the meshes"),
    Check::topology("areas of results", "so do their areas, triangle by triangle"),
    Check::rounded("areas of results", "so do their areas, triangle by triangle"),
    Check::topology("a mesh with itself", "union and intersection are the mesh, differences have no volume"),
    Check::rounded("a mesh with itself", "union and intersection are the mesh, differences have no volume"),
    Check::topology(
        "edge of a piece",
        "an edge is inside of a triangle with a piece on either side, or on an edge of a mesh with a piece of each triangle there",
    ),
    Check::topology(
        "segment of a curve",
        "a segment of a curve has two pieces of one triangle of either mesh, one on either side",
    ),
    Check::topology("curve not closed", "as many segments of curves end in a point as triangles are around its edge"),
    Check::topology("result not closed", "a result's surface is closed and turned one way"),
    Check::topology("edge of a result", "an edge has two triangles, or as many as the meshes say"),
    Check::topology("corner of a result", "the triangles at a constructed vertex are one fan"),
    Check::topology("Euler characteristic", "the characteristics of results add up to those of the meshes"),
    Check::topology("meshes exchanged", "with the meshes exchanged the results are the same"),
    Check::rounded("meshes exchanged", "with the meshes exchanged the results are the same"),
    Check::topology("difference by complement", "A∖B is what A has in common with the complement of B"),
    Check::rounded("difference by complement", "A∖B is what A has in common with the complement of B"),
    Check::topology("limit", "where each constructed vertex is a point, a result has a limit"),
    Check::topology("vertex of a limit", "every vertex of a limit is a point"),
    Check::topology("vertices of a limit", "at one place of a limit there is one vertex"),
    Check::topology("areas of a limit", "a limit has the areas that the perturbed result has in each plane"),
    Check::topology("limit of a mesh with itself", "a mesh less itself is nothing"),
    Check::topology("settled result not closed", "a limit, and a result in doubles, is closed"),
    Check::topology("settled result crosses itself", "a limit, and a result in doubles, does not pass through itself"),
    Check::topology("sheet", "no triangle of a limit or in doubles is there twice"),
    Check::topology("place of a rounded vertex", "each coordinate in doubles is within one ulp of its place"),
    Check::new(Class::Declined, "touch", "a backend that does not break ties is given no meshes that touch"),
    Check::new(Class::Declined, "memory", "there is memory enough for all pairs of triangles"),
    Check::invariants("cutting triangles does not contradict itself", &[RULES, TRIANGULATION, ARRANGEMENT]),
];
