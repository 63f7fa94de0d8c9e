//! The crate `s2`. Points are taken as they are; a scene with a point that the crate does not call a unit vector is
//! declined. The crate documents that only equal points are indeterminate, so other points have to get a sign.

use predicament_engine::{Answer, Engine, Points, Predicate, Vertex, Zero, locked, serve};
use s2::point::Point;
use s2::predicates::{Direction, robust_sign};
use s2::r3::vector::Vector;

#[derive(Default)]
struct S2;

fn vector([x, y, z]: [f64; 3]) -> Vector {
    Vector { x, y, z }
}

impl Engine for S2 {
    const NAME: &'static str = "s2";
    const ZERO: Zero = Zero::Never;
    const PREDICATES: &'static [Predicate] = &[Predicate::OrientOnSphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "s2")
    }

    fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
        let Points::Space(points) = points else { return Ok(()) };
        match points.iter().find(|point| !vector(**point).is_unit()) {
            Some(point) => Err(format!("{point:?} is not on the unit sphere")),
            None => Ok(()),
        }
    }

    fn orient_on_sphere(&self, points: [Vertex<3>; 3]) -> Answer {
        let [a, b, c] = points.map(|vertex| Point(vector(vertex.at)));
        match robust_sign(&a, &b, &c) {
            Direction::Clockwise => Answer::Negative,
            Direction::Indeterminate => Answer::Zero,
            Direction::CounterClockwise => Answer::Positive,
        }
    }
}

fn main() -> std::process::ExitCode {
    serve::<S2>()
}
