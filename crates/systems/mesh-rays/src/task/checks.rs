//! The checks in reports about rays and meshes.

use predicament_tasks::{Check, Class};

pub(super) const HITS: &str = "hits";
pub(super) const PERTURBED: &str = "perturbed hits";
pub(super) const ORDER: &str = "order of hits";
pub(super) const PARITY: &str = "parity";

pub(super) const CHECKS: &[Check] = &[
    Check::new(
        Class::SignFlip,
        PERTURBED,
        "if ties are broken, a query hits the faces of the perturbed scene, in order",
    ),
    Check::new(Class::Inconsistent, PERTURBED, "if ties are broken, a query does not hit vertices and edges"),
    Check::new(Class::SignFlip, HITS, "a query hits all faces that it crosses, and no others"),
    Check::new(Class::MissedZero, HITS, "a query through a vertex or an edge, or along a face, hits it"),
    Check::new(
        Class::Overreach,
        HITS,
        "a vertex, an edge or a face along the query is hit only if it has a common point",
    ),
    Check::new(Class::MissedZero, ORDER, "hits at one place are reported as equal"),
    Check::new(Class::Overreach, ORDER, "hits at different places are reported as different"),
    Check::new(Class::SignFlip, ORDER, "hits are in their order along the query"),
    Check::topology(
        PARITY,
        "the crossings of a closed mesh are the difference of its winding numbers at the query's ends",
    ),
];
