//! `hyperlimit`: predicates on exact reals, here rationals, and an answer that says what decided it.
//!
//! A double becomes a `Real` without rounding. Its reals cannot be shared between threads, so a session
//! converts the points of each query. An outcome that is unknown is thrown as an answer that was declined.

use std::fmt::Debug;

use hyperlimit::{Point2, Point3, PredicateOutcome, Real, Sign as Theirs};
use predicament_predicates::{Broken, Class, PredicateKind, Sign, ZeroMeaning};

use super::{Library, Point};

/// The crate `hyperlimit`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hyperlimit;

impl Library for Hyperlimit {
    fn name(&self) -> &'static str {
        "hyperlimit"
    }

    fn zero(&self, _: PredicateKind) -> Option<ZeroMeaning> {
        Some(ZeroMeaning::Exact)
    }

    fn compare(&self, points: [Point<1>; 2]) -> Sign {
        let [a, b] = points.map(|point| finite(Real::try_from(point.at[0])));
        Sign::from(decided(hyperlimit::compare_reals(&a, &b)))
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        let [a, b, c] = points.map(point2);
        sign(hyperlimit::orient2d(&a, &b, &c))
    }

    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        let [a, b, c, d] = points.map(point3);
        sign(hyperlimit::orient3d(&a, &b, &c, &d))
    }

    fn incircle(&self, points: [Point<2>; 4]) -> Sign {
        let [a, b, c, d] = points.map(point2);
        sign(hyperlimit::incircle2d(&a, &b, &c, &d))
    }

    fn insphere(&self, points: [Point<3>; 5]) -> Sign {
        let [a, b, c, d, e] = points.map(point3);
        sign(hyperlimit::insphere3d(&a, &b, &c, &d, &e))
    }
}

/// What the crate has decided; thrown where it is unknown.
fn decided<T: Copy + Debug>(outcome: PredicateOutcome<T>) -> T {
    let unknown = || Broken { class: Class::Declined, check: "certificate", message: format!("{outcome:?}") };
    outcome.value().unwrap_or_else(|| unknown().throw())
}

/// What the crate has made of coordinates; thrown where it takes none that are not finite.
fn finite<T, E>(converted: Result<T, E>) -> T {
    let message = "a coordinate is not finite".to_owned();
    converted.unwrap_or_else(|_| Broken { class: Class::Declined, check: "coordinates", message }.throw())
}

fn point2(point: Point<2>) -> Point2 {
    finite(Point2::try_from_f64_array(point.at))
}

fn point3(point: Point<3>) -> Point3 {
    finite(Point3::try_from_f64_array(point.at))
}

fn sign(outcome: PredicateOutcome<Theirs>) -> Sign {
    match decided(outcome) {
        Theirs::Negative => Sign::Negative,
        Theirs::Zero => Sign::Zero,
        Theirs::Positive => Sign::Positive,
    }
}
