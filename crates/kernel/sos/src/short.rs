//! Minors with a lift column in integers of one limb.
//!
//! If the filter gives up, a minor is usually zero: the vertex moves along the circle or sphere, or the others are
//! degenerate among themselves. Then this is the cheapest proof. It is the filter's formula, in differences to the last
//! row, including the origin's, in units of some power of two.
//!
//! Differences are less than M = 2^61 in magnitude. Then t = (x − x′) − 2(o − x′) is less than 3M < 2^63, a lift less
//! than 5M² < 2^125, a minor in the plane less than 8M³ < 2^187, and a minor in space less than 3 · 2M² · 5M² < 2^249.

use predicament_arithmetic::{Fixed, short_rows};
use predicament_predicates::Sign;

use crate::filter::Struck;

/// The sign of the minor of three points with one coordinate, the lift and 1; `None` if one limb is not enough.
#[cold]
#[inline(never)]
pub(crate) fn flat<const D: usize>([p, q, r]: [&[f64; D]; 3], column: usize, struck: Struck) -> Option<Sign> {
    let at = |point: &[f64; D]| [point[column], point[struck.column]];
    let [p, q, origin, _] = short_rows([at(p), at(q), [r[column], struck.origin], at(r)])?;
    let row = |[x, y]: [Fixed<1>; 2]| (x, x.times(x).plus(share(y, origin[1])));
    let [(p, p_lift), (q, q_lift)] = [row(p), row(q)];
    let left: Fixed<3> = q_lift.times(p);
    Some(sign(left.minus(p_lift.times(q))))
}

/// The sign of the minor of four points with two coordinates, the lift and 1; `None` if one limb is not enough.
#[cold]
#[inline(never)]
pub(crate) fn solid([p, q, r, s]: [&[f64; 3]; 4], columns: [usize; 2], struck: Struck) -> Option<Sign> {
    let [x, y] = columns;
    let at = |point: &[f64; 3]| [point[x], point[y], point[struck.column]];
    let [p, q, r, origin, _] = short_rows([at(p), at(q), at(r), [s[x], s[y], struck.origin], at(s)])?;
    let row = |[x, y, z]: [Fixed<1>; 3]| ([x, y], x.times(x).plus(y.times(y)).plus(share(z, origin[2])));
    let cross = |[px, py]: [Fixed<1>; 2], [qx, qy]: [Fixed<1>; 2]| -> Fixed<2> {
        let left: Fixed<2> = px.times(qy);
        left.minus(py.times(qx))
    };
    let [(p, p_lift), (q, q_lift), (r, r_lift)] = [row(p), row(q), row(r)];
    let sum: Fixed<4> = cross(q, r).times(p_lift);
    Some(sign(sum.plus(cross(r, p).times(q_lift)).plus(cross(p, q).times(r_lift))))
}

/// The share of the struck column in a lift.
fn share(difference: Fixed<1>, origin: Fixed<1>) -> Fixed<2> {
    difference.times(difference.minus(origin).minus(origin))
}

/// The sign of an integer.
pub(crate) fn sign<const L: usize>(x: Fixed<L>) -> Sign {
    match (x.is_negative(), x.is_zero()) {
        (true, _) => Sign::Negative,
        (_, true) => Sign::Zero,
        _ => Sign::Positive,
    }
}
