//! A ray from a point of a triangle that is off everything else.
//!
//! The point is v + ε(a − v) + ε²(b − v), for a corner v and the other corners a and b, and ε small enough. Its
//! projection is on no line of two others, as that would be an equation with three zeros: signs are those of v, if
//! these are zero those of a, and then those of b. So nothing is constructed, and no number has more digits than the
//! corners have.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::resolve::faces::{side, turn};
use crate::algorithm::overlay::{SurfaceContradiction, Undone};

/// A ray up an axis from a point of a triangle.
pub(crate) struct Ray {
    /// The axis of the ray.
    pub axis: Axis,
    /// The plane across the ray.
    plane: Plane,
    /// The start of the ray: the first vertex, moved towards the second, and by less towards the third.
    pub from: [Vertex; 3],
}

impl Ray {
    /// The ray from a triangle that has an area in a coordinate plane, across that plane.
    pub fn new(from: [Vertex; 3], plane: Plane) -> Ray {
        let axis = match plane {
            Plane::Xy => Axis::Z,
            Plane::Yz => Axis::X,
            Plane::Zx => Axis::Y,
        };
        Ray { axis, plane, from }
    }

    /// The first of three signs that is not zero.
    fn first(&self, sign: impl FnMut(Vertex) -> Sign) -> Result<Sign, Undone> {
        self.from
            .into_iter()
            .map(sign)
            .find(|sign| !sign.is_zero())
            .ok_or(Undone::Broken(SurfaceContradiction::Faces.into()))
    }

    /// Positive if the ray passes a triangle from behind it, negative if from its front; zero if it does not pass.
    pub fn passes(&self, session: &dyn Predicates, corners: [Vertex; 3]) -> Result<Sign, Undone> {
        let [a, b, c] = corners;
        let up = turn(session, self.plane, [a, b, c]);
        if up.is_zero() {
            return Ok(Sign::Zero);
        }
        for [p, q] in [[a, b], [b, c], [c, a]] {
            if self.first(|v| turn(session, self.plane, [p, q, v]))? != up {
                return Ok(Sign::Zero);
            }
        }
        // The start is below: behind a triangle that looks up, in front of a triangle that looks down.
        let is_below = self.first(|v| side(session, corners, v))? == up;
        Ok(if is_below { up } else { Sign::Zero })
    }
}
