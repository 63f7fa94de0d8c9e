//! Exact signs about points that are doubles, and estimates that need not be exact.

use std::cmp::Ordering;
use std::ops::SubAssign;

use predicament_arithmetic::Scaled;
use rug::ops::DivRounding;

type Point = [f64; 2];

/// The relative error bound of a turn, (3 + 16u)u with u = 2^-53, times the magnitudes of its products.
const BOUND: f64 = (3.0 + 16.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
/// The magnitude below which underflow may affect a turn.
const TINY: f64 = 1e-270;

/// The turn a, b, c: the sign of (a − c)₁(b − c)₂ − (a − c)₂(b − c)₁.
///
/// It is computed in doubles if the error bound of Shewchuk's stage A allows: [`BOUND`] times the sum of the magnitudes
/// of the two products. Coordinates below 2^50 do not overflow; determinants below [`TINY`] are computed in integers.
pub fn turn(a: Point, b: Point, c: Point) -> Ordering {
    let [left, right] = [(a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0])];
    let (determinant, magnitude) = (left - right, left.abs() + right.abs());
    if determinant.abs() > BOUND * magnitude && determinant.abs() > TINY {
        return if determinant > 0.0 { Ordering::Greater } else { Ordering::Less };
    }
    let [a, b, c] = Scaled::new([a, b, c]).expect("finite points").integers;
    let mut left = difference(&a[0], &c[0]);
    left *= difference(&b[1], &c[1]);
    let mut right = difference(&a[1], &c[1]);
    right *= difference(&b[0], &c[0]);
    left.cmp(&right)
}

fn difference<T: Clone + for<'t> SubAssign<&'t T>>(a: &T, b: &T) -> T {
    let mut difference = a.clone();
    difference -= b;
    difference
}

/// The nearest integers to the coordinates of the crossing of two segments: each is the i with i − 1/2 ≤ x < i + 1/2.
///
/// `None` for parallel lines.
pub fn crossing_pixel([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<[i64; 2]> {
    let [a, b, c, d, [half, _]] = Scaled::new([a, b, c, d, [0.5; 2]]).expect("finite points").integers;
    let [n, against] = [&a, &b].map(|p| {
        let mut turn = difference(&c[0], &p[0]);
        turn *= difference(&d[1], &p[1]);
        let mut other = difference(&c[1], &p[1]);
        other *= difference(&d[0], &p[0]);
        turn -= other;
        turn
    });
    // a + (b − a)·n/m, n = turn(c, d, a), m = n − turn(c, d, b); a half more, rounded down.
    let m = difference(&n, &against);
    if m.cmp0() == Ordering::Equal {
        return None;
    }
    let mut pixel = [0; 2];
    for (axis, index) in pixel.iter_mut().enumerate() {
        let mut sum = a[axis].clone();
        sum += &half;
        sum *= &m;
        let mut along = difference(&b[axis], &a[axis]);
        along *= &n;
        sum += along;
        let mut unit = m.clone();
        unit *= &half;
        unit *= 2;
        *index = sum.div_floor(unit).to_i64()?;
    }
    Some(pixel)
}

/// An estimate of the crossing of two segments, and an error bound for each coordinate: infinity, if the bound is not
/// known.
///
/// The crossing is a + t(b − a), t = n/(n − m) with the turns n and m of a and b around the other line. Let e and f be
/// bounds on their errors. If their signs are certain and opposite, |n − m| = |n| + |m|, and t is wrong by (|e||m| +
/// |f||n|)/(|n − m||n' − m'|) ≤ (e + f)/|n' − m'|, primes for computed values. The roundings of the difference, the
/// quotient, the product and the sum add less than 5u|b − a| + 2u(|a| + |b|), u = 2^-53.
pub fn crossing_estimate([a, b]: [Point; 2], [c, d]: [Point; 2]) -> (Point, Point) {
    let turn = |p: Point| {
        let [left, right] = [(c[0] - p[0]) * (d[1] - p[1]), (c[1] - p[1]) * (d[0] - p[0])];
        (left - right, BOUND * (left.abs() + right.abs()))
    };
    let ((n, e), (m, f)) = (turn(a), turn(b));
    let along = n / (n - m);
    let is_certain = n.abs() > e && m.abs() > f && (n > 0.0) != (m > 0.0) && n.abs().min(m.abs()) > TINY;
    let wrong = if is_certain { (e + f) / (n - m).abs() * 2.0 } else { f64::INFINITY };
    let estimate = |axis: usize| a[axis] + along * (b[axis] - a[axis]);
    let bound = |axis: usize| {
        let extent = (b[axis] - a[axis]).abs();
        extent * (wrong + 8.0 * f64::EPSILON) + 4.0 * f64::EPSILON * (a[axis].abs() + b[axis].abs())
    };
    ([0, 1].map(estimate), [0, 1].map(bound))
}

/// The distance of a point from a segment, rounded.
pub fn distance(p: Point, [a, b]: [Point; 2]) -> f64 {
    let [ab, ap] = [b, p].map(|to| [to[0] - a[0], to[1] - a[1]]);
    let square = ab[0] * ab[0] + ab[1] * ab[1];
    // (Without length the product is zero, and so is the quotient.)
    let along = ((ab[0] * ap[0] + ab[1] * ap[1]) / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (ap[0] - along * ab[0]).hypot(ap[1] - along * ab[1])
}

/// The value x·2^`exponent`, rounded only if the result is subnormal or too large.
pub fn scale(x: f64, exponent: i32) -> f64 {
    // In two steps: 2^exponent itself may be out of range.
    let half = exponent / 2;
    x * power(half) * power(exponent - half)
}

fn power(exponent: i32) -> f64 {
    predicament_arithmetic::power_of_two(exponent)
}

/// An integer of less than 2^53 as a double, exactly.
#[allow(clippy::cast_precision_loss)] // below 2^53
pub fn double(i: i64) -> f64 {
    assert!(i.unsigned_abs() < 1 << 53);
    i as f64
}
