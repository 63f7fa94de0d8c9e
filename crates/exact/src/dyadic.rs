//! Exact signs for any finite doubles, without allocation.
//!
//! Where the coordinates of a query span at most 253 bits, integers of a fixed
//! size ([`integer`]) answer. Where they span more, exact numbers are long, and
//! most signs are plain: [`Ball`]s, floating point with proved errors and
//! an exponent of its own, come first, and [`Dyadic`]s compute exactly what those
//! leave open. None of them can overflow, underflow or run out of digits.
//!
//! For balls, the point nearest to the origin is made the one that is
//! subtracted from the others (exchanging two points changes the sign, and
//! nothing else). Next to a far smaller number, a coordinate stays what it is; next to
//! a far larger one it is lost in the rounding of the difference, and
//! if this happens to all of them, so is the sign.
//!
//! # Capacity of the dyadic numbers
//! All finite doubles are multiples of 2^−1074 below 2^1024. In units of the lowest
//! bit of the query, its coordinates are integers below 2^2098, differences are below 2^2099, and
//!
//! | | degree | products of differences | below 2^ | limbs | of 2^ |
//! |---|---|---|---|---|---|
//! | difference | 1 | 1 | 2099 | 33 | 2112 |
//! | cross product | 2 | 2 | 4199 | 66 | 4224 |
//! | squared length | 2 | 3 | 4200 | 66 | 4224 |
//! | triple product, orient3d | 3 | 6 | 6300 | 99 | 6336 |
//! | incircle | 4 | 12 | 8400 | 132 | 8448 |
//! | insphere | 5 | 72 | 10502 | 165 | 10560 |
//!
//! so an integer of degree j has 33j limbs at most, and the limbs of two factors add
//! up to those of their product.
//!
//! Coordinates must be finite, as those of a scene are; others make the
//! functions panic.

use predicament_arithmetic::{Ball, Dyadic, ExponentRange, Fixed};
use predicament_predicates::Sign;

use crate::integer;

/// The sign of (a − c) × (b − c).
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    alternating([a, b, c], orient2d_ball, integer::orient2d::<4, 8>, orient2d_dyadic)
}

/// The sign of det(a − d, b − d, c − d).
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    alternating([a, b, c, d], orient3d_ball, integer::orient3d::<4, 8, 12>, orient3d_dyadic)
}

/// The sign of the 3 × 3 determinant of a − d, b − d, c − d, each with its squared length.
#[must_use]
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    alternating([a, b, c, d], incircle_ball, integer::incircle::<4, 8, 16>, incircle_dyadic)
}

/// The sign of the 4 × 4 determinant of a − e, b − e, c − e, d − e, each with its squared length.
#[must_use]
pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    alternating([a, b, c, d, e], insphere_ball, integer::insphere::<4, 8, 12, 20>, insphere_dyadic)
}

/// The sign of a determinant that changes its sign when two points change places:
/// by integers of a fixed size from differences to the last point, by balls, or by
/// dyadic numbers, told the exponent of the lowest bit.
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

/// Limbs of a difference in integers of a fixed size.
const FIXED: usize = 4;
/// The bits that coordinates may span for them: differences are below 2^254,
/// and the table in [`integer`] wants b ≤ 64·4 − 2.
const FIXED_SPAN: i32 = 64 * 4 - 3;

/// x·2^−`exponent`, an integer below 2^[`FIXED_SPAN`].
#[inline(always)]
fn fixed_width(x: f64, exponent: i32) -> Fixed<FIXED> {
    if x == 0.0 {
        return Fixed::ZERO;
    }
    let bits = x.abs().to_bits();
    let (field, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
    let own = i32::try_from(field.max(1)).expect("11 bits") - 1075;
    // Nothing but zeros is shifted out.
    let (significand, shift) = match usize::try_from(own - exponent) {
        Ok(shift) => (significand, shift),
        Err(_) => (significand >> (exponent - own), 0),
    };
    let mut limbs = [0; FIXED];
    limbs[shift / 64] = significand << (shift % 64);
    if let Some(above) = limbs.get_mut(shift / 64 + 1) {
        // In two steps, as a shift by 64 is none.
        *above = significand >> 1 >> (63 - shift % 64);
    }
    let magnitude = Fixed::from_limbs(limbs);
    if x < 0.0 { Fixed::ZERO.minus(magnitude) } else { magnitude }
}

/// The point whose largest coordinate is the smallest; of equals the last.
#[inline(always)]
fn nearest_to_origin<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> usize {
    let largest = points.map(|p| p.iter().fold(0.0, |largest: f64, x| largest.max(x.abs())));
    (0..N - 1).rev().fold(N - 1, |least, i| if largest[i] < largest[least] { i } else { least })
}

/// A coordinate of a point less that of another: degree 1.
type Difference = Dyadic<33>;
/// Degree 2: a minor or a squared length.
type Square = Dyadic<66>;
/// Degree 3.
type Cube = Dyadic<99>;

#[inline(never)]
fn orient2d_dyadic([a, b, c]: [[f64; 2]; 3], exponent: i32) -> Sign {
    let [p, q] = &rows([a, b], c, exponent);
    Sign::from(cross(p, q).cmp0())
}

#[inline(never)]
fn orient3d_dyadic([a, b, c, d]: [[f64; 3]; 4], exponent: i32) -> Sign {
    let [p, q, r] = &rows([a, b, c], d, exponent);
    let minors = [&cross(q, r), &cross(r, p), &cross(p, q)];
    let determinant: Cube = combination(minors, [&p[2], &q[2], &r[2]], Dyadic::assign_sum);
    Sign::from(determinant.cmp0())
}

#[inline(never)]
fn incircle_dyadic([a, b, c, d]: [[f64; 2]; 4], exponent: i32) -> Sign {
    let [p, q, r] = &rows([a, b, c], d, exponent);
    let minors = [&cross(q, r), &cross(r, p), &cross(p, q)];
    let determinant: Dyadic<132> = combination(minors, [&lift(p), &lift(q), &lift(r)], Dyadic::assign_sum);
    Sign::from(determinant.cmp0())
}

#[inline(never)]
fn insphere_dyadic([a, b, c, d, e]: [[f64; 3]; 5], exponent: i32) -> Sign {
    let [p, q, r, s] = &rows([a, b, c, d], e, exponent);
    // Minors of x and y: each is part of two of the triple products.
    let [pq, qr, rs] = [&cross(p, q), &cross(q, r), &cross(r, s)];
    let [sp, rp, sq] = [&cross(s, p), &cross(r, p), &cross(s, q)];
    let [pz, qz, rz, sz] = [&p[2], &q[2], &r[2], &s[2]];
    let pqr: Cube = combination([qr, rp, pq], [pz, qz, rz], Dyadic::assign_sum);
    let qrs: Cube = combination([rs, sq, qr], [qz, rz, sz], Dyadic::assign_sum);
    let prs: Cube = combination([rs, sp, rp], [pz, rz, sz], Dyadic::assign_difference);
    let pqs: Cube = combination([pq, sp, sq], [sz, qz, pz], Dyadic::assign_difference);
    let three: Dyadic<165> = combination([&lift(s), &lift(q), &lift(r)], [&pqr, &prs, &pqs], Dyadic::assign_difference);
    let last = Dyadic::<165>::product(&lift(p), &qrs);
    Sign::from(Dyadic::<165>::difference(&three, &last).cmp0())
}

/// The points less the origin.
#[inline(always)]
fn rows<const D: usize, const R: usize>(
    points: [[f64; D]; R],
    origin: [f64; D],
    exponent: i32,
) -> [[Difference; D]; R] {
    let double = |x| Dyadic::<2>::from_f64_scaled(x, exponent);
    let mut rows = [const { [const { Dyadic::ZERO }; D] }; R];
    for axis in 0..D {
        let origin = double(origin[axis]);
        for (row, point) in rows.iter_mut().zip(points) {
            row[axis].assign_difference(&double(point[axis]), &origin);
        }
    }
    rows
}

#[inline(always)]
fn cross<const D: usize>(p: &[Difference; D], q: &[Difference; D]) -> Square {
    Square::difference(&Square::product(&p[0], &q[1]), &Square::product(&p[1], &q[0]))
}

/// The squared length.
#[inline(always)]
fn lift<const D: usize>(p: &[Difference; D]) -> Square {
    let [mut lift, mut square, mut longer] = [const { Square::ZERO }; 3];
    for x in p {
        square.assign_product(x, x);
        longer.assign_sum(&lift, &square);
        std::mem::swap(&mut lift, &mut longer);
    }
    lift
}

/// x₁y₁ + x₂y₂ ± x₃y₃.
#[inline(always)]
fn combination<const X: usize, const Y: usize, const N: usize>(
    x: [&Dyadic<X>; 3],
    y: [&Dyadic<Y>; 3],
    assign_last: impl Fn(&mut Dyadic<N>, &Dyadic<N>, &Dyadic<N>),
) -> Dyadic<N> {
    let [mut first, mut second, mut sum] = [const { Dyadic::ZERO }; 3];
    first.assign_product(x[0], y[0]);
    second.assign_product(x[1], y[1]);
    sum.assign_sum(&first, &second);
    first.assign_product(x[2], y[2]);
    assign_last(&mut second, &sum, &first);
    second
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
    std::array::from_fn(|i| Ball::difference(p[i], q[i]))
}

#[inline(always)]
fn ball_cross<const D: usize>(p: &[Ball; D], q: &[Ball; D]) -> Ball {
    p[0] * q[1] - p[1] * q[0]
}

#[inline(always)]
fn ball_triple(p: &[Ball; 3], q: &[Ball; 3], r: &[Ball; 3]) -> Ball {
    p[2] * ball_cross(q, r) + q[2] * ball_cross(r, p) + r[2] * ball_cross(p, q)
}
