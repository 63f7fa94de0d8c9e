//! Constructed vertices as rational points, by the parametric form of lines and the normals of planes.

use predicament_predicates::{Construction, NoPoint, Share, Vertex};
use rug::Rational;

use super::determinant::{Point, minus, three, two};

/// The point of a construction, from the points of its vertices.
///
/// # Errors
/// The reason why its lines and planes do not meet in a unique point.
pub(super) fn point<'p>(
    construction: &Construction,
    of: impl Fn(Vertex) -> Point<'p>,
) -> Result<Vec<Rational>, NoPoint> {
    match *construction {
        Construction::Ssi(lines) => segments(lines.map(|line| line.map(&of))),
        Construction::Lpi { line, plane } => line_plane(line.map(&of), plane.map(&of)),
        Construction::Tpi(planes) => three_planes(planes.map(|plane| plane.map(&of))),
        Construction::Ratio { ends, share } => Ok(shared(ends.map(&of), share)),
    }
}

/// The point a + t(b − a) with t = (c − a) × (d − c) / (b − a) × (d − c).
fn segments([[a, b], [c, d]]: [[Point; 2]; 2]) -> Result<Vec<Rational>, NoPoint> {
    let [u, v, way] = [minus(b, a, [0, 1]), minus(d, c, [0, 1]), minus(c, a, [0, 1])];
    if is_zero(&u) || is_zero(&v) {
        return Err(NoPoint::SegmentEnds);
    }
    let turn = two([&u, &v]);
    if turn.is_zero() {
        return Err(NoPoint::ParallelLines);
    }
    Ok(along(a, &u, &(two([&way, &v]) / turn)))
}

/// The point p + t(q − p) with t = N·(r − p) / N·(q − p), N the normal of the plane through r.
fn line_plane([p, q]: [Point; 2], plane: [Point; 3]) -> Result<Vec<Rational>, NoPoint> {
    let (u, normal) = (minus(q, p, [0, 1, 2]), normal(plane)?);
    if is_zero(&u) {
        return Err(NoPoint::LineEnds);
    }
    let rise = dot(&normal, &u);
    if rise.is_zero() {
        return Err(NoPoint::ParallelToPlane);
    }
    Ok(along(p, &u, &(dot(&normal, &minus(plane[0], p, [0, 1, 2])) / rise)))
}

/// The point (l M × N + m N × L + n L × M) / L·(M × N) of the planes L·x = l, M·x = m, N·x = n.
fn three_planes(planes: [[Point; 3]; 3]) -> Result<Vec<Rational>, NoPoint> {
    let [p, q, r] = planes.map(|plane| plane[0]);
    let [first, second, third] = planes.map(normal);
    let [first, second, third] = [first?, second?, third?];
    let weight = three([&first, &second, &third]);
    if weight.is_zero() {
        return Err(NoPoint::Planes);
    }
    let parts = [
        (dot(&first, p), cross(&second, &third)),
        (dot(&second, q), cross(&third, &first)),
        (dot(&third, r), cross(&first, &second)),
    ];
    let coordinate = |axis: usize| -> Rational {
        parts.iter().map(|(height, direction)| Rational::from(height * &direction[axis])).sum()
    };
    Ok((0..3).map(|axis| coordinate(axis) / &weight).collect())
}

/// The point αa + (1 − α)c.
fn shared([a, c]: [Point; 2], share: Share) -> Vec<Rational> {
    let of_a = Rational::from(<(i64, i64)>::from(share.fraction()));
    let of_c = Rational::from(1 - &of_a);
    a.iter().zip(c).map(|(a, c)| Rational::from(a * &of_a) + Rational::from(c * &of_c)).collect()
}

/// The point p + t u.
fn along(p: Point, u: &[Rational], t: &Rational) -> Vec<Rational> {
    p.iter().zip(u).map(|(p, u)| Rational::from(u * t) + p).collect()
}

/// The normal of a plane through three points.
fn normal([r, s, t]: [Point; 3]) -> Result<[Rational; 3], NoPoint> {
    let normal = cross(&minus(s, r, [0, 1, 2]), &minus(t, r, [0, 1, 2]));
    if is_zero(&normal) { Err(NoPoint::CollinearPlane) } else { Ok(normal) }
}

fn cross(p: &[Rational; 3], q: &[Rational; 3]) -> [Rational; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i]))
}

fn dot(p: &[Rational], q: &[Rational]) -> Rational {
    p.iter().zip(q).map(|(p, q)| Rational::from(p * q)).sum()
}

fn is_zero(vector: &[Rational]) -> bool {
    vector.iter().all(Rational::is_zero)
}
