//! The checks in reports about points in meshes.

use predicament_tasks::{Check, Class};

pub(super) const CHECKS: &[Check] = &[
    Check::topology("one region", "a point is in one region, or on the mesh"),
    Check::new(Class::SignFlip, "exact location", "a point is reported in its region"),
    Check::new(
        Class::Overreach,
        "exact location",
        "a point that is reported on a triangle is on it, and the triangle is the first of these",
    ),
    Check::new(
        Class::Overreach,
        "undecided location",
        "a point is undecided only if its region depends on zeros within a tolerance",
    ),
    Check::new(Class::MissedZero, "missed surface", "a point on the mesh is reported there"),
    Check::new(Class::Inconsistent, "unbroken tie", "if ties are broken, points are not on the mesh"),
    Check::topology("region not around", "if ties are broken, a point on the mesh is in a region around it"),
    Check::topology("tetrahedron", "a point is in the region of the tetrahedron around it, by the signs of its faces"),
    Check::topology("direction", "the answer is the same along each axis"),
    Check::topology("shortcut", "the public function, which uses labels and nearest triangles, gives the same answer"),
];
