//! What a session plans when a query first climbs beyond the filters: which integers there are, for each predicate.

use predicament_arithmetic::Plan;
use predicament_predicates::{Axis, Plane};

use crate::ladder::Prepared;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d};
use crate::scene_integers::Integers;

/// The plan of a scene of the plane.
pub(crate) struct Flat {
    pub orient2d: Prepared,
    pub incircle: Prepared,
    pub integers: Integers<2>,
}

impl Flat {
    pub fn new(points: &[[f64; 2]]) -> Flat {
        let plan = Plan::of(points);
        let incircle = Prepared::new::<Incircle, 2, 4>(&plan);
        // If doubles do for the predicate of the highest degree, they do for all.
        let integers = if incircle.is_double() { Integers::None } else { Integers::new(&plan, points) };
        Flat { orient2d: Prepared::new::<Orient2d, 2, 3>(&plan), incircle, integers }
    }
}

/// The plan of a scene of space.
pub(crate) struct Solid {
    /// By plane.
    pub orient2d: [Prepared; 3],
    pub orient3d: Prepared,
    pub insphere: Prepared,
    pub integers: Integers<3>,
}

impl Solid {
    pub fn new(points: &[[f64; 3]]) -> Solid {
        let plan = Plan::of(points);
        let insphere = Prepared::new::<Insphere, 3, 5>(&plan);
        let of_plane = |plane: Plane| Prepared::new::<Orient2d, 2, 3>(&plan.project(plane.axes().map(Axis::index)));
        let integers = if insphere.is_double() { Integers::None } else { Integers::new(&plan, points) };
        Solid {
            orient2d: [Plane::Xy, Plane::Yz, Plane::Zx].map(of_plane),
            orient3d: Prepared::new::<Orient3d, 3, 4>(&plan),
            insphere,
            integers,
        }
    }
}
