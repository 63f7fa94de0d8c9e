//! The distance of a point from a triangle, in rationals.

use crate::rational;
use rug::Rational;

use super::Corners;

type Point = [Rational; 3];

fn less(p: &Point, q: &Point) -> Point {
    [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]))
}

fn dot(p: &Point, q: &Point) -> Rational {
    (0..3).map(|i| Rational::from(&p[i] * &q[i])).sum()
}

fn cross(p: &Point, q: &Point) -> Point {
    [0, 1, 2].map(|i: usize| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        Rational::from(&p[j] * &q[k]) - Rational::from(&p[k] * &q[j])
    })
}

/// The distance of a point from a closed triangle, which may be flat; rounded only at the end.
pub(super) fn of_triangle(corners: &Corners, p: [f64; 3]) -> f64 {
    root(&square_of_triangle(&corners.map(|corner| corner.map(rational)), &p.map(rational)))
}

/// The distance of a point from a closed segment; rounded only at the end.
pub(super) fn of_segment(ends: [[f64; 3]; 2], p: &Point) -> f64 {
    let [a, b] = ends.map(|end| end.map(rational));
    root(&square_of_segment(&a, &b, p))
}

fn square_of_triangle([a, b, c]: &[Point; 3], p: &Point) -> Rational {
    let normal = cross(&less(b, a), &less(c, a));
    let length = dot(&normal, &normal);
    if !length.is_zero() {
        // Inside of the prism over the triangle, the plane is nearest.
        let is_left = |from: &Point, to: &Point| dot(&cross(&less(to, from), &less(p, from)), &normal).cmp0().is_ge();
        if is_left(a, b) && is_left(b, c) && is_left(c, a) {
            return dot(&normal, &less(p, a)).square() / length;
        }
    }
    let sides = [square_of_segment(a, b, p), square_of_segment(b, c, p), square_of_segment(c, a, p)];
    sides.into_iter().min().unwrap_or_default()
}

fn square_of_segment(a: &Point, b: &Point, p: &Point) -> Rational {
    let [along, to] = [less(b, a), less(p, a)];
    let square = dot(&along, &along);
    let part = if square.is_zero() { square } else { (dot(&along, &to) / square).clamp(&0, &1) };
    let off = [0, 1, 2].map(|i: usize| Rational::from(&to[i] - &Rational::from(&along[i] * &part)));
    dot(&off, &off)
}

/// The square root of a rational, rounded; also where the square is below all doubles.
fn root(square: &Rational) -> f64 {
    let rounded = square.to_f64();
    if rounded > 1e-280 && rounded.is_finite() {
        return rounded.sqrt();
    }
    let scale = Rational::from(2).square() << 1022_u32;
    (Rational::from(square * &scale).to_f64()).sqrt() / 2.0_f64.powi(512)
}
