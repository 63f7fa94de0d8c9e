//! Checks of indirect predicates: signs about points given by the lines and planes that meet there.
//!
//! Such points are hardly ever doubles. A predicate that rounds them first answers about other points, so its signs are
//! inverted, or undecided, in meshes and overlays. The closures receive definitions ([`Point2`], [`Point3`]), and the
//! judge solves them exactly. Every set of arguments is constructed in turn; the others are input points.

use predicament_predicates::{Axis, Plane, PredicateKind};

use super::{Check, INDIRECT_CASES, PLANE, SPACE};
use crate::{Answer, Number, Point, Point2, Point3};

const AXES2: &[(&str, &[usize])] = &[("x", &[0]), ("y", &[1])];
const AXES3: &[(&str, &[usize])] = &[("x", &[0]), ("y", &[1]), ("z", &[2])];
const PLANES: &[(&str, &[usize])] = &[("xy", &[0, 1]), ("yz", &[1, 2]), ("zx", &[2, 0])];

fn indirect<P: Point>(check: Check<'_, P>) -> Check<'_, P> {
    Check { is_indirect: true, cases: INDIRECT_CASES, ..check }
}

/// Checks the turn of three points of the plane; points may be where two lines meet.
pub fn orient2d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Point2<T>, Point2<T>, Point2<T>) -> A + 'f,
) -> Check<'f, Point2<T>> {
    let asked = move |_: usize, p: &[Point2<T>]| predicate(p[0], p[1], p[2]).into();
    indirect(Check::new(PredicateKind::Orient2d, PLANE, Box::new(asked)))
}

/// Checks the side of a plane through three points; points may be where a line and a plane meet, or three planes.
pub fn orient3d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Point3<T>, Point3<T>, Point3<T>, Point3<T>) -> A + 'f,
) -> Check<'f, Point3<T>> {
    let asked = move |_: usize, p: &[Point3<T>]| predicate(p[0], p[1], p[2], p[3]).into();
    indirect(Check::new(PredicateKind::Orient3d, SPACE, Box::new(asked)))
}

/// Checks the side of a circle through three points; points may be where two lines meet.
pub fn incircle<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Point2<T>, Point2<T>, Point2<T>, Point2<T>) -> A + 'f,
) -> Check<'f, Point2<T>> {
    let asked = move |_: usize, p: &[Point2<T>]| predicate(p[0], p[1], p[2], p[3]).into();
    indirect(Check::new(PredicateKind::Incircle, PLANE, Box::new(asked)))
}

/// Checks the side of a sphere through four points; points may be where a line and a plane meet, or three planes.
pub fn insphere<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Point3<T>, Point3<T>, Point3<T>, Point3<T>, Point3<T>) -> A + 'f,
) -> Check<'f, Point3<T>> {
    let asked = move |_: usize, p: &[Point3<T>]| predicate(p[0], p[1], p[2], p[3], p[4]).into();
    indirect(Check::new(PredicateKind::Insphere, SPACE, Box::new(asked)))
}

/// Checks the turn of three points of space, projected to a coordinate plane.
pub fn orient2d_of_3d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Plane, Point3<T>, Point3<T>, Point3<T>) -> A + 'f,
) -> Check<'f, Point3<T>> {
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    let asked = move |way: usize, p: &[Point3<T>]| predicate(planes[way], p[0], p[1], p[2]).into();
    indirect(Check::new(PredicateKind::Orient2d, PLANES, Box::new(asked)))
}

/// Checks the order of two points of the plane along an axis: negative if a is before b.
pub fn compare2d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Axis, Point2<T>, Point2<T>) -> A + 'f,
) -> Check<'f, Point2<T>> {
    let asked = move |way: usize, p: &[Point2<T>]| predicate([Axis::X, Axis::Y][way], p[0], p[1]).into();
    indirect(Check::new(PredicateKind::Compare, AXES2, Box::new(asked)))
}

/// Checks the order of two points of space along an axis: negative if a is before b.
pub fn compare3d<'f, T: Number, A: Into<Answer>>(
    mut predicate: impl FnMut(Axis, Point3<T>, Point3<T>) -> A + 'f,
) -> Check<'f, Point3<T>> {
    let asked = move |way: usize, p: &[Point3<T>]| predicate([Axis::X, Axis::Y, Axis::Z][way], p[0], p[1]).into();
    indirect(Check::new(PredicateKind::Compare, AXES3, Box::new(asked)))
}
