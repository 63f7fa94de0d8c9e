//! `simplicity`: Simulation of Simplicity after Edelsbrunner and Mücke, on
//! expansions of its own, by the place of a point in a list.
//!
//! It answers "positive?" and nothing else, so it says something about one vertex
//! named twice too; that question is not put to it. Coordinates of a vertex move
//! the further the later they come, the lift is that of the moved point.

use predicament_predicates::{PredicateKind, Sign, ZeroMeaning};
use simplicity::nalgebra::{Vector1, Vector2, Vector3};

use super::{Library, Point, sorted};

/// The crate `simplicity`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Simplicity;

/// The answer, unless two of the points are the same vertex.
fn unless_repeated<const D: usize, const N: usize>(points: [Point<D>; N], positive: impl FnOnce() -> bool) -> Sign {
    match sorted(points).1 {
        Sign::Zero => Sign::Zero,
        _ if positive() => Sign::Positive,
        _ => Sign::Negative,
    }
}

/// Looks a point up by its key: the crate's `index_fn`.
fn at<const D: usize, const N: usize>(points: &[Point<D>; N], key: usize) -> [f64; D] {
    points.iter().find(|point| point.key == key).map_or([f64::NAN; D], |point| point.at)
}

impl Library for Simplicity {
    fn name(&self) -> &'static str {
        "simplicity"
    }

    fn zero(&self, _: PredicateKind) -> Option<ZeroMeaning> {
        Some(ZeroMeaning::Never)
    }

    fn compare(&self, points: [Point<1>; 2]) -> Sign {
        let [i, j] = points.map(|point| point.key);
        unless_repeated(points, || simplicity::orient_1d(&points, |l, k| Vector1::from(at(l, k)), i, j))
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        let [i, j, k] = points.map(|point| point.key);
        unless_repeated(points, || simplicity::orient_2d(&points, |l, k| Vector2::from(at(l, k)), i, j, k))
    }

    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        let [i, j, k, l] = points.map(|point| point.key);
        unless_repeated(points, || simplicity::orient_3d(&points, |l, k| Vector3::from(at(l, k)), i, j, k, l))
    }

    fn incircle(&self, points: [Point<2>; 4]) -> Sign {
        let [i, j, k, l] = points.map(|point| point.key);
        unless_repeated(points, || simplicity::in_circle(&points, |l, k| Vector2::from(at(l, k)), i, j, k, l))
    }

    fn insphere(&self, points: [Point<3>; 5]) -> Sign {
        let [i, j, k, l, m] = points.map(|point| point.key);
        unless_repeated(points, || simplicity::in_sphere(&points, |l, k| Vector3::from(at(l, k)), i, j, k, l, m))
    }
}
