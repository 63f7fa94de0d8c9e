//! The second rung: Shewchuk's adaptive predicates, from the crate `robust`.
//!
//! Right as long as no tail is lost to underflow and no splitter overflows;
//! callers hold a [`Plan`](predicament_arithmetic::Plan).

use predicament_predicates::Sign;
use robust::{Coord, Coord3D};

/// The turn a, b, c.
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    Sign::of(robust::orient2d(point2(a), point2(b), point2(c)))
}

/// The side of d on the plane of a, b, c.
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    Sign::of(robust::orient3d(point3(a), point3(b), point3(c), point3(d)))
}

/// d in the circle of a, b, c.
#[must_use]
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    Sign::of(robust::incircle(point2(a), point2(b), point2(c), point2(d)))
}

/// e in the sphere of a, b, c, d.
#[must_use]
pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    Sign::of(robust::insphere(point3(a), point3(b), point3(c), point3(d), point3(e)))
}

fn point2([x, y]: [f64; 2]) -> Coord<f64> {
    Coord { x, y }
}

fn point3([x, y, z]: [f64; 3]) -> Coord3D<f64> {
    Coord3D { x, y, z }
}
