//! Exact signs for any finite doubles, without allocation.
//!
//! If the coordinates of a query span at most 253 bits, integers of a fixed size ([`determinant`]) answer. If they span
//! more, exact numbers are long, and most signs are clear. So [`Ball`]s come first: floating point with proved errors
//! and a separate exponent. Dyadic [`Number`]s then compute exactly what balls leave open. None of them can overflow,
//! underflow or run out of digits.
//!
//! For balls, the point nearest to the origin is the one that is subtracted from the others (exchanging two points only
//! changes the sign). Subtracting a far smaller number leaves a coordinate unchanged. Subtracting a far larger one
//! loses the coordinate in the rounding of the difference, and if all coordinates are lost, so is the sign.
//!
//! # Space of the dyadic numbers
//! In units of the lowest bit of the query, its coordinates are integers below 2^w, w ≤ 2098 as all finite doubles are
//! multiples of 2^−1074 below 2^1024. A sum of N products takes their bits, the logarithm of N rounded up, and a sign:
//!
//! | | degree | terms | below 2^ | bits of the sum |
//! |---|---|---|---|---|
//! | difference | 1 | 2, times one | w + 1 | w + 3 |
//! | cross product | 2 | 2 | 2w + 3 | 2w + 4 |
//! | squared length | 2 | 3 | 2w + 4 | 2w + 5 |
//! | triple product, orient3d | 3 | 3 | 3w + 6 | 3w + 7 |
//! | incircle | 4 | 3 | | 4w + 9 |
//! | insphere | 5 | 4 | | 5w + 13 |
//!
//! Each is at most j(w + 3) for degree j, so with n limbs for w + 3 bits a number of degree j takes jn limbs at most:
//! n = 33 is enough for everything. Coordinates take two limbs each.
//!
//! Coordinates must be finite, as those of a scene are; the functions panic otherwise.

use predicament_arithmetic::Sign;
use predicament_arithmetic::{
    Ball, ExponentRange, Fixed, Parts,
    dyadic::{
        Number, Space,
        Take::{Minus, Plus},
    },
};

use crate::determinant;

/// The sign of (a − c) × (b − c).
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    alternating([a, b, c], orient2d_ball, determinant::orient2d::<4, 8>, orient2d_dyadic)
}

/// The sign of det(a − d, b − d, c − d).
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    alternating([a, b, c, d], orient3d_ball, determinant::orient3d::<4, 8, 12>, orient3d_dyadic)
}

/// The sign of the 3 × 3 determinant of a − d, b − d, c − d, each with its squared length.
#[must_use]
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    alternating([a, b, c, d], incircle_ball, determinant::incircle::<4, 8, 16>, incircle_dyadic)
}

/// The sign of the 4 × 4 determinant of a − e, b − e, c − e, d − e, each with its squared length.
#[must_use]
pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    alternating([a, b, c, d, e], insphere_ball, determinant::insphere::<4, 8, 12, 20>, insphere_dyadic)
}

/// The sign of a determinant that changes its sign when two points change places.
///
/// It tries integers of a fixed size from differences to the last point, then balls, then dyadic numbers, which get the
/// exponent of the lowest bit.
#[inline(always)]
fn alternating<const D: usize, const N: usize, const R: usize>(
    mut points: [[f64; D]; N],
    ball: impl Fn([[f64; D]; N]) -> Ball,
    fixed: impl Fn([[Fixed<FIXED>; D]; R]) -> Sign,
    dyadic: impl Fn([[f64; D]; N], i32) -> Sign,
) -> Sign {
    let Some(ExponentRange { lowest, highest }) = ExponentRange::of(points.as_flattened()) else {
        return Sign::Zero;
    };
    assert!(highest <= 1024, "the coordinates of a scene are finite");
    if highest - lowest <= FIXED_SPAN {
        let mut rows = [[Fixed::ZERO; D]; R];
        for axis in 0..D {
            let origin = fixed_width(points[N - 1][axis], lowest);
            for (row, point) in rows.iter_mut().zip(&points) {
                row[axis] = fixed_width(point[axis], lowest).minus(origin);
            }
        }
        return fixed(rows);
    }
    let nearest = nearest_to_origin(&points);
    points.swap(nearest, N - 1);
    let parity = if nearest == N - 1 { 1.0 } else { -1.0 };
    match ball(points).certain() {
        Some(estimate) => Sign::of(parity * estimate),
        None => Sign::of(parity) * dyadic(points, lowest),
    }
}

/// The number of limbs of a difference in integers of a fixed size.
const FIXED: usize = 4;
/// The largest span of coordinates, in bits, for integers of a fixed size.
///
/// Differences are below 2^254, and the table in [`determinant`] requires b ≤ 64·4 − 2.
const FIXED_SPAN: i32 = 64 * 4 - 3;

/// The integer x·2^−`exponent`, below 2^[`FIXED_SPAN`].
#[inline(always)]
fn fixed_width(x: f64, exponent: i32) -> Fixed<FIXED> {
    if x == 0.0 {
        return Fixed::ZERO;
    }
    let Parts { negative, significand, exponent: own } = Parts::of(x).expect("the coordinates of a scene are finite");
    // The shift drops only zeros.
    let (significand, shift) = match usize::try_from(own - exponent) {
        Ok(shift) => (significand, shift),
        Err(_) => (significand >> (exponent - own), 0),
    };
    let mut limbs = [0; FIXED];
    limbs[shift / 64] = significand << (shift % 64);
    if let Some(above) = limbs.get_mut(shift / 64 + 1) {
        // In two steps, because a shift by 64 would do nothing.
        *above = significand >> 1 >> (63 - shift % 64);
    }
    let magnitude = Fixed::from_limbs(limbs);
    if negative { Fixed::ZERO.minus(magnitude) } else { magnitude }
}

/// The index of the point whose largest coordinate is the smallest; the last one if several are equal.
#[inline(always)]
fn nearest_to_origin<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> usize {
    let largest = points.map(|p| p.iter().fold(0.0, |largest: f64, x| largest.max(x.abs())));
    (0..N - 1).rev().fold(N - 1, |least, i| if largest[i] < largest[least] { i } else { least })
}

/// The number of limbs for each degree.
const DEGREE: usize = 33;
const _: () = assert!(DEGREE * 64 >= 2098 + 3);

#[inline(never)]
fn orient2d_dyadic([a, b, c]: [[f64; 2]; 3], exponent: i32) -> Sign {
    // Differences, and the cross product.
    let mut limbs = [0; 3 * 2 * 2 + (4 + 2) * DEGREE];
    let space = &mut Space::new(&mut limbs);
    let [p, q] = rows(space, [a, b], c, exponent);
    Sign::from(cross(space, p, q).cmp0())
}

#[inline(never)]
fn orient3d_dyadic([a, b, c, d]: [[f64; 3]; 4], exponent: i32) -> Sign {
    // Differences, minors, and the determinant.
    let mut limbs = [0; 4 * 3 * 2 + (9 + 3 * 2 + 3) * DEGREE];
    let space = &mut Space::new(&mut limbs);
    let [p, q, r] = rows(space, [a, b, c], d, exponent);
    let minors = [cross(space, q, r), cross(space, r, p), cross(space, p, q)];
    let [qr, rp, pq] = minors;
    Sign::from(Number::sum(space, [(qr, p[2], Plus), (rp, q[2], Plus), (pq, r[2], Plus)]).cmp0())
}

#[inline(never)]
fn incircle_dyadic([a, b, c, d]: [[f64; 2]; 4], exponent: i32) -> Sign {
    // Differences, minors, squared lengths, and the determinant.
    let mut limbs = [0; 4 * 2 * 2 + (6 + 3 * 2 + 3 * 2 + 4) * DEGREE];
    let space = &mut Space::new(&mut limbs);
    let [p, q, r] = rows(space, [a, b, c], d, exponent);
    let [qr, rp, pq] = [cross(space, q, r), cross(space, r, p), cross(space, p, q)];
    let [pp, qq, rr] = [p, q, r].map(|[x, y]| Number::sum(space, [(x, x, Plus), (y, y, Plus)]));
    Sign::from(Number::sum(space, [(qr, pp, Plus), (rp, qq, Plus), (pq, rr, Plus)]).cmp0())
}

#[inline(never)]
fn insphere_dyadic([a, b, c, d, e]: [[f64; 3]; 5], exponent: i32) -> Sign {
    // Differences, minors, triple products, squared lengths, and the determinant.
    let mut limbs = [0; 5 * 3 * 2 + (12 + 6 * 2 + 4 * 3 + 4 * 2 + 5) * DEGREE];
    let space = &mut Space::new(&mut limbs);
    let [p, q, r, s] = rows(space, [a, b, c, d], e, exponent);
    // Minors of x and y: each is part of two of the triple products.
    let [pq, qr, rs] = [cross(space, p, q), cross(space, q, r), cross(space, r, s)];
    let [sp, rp, sq] = [cross(space, s, p), cross(space, r, p), cross(space, s, q)];
    let [pz, qz, rz, sz] = [p[2], q[2], r[2], s[2]];
    let pqr = Number::sum(space, [(qr, pz, Plus), (rp, qz, Plus), (pq, rz, Plus)]);
    let qrs = Number::sum(space, [(rs, qz, Plus), (sq, rz, Plus), (qr, sz, Plus)]);
    let prs = Number::sum(space, [(rs, pz, Plus), (sp, rz, Plus), (rp, sz, Minus)]);
    let pqs = Number::sum(space, [(pq, sz, Plus), (sp, qz, Plus), (sq, pz, Minus)]);
    let [pp, qq, rr, ss] = [p, q, r, s].map(|[x, y, z]| Number::sum(space, [(x, x, Plus), (y, y, Plus), (z, z, Plus)]));
    let terms = [(ss, pqr, Plus), (qq, prs, Plus), (rr, pqs, Minus), (pp, qrs, Minus)];
    Sign::from(Number::sum(space, terms).cmp0())
}

/// The points minus the origin, in units of 2^`exponent`.
#[inline(always)]
fn rows<'a, const D: usize, const R: usize>(
    space: &mut Space<'a>,
    points: [[f64; D]; R],
    origin: [f64; D],
    exponent: i32,
) -> [[Number<'a>; D]; R] {
    let origin = origin.map(|x| Number::scaled(space, x, -exponent));
    let mut rows = [[Number::ZERO; D]; R];
    for (row, point) in rows.iter_mut().zip(points) {
        for axis in 0..D {
            let x = Number::scaled(space, point[axis], -exponent);
            row[axis] = Number::sum(space, [(x, Number::ONE, Plus), (origin[axis], Number::ONE, Minus)]);
        }
    }
    rows
}

#[inline(always)]
fn cross<'a, const D: usize>(space: &mut Space<'a>, p: [Number; D], q: [Number; D]) -> Number<'a> {
    Number::sum(space, [(p[0], q[1], Plus), (p[1], q[0], Minus)])
}

#[inline(always)]
fn orient2d_ball([a, b, c]: [[f64; 2]; 3]) -> Ball {
    let [a, b] = [a, b].map(|p| ball_minus(p, c));
    ball_cross(&a, &b)
}

#[inline(always)]
fn orient3d_ball([a, b, c, d]: [[f64; 3]; 4]) -> Ball {
    let [a, b, c] = [a, b, c].map(|p| ball_minus(p, d));
    ball_triple(&a, &b, &c)
}

#[inline(always)]
fn incircle_ball([a, b, c, d]: [[f64; 2]; 4]) -> Ball {
    let [a, b, c] = [a, b, c].map(|p| {
        let [x, y] = ball_minus(p, d);
        [x, y, x * x + y * y]
    });
    ball_triple(&a, &b, &c)
}

#[inline(always)]
fn insphere_ball([a, b, c, d, e]: [[f64; 3]; 5]) -> Ball {
    let [a, b, c, d] = [a, b, c, d].map(|p| ball_minus(p, e));
    let lift = |p: &[Ball; 3]| p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    let [ab, bc, cd] = [ball_cross(&a, &b), ball_cross(&b, &c), ball_cross(&c, &d)];
    let [da, ca, db] = [ball_cross(&d, &a), ball_cross(&c, &a), ball_cross(&d, &b)];
    let abc = bc * a[2] + ca * b[2] + ab * c[2];
    let bcd = cd * b[2] + db * c[2] + bc * d[2];
    let acd = cd * a[2] + da * c[2] - ca * d[2];
    let abd = da * b[2] - db * a[2] + ab * d[2];
    (lift(&d) * abc + lift(&b) * acd) - (lift(&c) * abd + lift(&a) * bcd)
}

#[inline(always)]
fn ball_minus<const D: usize>(p: [f64; D], q: [f64; D]) -> [Ball; D] {
    core::array::from_fn(|i| Ball::difference(p[i], q[i]))
}

#[inline(always)]
fn ball_cross<const D: usize>(p: &[Ball; D], q: &[Ball; D]) -> Ball {
    p[0] * q[1] - p[1] * q[0]
}

#[inline(always)]
fn ball_triple(p: &[Ball; 3], q: &[Ball; 3], r: &[Ball; 3]) -> Ball {
    p[2] * ball_cross(q, r) + q[2] * ball_cross(r, p) + r[2] * ball_cross(p, q)
}

#[cfg(test)]
mod tests {
    use super::nearest_to_origin;

    #[test]
    fn the_nearest_is_the_one_with_the_smallest_largest_coordinate_and_the_last_of_equals() {
        assert_eq!(nearest_to_origin(&[[3.0, -1.0], [-2.0, 2.0], [0.0, 4.0]]), 1);
        assert_eq!(nearest_to_origin(&[[1.0, 0.0], [0.0, -1.0], [2.0, 0.0]]), 1);
        assert_eq!(nearest_to_origin(&[[5.0]; 4]), 3);
    }
}
