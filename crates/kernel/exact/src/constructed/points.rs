//! The exact homogeneous row of a construction through input vertices.
//!
//! Lines and planes through constructed vertices are in [`deep`].
//!
//! Each point is a vertex plus a multiple of a direction, P = p + (n/w)·u, by Cramer's rule on differences; then (w·p +
//! n·u, w) is its row.
//!
//! | kind | w | row |
//! |---|---|---|
//! | lines ab, cd | (b − a) × (d − c), degree 2 | w·a + ((c − a) × (d − c))(b − a), degree 3 |
//! | line pq, plane rst with normal N | N·(q − p), degree 3 | w·p + (N·(r − p))(q − p), degree 4 |
//! | planes with normals L, M, N through p, q, r | L·(M × N), degree 6 | w·p + (M·(q − p))(N × L) + (N·(r − p))(L × M), degree 7 |
//! | the share p/q of a, the rest of c | q | p·a + (q − p)·c, degree 1 |
//!
//! # Capacity
//! If coordinates are below 2^58, differences are below 2^59, normals below 2^119, w of degree 3 below 2^180
//! and of degree 6 below 2^360, and the rows below 2^179, 2^240 and 2^421: degree k stays below 2^(61·k). If
//! coordinates are multiples of 2^(64·l), l ≤ 0, degree k is a multiple of 2^(64·k·l). [`Number::sum`] takes a sign and
//! up to two bits for three terms; four are granted. So degree k takes as many limbs as its share of degree 7 has, and
//! less than 17/16 beside. The 48 sums for three planes have degrees that add up to 111: less than 16 capacities and 51
//! limbs. The other kinds, whose capacities are for degree 3 and 4, take 6 and 9 capacities and less beside. A share's
//! whole numbers are at most 2^53, so its row is below 2^112 and takes the capacity of degree 2, three times at most.

use predicament_arithmetic::dyadic::{
    Number, Space,
    Take::{Minus, Plus},
};
use predicament_predicates::{
    Axis::{X, Y, Z},
    Construction, Dimension, NoPoint, Share,
};

use super::{
    deep,
    rows::{Row, View},
};

type Point<'a, const D: usize> = [Number<'a>; D];

/// The maximum number of capacities for one construction: 16, and 51 limbs in capacities of 9 or more.
const NUMBERS: usize = 16 + 6;

/// The construction's row, or the reason why it defines no point.
///
/// The rows of the vertices that define it must exist.
#[cold]
#[inline(never)]
pub(super) fn row(rows: View, construction: &Construction) -> Result<Row, NoPoint> {
    if !construction.is_of_inputs() {
        return deep::row(rows, construction);
    }
    let mut held = [[0; 2]; 3 * 9];
    let space = &mut Space::new(held.as_flattened_mut());
    match *construction {
        Construction::Ssi(lines) => {
            let lines = lines.map(|line| line.map(|v| rows.input(space, v, [X, Y])));
            let limbs = limbs(lines.as_flattened().as_flattened(), 3);
            with_capacity!(limbs, CAP => segments::<CAP>(rows, lines))
        }
        Construction::Lpi { line, plane } => {
            let line = line.map(|v| rows.input(space, v, [X, Y, Z]));
            let plane = plane.map(|v| rows.input(space, v, [X, Y, Z]));
            let limbs = limbs(line.as_flattened(), 4).max(limbs(plane.as_flattened(), 4));
            with_capacity!(limbs, CAP => line_plane::<CAP>(rows, line, plane))
        }
        Construction::Tpi(planes) => {
            let planes = planes.map(|plane| plane.map(|v| rows.input(space, v, [X, Y, Z])));
            let limbs = limbs(planes.as_flattened().as_flattened(), 7);
            with_capacity!(limbs, CAP => planes_point::<CAP>(rows, planes))
        }
        Construction::Ratio { ends, share } => Ok(match rows.scene.dimension() {
            Dimension::Two => {
                let ends = ends.map(|v| rows.input(space, v, [X, Y]));
                let limbs = limbs(ends.as_flattened(), 2);
                with_capacity!(limbs, CAP => shared::<2, CAP>(rows, ends, share))
            }
            Dimension::Three => {
                let ends = ends.map(|v| rows.input(space, v, [X, Y, Z]));
                let limbs = limbs(ends.as_flattened(), 2);
                with_capacity!(limbs, CAP => shared::<3, CAP>(rows, ends, share))
            }
        }),
    }
}

#[inline(never)]
fn shared<const D: usize, const CAP: usize>(rows: View, [a, c]: [Point<D>; 2], share: Share) -> Row {
    let mut limbs = [[0; CAP]; D];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let ([p, q], [rest, _]) = (share.fraction(), share.rest().fraction());
    let held = [p, rest, q].map(|x| [x.unsigned_abs()]);
    let [p, rest, q] = [(p, &held[0]), (rest, &held[1]), (q, &held[2])].map(|(x, held)| match x {
        0 => Number::ZERO,
        _ => Number { limbs: held, low: 0, negative: x < 0 },
    });
    let point: Point<D> = core::array::from_fn(|i| Number::sum(space, [(a[i], p, Plus), (c[i], rest, Plus)]));
    rows.store(&point, q)
}

#[inline(never)] // so that the stack frame has the size of this capacity
fn segments<const CAP: usize>(rows: View, lines: [[Point<2>; 2]; 2]) -> Result<Row, NoPoint> {
    let mut limbs = [[0; CAP]; NUMBERS];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let [[a, b], [c, d]] = lines;
    let [u, v, s] = [minus(space, b, a), minus(space, d, c), minus(space, c, a)];
    if is_zero(u) || is_zero(v) {
        return Err(NoPoint::SegmentEnds);
    }
    let weight = minor(space, u, v, 0, 1);
    if weight.is_zero() {
        return Err(NoPoint::ParallelLines);
    }
    let along = minor(space, s, v, 0, 1);
    Ok(rows.store(&moved(space, a, weight, along, u), weight))
}

#[inline(never)]
fn line_plane<const CAP: usize>(rows: View, [p, q]: [Point<3>; 2], plane: [Point<3>; 3]) -> Result<Row, NoPoint> {
    let mut limbs = [[0; CAP]; NUMBERS];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let (u, normal) = (minus(space, q, p), normal(space, plane)?);
    if is_zero(u) {
        return Err(NoPoint::LineEnds);
    }
    let weight = dot(space, normal, u);
    if weight.is_zero() {
        return Err(NoPoint::ParallelToPlane);
    }
    let way = minus(space, plane[0], p);
    let along = dot(space, normal, way);
    Ok(rows.store(&moved(space, p, weight, along, u), weight))
}

#[inline(never)]
fn planes_point<const CAP: usize>(rows: View, planes: [[Point<3>; 3]; 3]) -> Result<Row, NoPoint> {
    let mut limbs = [[0; CAP]; NUMBERS];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let [[p, ..], [q, ..], [r, ..]] = planes;
    let [l, m, n] = [normal(space, planes[0])?, normal(space, planes[1])?, normal(space, planes[2])?];
    let [lm, mn, nl] = [cross(space, l, m), cross(space, m, n), cross(space, n, l)];
    let weight = dot(space, l, mn);
    if weight.is_zero() {
        return Err(NoPoint::Planes);
    }
    let [to_second, to_third] = [minus(space, q, p), minus(space, r, p)];
    let [second, third] = [dot(space, m, to_second), dot(space, n, to_third)];
    let point =
        [0, 1, 2].map(|i| Number::sum(space, [(p[i], weight, Plus), (second, nl[i], Plus), (third, lm[i], Plus)]));
    Ok(rows.store(&point, weight))
}

/// The normal of the plane of three points.
fn normal<'a>(space: &mut Space<'a>, [r, s, t]: [Point<'a, 3>; 3]) -> Result<Point<'a, 3>, NoPoint> {
    let [u, v] = [minus(space, s, r), minus(space, t, r)];
    let normal = cross(space, u, v);
    if is_zero(normal) { Err(NoPoint::CollinearPlane) } else { Ok(normal) }
}

fn minus<'a, const D: usize>(space: &mut Space<'a>, p: Point<D>, q: Point<D>) -> Point<'a, D> {
    core::array::from_fn(|i| Number::sum(space, [(p[i], Number::ONE, Plus), (q[i], Number::ONE, Minus)]))
}

fn minor<'a, const D: usize>(space: &mut Space<'a>, p: Point<D>, q: Point<D>, i: usize, j: usize) -> Number<'a> {
    Number::sum(space, [(p[i], q[j], Plus), (p[j], q[i], Minus)])
}

fn cross<'a>(space: &mut Space<'a>, p: Point<3>, q: Point<3>) -> Point<'a, 3> {
    [minor(space, p, q, 1, 2), minor(space, p, q, 2, 0), minor(space, p, q, 0, 1)]
}

fn dot<'a>(space: &mut Space<'a>, p: Point<3>, q: Point<3>) -> Number<'a> {
    Number::sum(space, [(p[0], q[0], Plus), (p[1], q[1], Plus), (p[2], q[2], Plus)])
}

/// The coordinates w·p + n·u.
fn moved<'a, const D: usize>(
    space: &mut Space<'a>,
    p: Point<D>,
    weight: Number,
    along: Number,
    u: Point<D>,
) -> Point<'a, D> {
    core::array::from_fn(|i| Number::sum(space, [(p[i], weight, Plus), (along, u[i], Plus)]))
}

fn is_zero<const D: usize>(vector: Point<D>) -> bool {
    vector.iter().all(|x| x.is_zero())
}

/// The limbs that a polynomial of this degree in these coordinates needs.
fn limbs(coordinates: &[Number], degree: i32) -> usize {
    let low = coordinates.iter().map(|x| x.low).min().unwrap_or(0).min(0);
    usize::try_from(degree * (61 - 64 * low) + 4).unwrap_or(0).div_ceil(64)
}
