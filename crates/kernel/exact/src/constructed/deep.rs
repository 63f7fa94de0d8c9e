//! Vertices that constructed vertices define, at any depth.
//!
//! Each level multiplies the degree of a row: by four for lines, by nine for three planes. Most cascades do not need
//! such numbers, as lines and planes recur (the line through two vertices of one line is that line), and common factors
//! with them. So rows are integers of any length in lowest terms, which represent the rational point exactly.
//!
//! Joins and meets of homogeneous rows need no special case for weights: the line through two points and the plane
//! through three are the cross products of their rows, and so is the point of two lines or three planes; the line p, q
//! meets the plane f at f(q)·p − f(p)·q. A share p/q of the row (a, v) and the rest of (c, w) make the row
//! (p·w·a + (q − p)·v·c, q·v·w).

use alloc::vec::Vec;
use predicament_arithmetic::{
    BigInt,
    dyadic::{Number, Space},
};
use predicament_predicates::{
    Axis::{X, Y, Z},
    Construction, Dimension, NoPoint, Share, Vertex,
};

use super::{
    rows::{Row as Stored, View},
    whole,
};

/// A homogeneous row: coordinates and weight.
type Row<const N: usize> = [BigInt; N];

/// The construction's row, or the reason why it defines no point.
///
/// The rows of the vertices that define it must exist.
pub(super) fn row(rows: View, construction: &Construction) -> Result<Stored, NoPoint> {
    Ok(match *construction {
        Construction::Ssi(lines) => {
            let [first, second] = lines.map(|line| line.map(|v| flat(rows, v)));
            store(rows, meet(join(&first)?, join(&second)?)?)
        }
        Construction::Lpi { line, plane } => {
            let (line, plane) = (line.map(|v| solid(rows, v)), plane.map(|v| solid(rows, v)));
            store(rows, pierce(&line, &span(&plane)?)?)
        }
        Construction::Tpi(planes) => {
            let [l, m, n] = planes.map(|plane| plane.map(|v| solid(rows, v)));
            let planes = [span(&l)?, span(&m)?, span(&n)?];
            let point = minors(&planes);
            if point[3].is_zero() {
                return Err(NoPoint::Planes);
            }
            store(rows, point)
        }
        Construction::Ratio { ends, share } => match rows.scene.dimension() {
            Dimension::Two => store(rows, shared(&ends.map(|v| flat(rows, v)), share)),
            Dimension::Three => store(rows, shared(&ends.map(|v| solid(rows, v)), share)),
        },
    })
}

/// The point with this share of the first point, and the rest of the second.
fn shared<const N: usize>([a, c]: &[Row<N>; 2], share: Share) -> Row<N> {
    let ([p, q], [rest, _]) = (share.fraction().map(BigInt::from), share.rest().fraction().map(BigInt::from));
    let [v, w] = [&a[N - 1], &c[N - 1]];
    let (of_a, of_c) = (&p * w, &rest * v);
    let mut point: Row<N> = core::array::from_fn(|i| &(&of_a * &a[i]) + &(&of_c * &c[i]));
    point[N - 1] = &(&q * v) * w;
    point
}

fn flat(rows: View, v: Vertex) -> Row<3> {
    whole::integers(&rows.of(&mut Space::new(&mut [0; 2 * 2]), rows.known(v), [X, Y]))
}

fn solid(rows: View, v: Vertex) -> Row<4> {
    whole::integers(&rows.of(&mut Space::new(&mut [0; 2 * 3]), rows.known(v), [X, Y, Z]))
}

/// The line through two points of the plane.
fn join([p, q]: &[Row<3>; 2]) -> Result<Row<3>, NoPoint> {
    let line = cross(p, q);
    // Two points with weights have a line through them unless they are equal.
    if line.iter().all(BigInt::is_zero) { Err(NoPoint::SegmentEnds) } else { Ok(line) }
}

/// The point of two lines.
fn meet(first: Row<3>, second: Row<3>) -> Result<Row<3>, NoPoint> {
    let point = cross(&first, &second);
    if point[2].is_zero() { Err(NoPoint::ParallelLines) } else { Ok(point) }
}

/// The plane through three points.
fn span(points: &[Row<4>; 3]) -> Result<Row<4>, NoPoint> {
    let plane = minors(points);
    if plane.iter().all(BigInt::is_zero) { Err(NoPoint::CollinearPlane) } else { Ok(plane) }
}

/// The point of a line and a plane.
fn pierce([p, q]: &[Row<4>; 2], plane: &Row<4>) -> Result<Row<4>, NoPoint> {
    if (0..3).all(|i| minor(p, q, i, 3).is_zero()) {
        return Err(NoPoint::LineEnds);
    }
    let at = |point: &Row<4>| plane.iter().zip(point).fold(BigInt::ZERO, |sum, (f, x)| &sum + &(f * x));
    let (at_p, at_q) = (at(p), at(q));
    let point: Row<4> = core::array::from_fn(|i| &(&at_q * &p[i]) - &(&at_p * &q[i]));
    if point[3].is_zero() { Err(NoPoint::ParallelToPlane) } else { Ok(point) }
}

fn minor<const N: usize>(p: &Row<N>, q: &Row<N>, i: usize, j: usize) -> BigInt {
    &(&p[i] * &q[j]) - &(&p[j] * &q[i])
}

fn cross(p: &Row<3>, q: &Row<3>) -> Row<3> {
    [minor(p, q, 1, 2), minor(p, q, 2, 0), minor(p, q, 0, 1)]
}

/// The signed 3 × 3 minors: a vector orthogonal to all three rows.
fn minors([p, q, r]: &[Row<4>; 3]) -> Row<4> {
    let without = |column: usize| {
        let [i, j, k] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]][column];
        let [first, second, third] =
            [(i, [j, k]), (j, [i, k]), (k, [i, j])].map(|(at, [j, k])| &minor(q, r, j, k) * &p[at]);
        let sum = &(&first - &second) + &third;
        if column.is_multiple_of(2) { sum } else { -sum }
    };
    core::array::from_fn(without)
}

/// Stores a row in lowest terms.
fn store<const N: usize>(rows: View, row: Row<N>) -> Stored {
    let divisor = row.iter().fold(BigInt::ZERO, |divisor, x| divisor.gcd(x));
    let lowest = row.each_ref().map(|x| x.div_exact(&divisor));
    let number = |i: usize| {
        let limbs = lowest[i].limbs();
        let zeros = limbs.iter().take_while(|&&limb| limb == 0).count();
        let low = i32::try_from(zeros).expect("fewer than 2^31 limbs");
        Number { limbs: &limbs[zeros..], low, negative: row[i].is_negative() }
    };
    let coordinates: Vec<Number> = (0..N - 1).map(number).collect();
    rows.store(&coordinates, number(N - 1))
}
