//! The functions of the crate `robust`, answered by `predicament-exact`.
//!
//! `robust` returns a number near the determinant, and its users read the sign. Here the number is −1, 0 or 1. A
//! program that reads magnitudes needs the determinant itself, and not this crate.

#![no_std]

use predicament_exact as exact;

/// A point of the plane.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Coord<T: Into<f64>> {
    /// The first coordinate.
    pub x: T,
    /// The second coordinate.
    pub y: T,
}

/// A point of space.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Coord3D<T: Into<f64>> {
    /// The first coordinate.
    pub x: T,
    /// The second coordinate.
    pub y: T,
    /// The third coordinate.
    pub z: T,
}

impl<T: Into<f64>> From<Coord<T>> for [f64; 2] {
    #[inline(always)]
    fn from(point: Coord<T>) -> [f64; 2] {
        [point.x.into(), point.y.into()]
    }
}

impl<T: Into<f64>> From<Coord3D<T>> for [f64; 3] {
    #[inline(always)]
    fn from(point: Coord3D<T>) -> [f64; 3] {
        [point.x.into(), point.y.into(), point.z.into()]
    }
}

/// The turn of three points: positive if it is counterclockwise.
#[inline]
pub fn orient2d<T: Into<f64>>(a: Coord<T>, b: Coord<T>, c: Coord<T>) -> f64 {
    f64::from(exact::orient2d(a, b, c).as_i8())
}

/// The side of a plane: positive if d is below the plane of a, b, c.
#[inline]
pub fn orient3d<T: Into<f64>>(a: Coord3D<T>, b: Coord3D<T>, c: Coord3D<T>, d: Coord3D<T>) -> f64 {
    f64::from(exact::orient3d(a, b, c, d).as_i8())
}

/// The circle test: positive if d is in the circle of a counterclockwise a, b, c.
#[inline]
pub fn incircle<T: Into<f64>>(a: Coord<T>, b: Coord<T>, c: Coord<T>, d: Coord<T>) -> f64 {
    f64::from(exact::incircle(a, b, c, d).as_i8())
}

/// The sphere test: positive if e is in the sphere of a, b, c, d with a positive `orient3d`.
#[inline]
pub fn insphere<T: Into<f64>>(a: Coord3D<T>, b: Coord3D<T>, c: Coord3D<T>, d: Coord3D<T>, e: Coord3D<T>) -> f64 {
    f64::from(exact::insphere(a, b, c, d, e).as_i8())
}
