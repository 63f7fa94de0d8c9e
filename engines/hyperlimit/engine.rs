//! The crate `hyperlimit`: predicates on exact reals, here rationals, with answers that report what decided them.
//!
//! Its conventions are ours. A double becomes a `Real` without rounding when a scene is prepared. An unknown outcome is
//! declined.

use hyperlimit::{Point2, Point3, PredicateOutcome, Real, Sign};
use predicament_engine::{Answer, Engine, Points, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct Hyperlimit {
    plane: Vec<Point2>,
    space: Vec<Point3>,
}

impl Hyperlimit {
    fn coordinate(&self, axis: usize, id: usize) -> &Real {
        match self.space.get(id) {
            Some(point) => [&point.x, &point.y, &point.z][axis],
            None => [&self.plane[id].x, &self.plane[id].y][axis],
        }
    }
}

impl Engine for Hyperlimit {
    const NAME: &'static str = "hyperlimit";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Compare, Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "hyperlimit")
    }

    fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
        *self = Hyperlimit::default();
        match points {
            Points::Plane(points) => {
                let made = points.iter().map(|&point| Point2::try_from_f64_array(point).map_err(not_finite));
                self.plane = made.collect::<Result<_, _>>()?;
            }
            Points::Space(points) => {
                let made = points.iter().map(|&point| Point3::try_from_f64_array(point).map_err(not_finite));
                self.space = made.collect::<Result<_, _>>()?;
            }
        }
        Ok(())
    }

    fn compare(&self, axis: usize, points: [Vertex<1>; 2]) -> Answer {
        let [a, b] = points.map(|point| self.coordinate(axis, point.id as usize));
        hyperlimit::compare_reals(a, b).value().map_or(Answer::Declined, Answer::from)
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let [a, b, c] = points.map(|point| &self.plane[point.id as usize]);
        sign(hyperlimit::orient2d(a, b, c))
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let [a, b, c, d] = points.map(|point| &self.space[point.id as usize]);
        sign(hyperlimit::orient3d(a, b, c, d))
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let [a, b, c, d] = points.map(|point| &self.plane[point.id as usize]);
        sign(hyperlimit::incircle2d(a, b, c, d))
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let [a, b, c, d, e] = points.map(|point| &self.space[point.id as usize]);
        sign(hyperlimit::insphere3d(a, b, c, d, e))
    }
}

fn not_finite<E>(_: E) -> String {
    "a coordinate is not finite".to_owned()
}

fn sign(outcome: PredicateOutcome<Sign>) -> Answer {
    match outcome.value() {
        Some(Sign::Negative) => Answer::Negative,
        Some(Sign::Zero) => Answer::Zero,
        Some(Sign::Positive) => Answer::Positive,
        None => Answer::Declined,
    }
}

fn main() -> std::process::ExitCode {
    serve::<Hyperlimit>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Scenes are finite, so only a point from outside of any scene shows it.
    #[test]
    fn points_that_are_not_finite_are_declined() {
        let mut engine = Hyperlimit::default();
        assert!(engine.prepare(Points::Plane(&[[1.0, 2.0]])).is_ok());
        assert_eq!(
            engine.prepare(Points::Plane(&[[1.0, f64::INFINITY]])),
            Err("a coordinate is not finite".to_owned())
        );
        assert!(engine.prepare(Points::Space(&[[1.0, 0.0, f64::NAN]])).is_err());
    }
}
