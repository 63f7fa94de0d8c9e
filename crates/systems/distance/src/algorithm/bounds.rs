//! Bounds of distances, in doubles: from below between boxes, from above between simplices.
//!
//! Both hold whatever the rounding errors are, for all finite doubles. They select candidates; predicates decide.

use predicament_grid::Bounds;

/// A relative error that is larger than the rounding errors of a distance: a few units of 2⁻⁵³.
const ERROR: f64 = 1e-12;

/// A number that is at most the distance of two boxes. Zero if the boxes meet.
pub(super) fn below(one: &Bounds<3>, other: &Bounds<3>) -> f64 {
    // A difference is rounded once, so the double before it is not larger than the true gap.
    let gap = |axis: usize| {
        let gap = (one.low[axis] - other.high[axis]).max(other.low[axis] - one.high[axis]);
        if gap > 0.0 { gap.min(f64::MAX).next_down() } else { 0.0 }
    };
    let gaps = [gap(0), gap(1), gap(2)];
    let largest = gaps.into_iter().fold(0.0, f64::max);
    if largest == 0.0 {
        return 0.0;
    }
    // Quotients neither overflow nor lose the largest gap.
    let sum: f64 = gaps.iter().map(|gap| (gap / largest) * (gap / largest)).sum();
    (largest * (sum.sqrt() * (1.0 - ERROR))).clamp(0.0, f64::MAX).next_down().max(0.0)
}

type Point = [f64; 3];

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn dot(p: Point, q: Point) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn along(p: Point, weighted: &[(f64, Point)]) -> Point {
    weighted.iter().fold(p, |p, (t, u)| [p[0] + t * u[0], p[1] + t * u[1], p[2] + t * u[2]])
}

fn length(p: Point) -> f64 {
    dot(p, p).sqrt()
}

/// A number that is at least the distance of two simplices: that of a point of one and a point of the other.
///
/// A simplex has at most three corners. The points are those that doubles take for the nearest. Coordinates are from
/// one corner on, and the largest difference is scaled to 1.
pub(super) fn above(one: &[Point], other: &[Point]) -> f64 {
    let Some(&origin) = one.first() else { return f64::INFINITY };
    let halved = |p: &Point| [0, 1, 2].map(|axis: usize| p[axis] / 2.0 - origin[axis] / 2.0);
    let size = one.iter().chain(other).flat_map(halved).fold(0.0_f64, |size, x| size.max(x.abs()));
    if size == 0.0 {
        return f64::from_bits(4);
    }
    let scaled = |points: &[Point]| {
        let mut scaled = [[0.0; 3]; 3];
        scaled.iter_mut().zip(points).for_each(|(to, p)| *to = halved(p).map(|x| x / size));
        scaled
    };
    let (of_one, of_other) = (scaled(one), scaled(other));
    let (one, other) = (&of_one[..one.len()], &of_other[..other.len()]);
    let mut least = f64::INFINITY;
    let mut note = |distance: f64| least = least.min(distance);
    for (points, simplex) in [(one, other), (other, one)] {
        for &p in points {
            simplex.iter().for_each(|&q| note(length(minus(p, q))));
            edges(simplex).for_each(|[a, b]| note(to_edge(p, a, b)));
            if let [a, b, c] = simplex[..] {
                note(to_face(p, a, b, c));
            }
        }
    }
    for [a, b] in edges(one) {
        edges(other).for_each(|[c, d]| note(of_edges(a, b, c, d)));
    }
    (size * ((least + ERROR) * 2.0)).next_up() + f64::from_bits(8)
}

fn edges(corners: &[Point]) -> impl Iterator<Item = [Point; 2]> {
    let count = if corners.len() == 2 { 1 } else { corners.len() };
    (0..count).map(move |at| [corners[at], corners[(at + 1) % corners.len()]])
}

fn to_edge(p: Point, a: Point, b: Point) -> f64 {
    let u = minus(b, a);
    let t = dot(minus(p, a), u) / dot(u, u);
    if (0.0..=1.0).contains(&t) { length(minus(along(a, &[(t, u)]), p)) } else { f64::INFINITY }
}

/// The solution of two equations with the matrix of products of u and v.
fn solve(u: Point, v: Point, right: [f64; 2]) -> [f64; 2] {
    let [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
    let determinant = uu * vv - uv * uv;
    [(right[0] * vv - right[1] * uv) / determinant, (right[1] * uu - right[0] * uv) / determinant]
}

fn to_face(p: Point, a: Point, b: Point, c: Point) -> f64 {
    let [u, v, w] = [minus(b, a), minus(c, a), minus(p, a)];
    let [s, t] = solve(u, v, [dot(u, w), dot(v, w)]);
    let is_within = s >= 0.0 && t >= 0.0 && s + t <= 1.0;
    if is_within { length(minus(along(a, &[(s, u), (t, v)]), p)) } else { f64::INFINITY }
}

fn of_edges(a: Point, b: Point, c: Point, d: Point) -> f64 {
    let [u, v, w] = [minus(b, a), minus(c, d), minus(c, a)];
    let [s, t] = solve(u, v, [dot(u, w), dot(v, w)]);
    let is_within = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    if is_within { length(minus(along(a, &[(s, u)]), along(c, &[(-t, v)]))) } else { f64::INFINITY }
}
