//! The checks in reports about points in meshes.

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology("one region", "a point is in one region, or on the mesh"),
    Check::new(Class::SignFlip, "exact location", "a point is in the region that it is in"),
    Check::new(Class::Overreach, "exact location", "a point that is found on a triangle is there, on the first one"),
    Check::new(
        Class::Overreach,
        "undecided location",
        "a point is left undecided only where zeros within a tolerance decide",
    ),
    Check::new(Class::MissedZero, "missed surface", "a point on the mesh is found there"),
    Check::new(Class::Inconsistent, "unbroken tie", "where ties are broken no point is on the mesh"),
    Check::topology("region not around", "where ties are broken a point on the mesh is in a region around it"),
    Check::topology("tetrahedron", "a point is in the tetrahedron that its faces say"),
    Check::topology("direction", "along each axis the answer is the same"),
    Check::topology("shortcut", "the way that users go, by labels and nearest triangles, gives the same answer"),
];
