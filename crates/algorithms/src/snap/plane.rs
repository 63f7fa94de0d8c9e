//! Exact signs about points that are doubles, and what need not be exact.

use std::cmp::Ordering;
use std::ops::SubAssign;

use predicament_arithmetic::Scaled;

type Point = [f64; 2];

/// The turn a, b, c: the sign of (a − c)₁(b − c)₂ − (a − c)₂(b − c)₁.
///
/// In doubles where the error bound of Shewchuk's stage A allows: (3 + 16u)u times the sum of the magnitudes of the two products,
/// u = 2^-53. Coordinates below 2^50 do not overflow; products of less than 2^-900 are left to integers, as they may underflow.
pub fn turn(a: Point, b: Point, c: Point) -> Ordering {
    const BOUND: f64 = (3.0 + 16.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
    let [left, right] = [(a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0])];
    let (determinant, magnitude) = (left - right, left.abs() + right.abs());
    if determinant.abs() > BOUND * magnitude && determinant.abs() > 1e-270 {
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

/// How the coordinate of the crossing of two lines along an axis compares to a value; none for parallel lines.
pub fn crossing_against([a, b]: [Point; 2], [c, d]: [Point; 2], axis: usize, value: f64) -> Option<Ordering> {
    let [a, b, c, d, v] = Scaled::new([a, b, c, d, [value; 2]]).expect("finite points").integers;
    let [n, against] = [&a, &b].map(|p| {
        let mut turn = difference(&c[0], &p[0]);
        turn *= difference(&d[1], &p[1]);
        let mut other = difference(&c[1], &p[1]);
        other *= difference(&d[0], &p[0]);
        turn -= other;
        turn
    });
    // a + (b − a)·n/m, n = turn(c, d, a), m = n − turn(c, d, b).
    let m = difference(&n, &against);
    let parallel = m.cmp0() == Ordering::Equal;
    let mut sum = difference(&a[axis], &v[axis]);
    sum *= &m;
    let mut along = difference(&b[axis], &a[axis]);
    along *= &n;
    sum += along;
    let sign = if m.cmp0() == Ordering::Less { sum.cmp0().reverse() } else { sum.cmp0() };
    (!parallel).then_some(sign)
}

/// An estimate of the crossing of two lines: any double, if they are nearly parallel.
pub fn crossing_estimate([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    let turn = |p: Point| (c[0] - p[0]) * (d[1] - p[1]) - (c[1] - p[1]) * (d[0] - p[0]);
    let (n, m) = (turn(a), turn(b));
    let along = n / (n - m);
    [0, 1].map(|axis| a[axis] + along * (b[axis] - a[axis]))
}

/// The distance of a point from a segment, rounded.
pub fn distance(p: Point, [a, b]: [Point; 2]) -> f64 {
    let [ab, ap] = [b, p].map(|to| [to[0] - a[0], to[1] - a[1]]);
    let square = ab[0] * ab[0] + ab[1] * ab[1];
    let along = if square > 0.0 { ((ab[0] * ap[0] + ab[1] * ap[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (ap[0] - along * ab[0]).hypot(ap[1] - along * ab[1])
}

/// x·2^`exponent`, rounded only where the result is subnormal or too large.
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
    debug_assert!(i.unsigned_abs() < 1 << 53);
    i as f64
}
