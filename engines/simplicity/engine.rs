//! The crate `simplicity`: Simulation of Simplicity after Edelsbrunner and Mücke, by the index of a point in a list,
//! here the scene's list of points.
//!
//! Its conventions are ours. It only answers "positive?", even if a vertex occurs twice; this engine answers such
//! queries with zero, without a call. Later coordinates of a vertex move further, and the lift is that of the moved
//! point.

use predicament_engine::{Answer, Engine, Points, Predicate, Vertex, Zero, by_id, locked, serve};
use simplicity::nalgebra::{Vector1, Vector2, Vector3};

#[derive(Default)]
struct Simplicity {
    plane: Vec<[f64; 2]>,
    space: Vec<[f64; 3]>,
}

impl Engine for Simplicity {
    const NAME: &'static str = "simplicity";
    const ZERO: Zero = Zero::Never;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Compare, Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];
    const IN_ORDER: bool = true;

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "simplicity")
    }

    fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
        match points {
            Points::Plane(points) => self.plane = points.to_vec(),
            Points::Space(points) => self.space = points.to_vec(),
        }
        Ok(())
    }

    fn compare(&self, _: usize, points: [Vertex<1>; 2]) -> Answer {
        let [a, b] = points;
        let at = |_: &(), id| Vector1::from(if id == a.id { a.at } else { b.at });
        unless_repeated(points, || simplicity::orient_1d(&(), at, a.id, b.id))
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let [i, j, k] = ids(points);
        unless_repeated(points, || simplicity::orient_2d(&*self.plane, vector2, i, j, k))
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let [i, j, k, l] = ids(points);
        unless_repeated(points, || simplicity::orient_3d(&*self.space, vector3, i, j, k, l))
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let [i, j, k, l] = ids(points);
        unless_repeated(points, || simplicity::in_circle(&*self.plane, vector2, i, j, k, l))
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let [i, j, k, l, m] = ids(points);
        unless_repeated(points, || simplicity::in_sphere(&*self.space, vector3, i, j, k, l, m))
    }
}

fn ids<const D: usize, const N: usize>(points: [Vertex<D>; N]) -> [usize; N] {
    points.map(|point| point.id as usize)
}

fn vector2(points: &[[f64; 2]], at: usize) -> Vector2<f64> {
    Vector2::from(points[at])
}

fn vector3(points: &[[f64; 3]], at: usize) -> Vector3<f64> {
    Vector3::from(points[at])
}

fn unless_repeated<const D: usize, const N: usize>(points: [Vertex<D>; N], positive: impl Fn() -> bool) -> Answer {
    if by_id(points).is_none() {
        Answer::Zero
    } else if positive() {
        Answer::Positive
    } else {
        Answer::Negative
    }
}

fn main() -> std::process::ExitCode {
    serve::<Simplicity>()
}
