//! What a crate of predicates has to offer to be timed and judged.

use predicament_predicates::{Sign, ZeroMeaning};

/// One predicate of a crate. The `D` coordinates of a point and the `N` points
/// of a query say which one: (2, 3) and (3, 4) are the orientations, (2, 4) the
/// circle and (3, 5) the sphere.
///
/// Points come as a list and places in it, because there is a crate that wants
/// to know the places. A caller with bare coordinates makes a list of them:
/// once this is inlined nothing is left of it.
pub trait Predicate<const D: usize, const N: usize> {
    /// The crate's answer, in the orientation of
    /// [`Predicates`](predicament_predicates::Predicates).
    fn sign(points: &[[f64; D]], at: [usize; N]) -> Sign;

    /// Whether that answer was a NaN: only a crate that gives a determinant can say so.
    fn is_nan(points: &[[f64; D]], at: [usize; N]) -> bool {
        let _ = (points, at);
        false
    }
}

/// A crate of predicates.
pub trait Library: Predicate<2, 3> + Predicate<3, 4> + Predicate<2, 4> + Predicate<3, 5> {
    /// Its name in tables.
    const NAME: &'static str;
    /// The version that is linked in.
    const VERSION: &'static str;
    /// What it means by zero.
    const ZERO: ZeroMeaning;
    /// The orientation of the points that define a circle or a sphere, where it
    /// may be asked about no others.
    const BASE: Option<Base> = None;
}

/// What the first points of a query have to be oriented like, in our orientation.
#[derive(Clone, Copy)]
pub struct Base {
    /// Three points that define a circle.
    pub circle: Sign,
    /// Four that define a sphere.
    pub sphere: Sign,
}
