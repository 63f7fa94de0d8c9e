//! The checks in reports about simplified meshes.

use predicament_tasks::{Check, Class};

pub(super) const STEPS: &str = "steps";
pub(super) const TRIANGLES: &str = "triangles";
pub(super) const SURFACE: &str = "surface";
pub(super) const COUNT: &str = "count";
pub(super) const DISTANCE: &str = "distance";
pub(super) const TURNED: &str = "turned face";
pub(super) const REFUSED: &str = "refused collapse";
pub(super) const PERTURBED: &str = "perturbed face";

pub(super) const CHECKS: &[Check] = &[
    Check::topology(STEPS, "each step is about an edge of the mesh, and each collapse keeps the surface"),
    Check::topology(TRIANGLES, "the triangles are those that the steps leave"),
    Check::topology(SURFACE, "the triangles are a surface with the components, holes and handles of the input"),
    Check::topology(COUNT, "collapses go on until the target is reached or no edge can be collapsed, and not further"),
    Check::topology(DISTANCE, "no vertex has moved further than the answer says, and the bound is not too large"),
    Check::new(Class::SignFlip, TURNED, "a collapse does not turn a face over"),
    Check::new(Class::MissedZero, TURNED, "a face does not lose or get an area, or turn by a right angle"),
    Check::new(Class::SignFlip, REFUSED, "a collapse is refused only if a face would turn over"),
    Check::new(Class::Overreach, REFUSED, "a face whose normals make an acute angle is not found undecided"),
    Check::new(Class::MissedZero, REFUSED, "a collapse is not refused because of a face that stays without area"),
    Check::new(Class::SignFlip, PERTURBED, "if ties are broken, faces turn as those of the perturbed scene do"),
    Check::new(Class::Inconsistent, PERTURBED, "if ties are broken, no face is without area or at a right angle"),
];
