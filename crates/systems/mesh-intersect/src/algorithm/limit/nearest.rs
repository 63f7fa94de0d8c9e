//! The doubles nearest to the intersection of a line and a plane, or of three planes.
//!
//! A line and a plane meet at p + t·(q − p), t = n/(n − m), with the distances n and m of p and q from the plane: a
//! quotient of integers, once all coordinates are integers in one unit.

use std::cmp::Ordering;

use predicament_arithmetic::{ExponentRange, Scaled, power_of_two};
use predicament_predicates::{Construction, Scene};
use rug::{Complete, Integer, Rational};

/// A vector, or a point, in units of a power of two.
type Space = [Integer; 3];

/// The nearest doubles, and the direction of the point from them in each coordinate.
pub(super) type Nearest = ([f64; 3], [Ordering; 3]);

/// The number of bits of coordinates for which products of four differences fit 128 bits.
const SHORT: i32 = 26;

/// The doubles nearest to a point (ties to even), and the direction of the point from them in each coordinate. `None`
/// if line and plane do not meet in a single point, or the definition is of another kind, or uses constructed vertices.
///
/// A coordinate beyond all doubles becomes the largest double. Rounding is monotone: the smaller of two coordinates is
/// never rounded to the larger double.
pub(super) fn nearest(scene: &Scene, definition: &Construction) -> Option<Nearest> {
    if !definition.is_of_inputs() {
        return None;
    }
    match definition {
        Construction::Lpi { line: [p, q], plane: [a, b, c] } => {
            let points = [p, q, a, b, c].map(|&v| scene.point3(v));
            if let Some(point) = short(&points) {
                return Some((point, [Ordering::Equal; 3]));
            }
            let Scaled { integers: [p, q, a, b, c], exponent } = Scaled::new(points)?;
            let normal = normal([&a, &b, &c]);
            let [n, m] = [&p, &q].map(|x| dot(&normal, &minus(x, &a)));
            let weight = Integer::from(&n - &m);
            let at = |i: usize| Integer::from(&p[i] * &weight) + Integer::from(&q[i] - &p[i]) * &n;
            point([0, 1, 2].map(at), &weight, exponent)
        }
        Construction::Tpi(planes) => {
            let [[a, b, c], [d, e, f], [g, h, i]] = planes.map(|plane| plane.map(|v| scene.point3(v)));
            let Scaled { integers: [a, b, c, d, e, f, g, h, i], exponent } = Scaled::new([a, b, c, d, e, f, g, h, i])?;
            // By Cramer's rule: offsets times cross products of the other two normals.
            let normals = [normal([&a, &b, &c]), normal([&d, &e, &f]), normal([&g, &h, &i])];
            let crossed = [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| cross(&normals[i], &normals[j]));
            let weight = dot(&normals[0], &crossed[0]);
            let offsets = [dot(&normals[0], &a), dot(&normals[1], &d), dot(&normals[2], &g)];
            let at = |axis: usize| -> Integer { (0..3).map(|i| Integer::from(&offsets[i] * &crossed[i][axis])).sum() };
            point([0, 1, 2].map(at), &weight, exponent)
        }
        Construction::Ssi(_) | Construction::Ratio { .. } => None,
    }
}

/// Converts weighted coordinates, in units of a power of two, to doubles.
fn point(at: Space, weight: &Integer, exponent: i32) -> Option<Nearest> {
    if weight.is_zero() {
        return None;
    }
    let mut sides = [Ordering::Equal; 3];
    let mut nearest = [0.0; 3];
    for (axis, x) in at.into_iter().enumerate() {
        (nearest[axis], sides[axis]) = rounded(&(Rational::from((x, weight.clone())) << exponent));
    }
    Some((nearest, sides))
}

fn minus(a: &Space, b: &Space) -> Space {
    [0, 1, 2].map(|i: usize| Integer::from(&a[i] - &b[i]))
}

fn dot(a: &Space, b: &Space) -> Integer {
    (0..3).map(|i| Integer::from(&a[i] * &b[i])).sum()
}

fn cross(a: &Space, b: &Space) -> Space {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| Integer::from(&a[i] * &b[j]) - Integer::from(&a[j] * &b[i]))
}

fn normal([a, b, c]: [&Space; 3]) -> Space {
    cross(&minus(b, a), &minus(c, a))
}

/// The double nearest to a rational (ties to even), and the direction of the rational from it.
fn rounded(x: &Rational) -> (f64, Ordering) {
    // Rounded towards zero; the other candidate is the next double away from zero.
    let inner = x.to_f64().clamp(f64::MIN, f64::MAX);
    let outer = if x.cmp0().is_lt() { inner.next_down() } else { inner.next_up() };
    let [here, there] = [inner, outer].map(Rational::from_f64);
    let Some(here) = here else { return (inner, Ordering::Equal) };
    let side = x.cmp(&here);
    let is_inner = there.is_none_or(|there| {
        let nearer = (&here - x).complete().abs().cmp(&(there - x).abs());
        nearer.is_lt() || (nearer.is_eq() && inner.to_bits().is_multiple_of(2))
    });
    match (side, is_inner) {
        // (−0 becomes 0.)
        (Ordering::Equal, _) => (inner + 0.0, side),
        (_, true) => (inner, side),
        (_, false) => (outer, side.reverse()),
    }
}

/// The point, if coordinates differ in few bits and the point is a multiple of their unit.
fn short(points: &[[f64; 3]; 5]) -> Option<[f64; 3]> {
    let exponent = ExponentRange::of(points.as_flattened()).map_or(0, |range| range.lowest);
    let largest = points.as_flattened().iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // Units are normal doubles, and so are all multiples of up to SHORT bits.
    if !(-900..=900).contains(&exponent) || largest >= power_of_two(exponent + SHORT - 1) {
        return None;
    }
    let [p, q, a, b, c] = points.map(|point| point.map(|x| integer(x * power_of_two(-exponent))));
    let minus = |a: [i128; 3], b: [i128; 3]| [0, 1, 2].map(|i: usize| a[i] - b[i]);
    let [u, v] = [minus(b, a), minus(c, a)];
    let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
    let normal = [cross(1, 2), cross(2, 0), cross(0, 1)];
    let height = |x: [i128; 3]| -> i128 { minus(x, a).iter().zip(&normal).map(|(x, n)| x * n).sum() };
    let [n, m] = [height(p), height(q)];
    let weight = n - m;
    let mut point = [0.0; 3];
    for (axis, x) in point.iter_mut().enumerate() {
        let above = (q[axis] - p[axis]) * n;
        // (Without a weight, for a line along the plane, there is no point.)
        if above.checked_rem(weight)? != 0 {
            return None;
        }
        // Between the coordinates of p and q, if these are on two sides of the plane; otherwise possibly too large.
        let whole = i32::try_from(p[axis] + above / weight).ok()?;
        *x = f64::from(whole) * power_of_two(exponent);
    }
    Some(point)
}

/// An integer of at most [`SHORT`] bits.
#[allow(clippy::cast_possible_truncation)] // an integer
fn integer(x: f64) -> i128 {
    assert!(x.trunc() == x && x.abs() < power_of_two(SHORT));
    i128::from(x as i64)
}
