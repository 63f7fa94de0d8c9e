//! Rational points of the plane.

use std::cmp::Ordering;

use rug::{Complete, Integer, Rational};

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::sum::sum;

/// A point of the plane, with rational coordinates.
pub type Point = [Rational; 2];

/// The value (b − a) × (p − a).
pub(super) fn turn(a: &Point, b: &Point, p: &Point) -> Rational {
    let minus = |p: &Point, i: usize| Rational::from(&p[i] - &a[i]);
    minus(b, 0) * minus(p, 1) - minus(b, 1) * minus(p, 0)
}

/// The side of p on the line from a to b: the sign of [`turn`].
///
/// Numerators decide, over denominators that are never reduced: reducing takes most of the time of rationals.
pub(in crate::checks) fn side(a: &Point, b: &Point, p: &Point) -> Ordering {
    let to =
        |p: &Point, i: usize| -> Integer { (p[i].numer() * a[i].denom()).complete() - p[i].denom() * a[i].numer() };
    let products = [[to(b, 0), to(p, 1)], [to(b, 1), to(p, 0)]];
    let [left, right] = products.each_ref().map(|[x, y]| x.cmp0() as i8 * y.cmp0() as i8);
    if left != right || left == 0 {
        return left.cmp(&right);
    }
    let [left, right] = products.map(|[x, y]| x * y);
    let [of_left, of_right] = [[0, 1], [1, 0]].map(|[i, j]: [usize; 2]| (b[i].denom() * p[j].denom()).complete());
    (left * of_right).cmp(&(right * of_left))
}

/// True if p, which is on the line of a and b, is not beyond either.
pub(super) fn is_between(a: &Point, b: &Point, p: &Point) -> bool {
    (0..2).all(|i| (a[i] <= p[i] && p[i] <= b[i]) || (b[i] <= p[i] && p[i] <= a[i]))
}

/// True if p is on the closed segment from a to b.
pub(super) fn is_on(a: &Point, b: &Point, p: &Point) -> bool {
    is_between(a, b, p) && side(a, b, p).is_eq()
}

/// The distance of p from the closed segment from a to b, rounded only at the end.
pub(in crate::checks) fn distance(a: &Point, b: &Point, p: &Point) -> f64 {
    let minus = |p: &Point, q: &Point| [0, 1].map(|i: usize| Rational::from(&p[i] - &q[i]));
    let dot = |u: &Point, v: &Point| Rational::from(&u[0] * &v[0]) + Rational::from(&u[1] * &v[1]);
    let [along, to] = [minus(b, a), minus(p, a)];
    let square = dot(&along, &along);
    let part = if square.is_zero() { square } else { dot(&to, &along) / square };
    let part = part.clamp(&0, &1);
    let off = [0, 1].map(|i: usize| Rational::from(&to[i] - &Rational::from(&along[i] * &part)).to_f64());
    off[0].hypot(off[1])
}

/// The intersection of two segments, without equal ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Common {
    /// Nothing.
    Nothing,
    /// Inner points of both cross.
    Crossing,
    /// A point that is not an end of both, without a crossing: one touches or overlaps the other.
    Touch,
}

/// The intersection of two segments.
pub(super) fn common(one: [&Point; 2], two: [&Point; 2]) -> Common {
    let both = [one, two];
    by_sides(both, |line, end| side(both[line][0], both[line][1], both[1 - line][end]))
}

/// The intersection of two segments, from the side of each end on the line of the other segment: `side` gets the number
/// of the line and that of the end.
///
/// An end is in the other segment if it is on the line and not beyond an end of that segment, so each side is needed
/// only once.
fn by_sides(both: [[&Point; 2]; 2], side: impl Fn(usize, usize) -> Ordering) -> Common {
    let of_second = [0, 1].map(|end| side(0, end));
    if of_second[0] == of_second[1] && of_second[0].is_ne() {
        return Common::Nothing;
    }
    let of_first = [0, 1].map(|end| side(1, end));
    if !of_first.contains(&Ordering::Equal) && !of_second.contains(&Ordering::Equal) {
        return if of_first[0] == of_first[1] { Common::Nothing } else { Common::Crossing };
    }
    let touches = |line: usize, end: usize, side: Ordering| {
        let ([a, b], p) = (both[line], both[1 - line][end]);
        side.is_eq() && p != a && p != b && is_between(a, b, p)
    };
    let is_touched = (0..2).any(|end| touches(0, end, of_second[end]) || touches(1, end, of_first[end]));
    if is_touched { Common::Touch } else { Common::Nothing }
}

/// Segments with their rounded ends, to find pairs that may intersect.
pub(super) struct Neighbours<'p> {
    exact: Vec<[&'p Point; 2]>,
    /// The rounded ends; the error of each coordinate is below 2^-52 of the largest one.
    segments: Vec<[[f64; 2]; 2]>,
    index: Boxes<2>,
    /// A bound on the error of boxes.
    reach: f64,
    /// The magnitude beyond which a turn of rounded points has the true sign.
    certain: f64,
}

impl<'p> Neighbours<'p> {
    /// Rounds the segments; `None` if there are none, or some exceed the range of doubles.
    pub(super) fn new(exact: Vec<[&'p Point; 2]>) -> Option<Neighbours<'p>> {
        let rounded = |ends: &[&Point; 2]| ends.map(|p| [0, 1].map(|i: usize| p[i].to_f64()));
        let segments: Vec<[[f64; 2]; 2]> = exact.iter().map(rounded).collect();
        let largest = segments.as_flattened().as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if segments.is_empty() || !largest.is_finite() {
            return None;
        }
        let index = Boxes::new(segments.iter().map(|&ends| extent(ends)).collect());
        // With M the largest and u = 2^-52 a difference is below 2M, and its error is 2uM from its ends and uM from its
        // own rounding; the error of a product is at most 2 · 2M · 3uM + 9u²M² + 4uM², and that of the turn twice that
        // and 8uM² from its own rounding: below 41uM². If M² u is too small nothing is certain, because products may
        // underflow.
        let square = largest * largest;
        let certain = if square > 1e-200 { square * 2.0_f64.powi(-46) } else { f64::INFINITY };
        Some(Neighbours { exact, segments, index, reach: largest * 2.0_f64.powi(-50), certain })
    }

    /// The segments that may have a point in common with this one: a superset of those that do, including itself.
    pub(super) fn of(&self, at: usize, near: &mut Vec<u32>) {
        self.index.near(&self.index.all()[at], self.reach, near);
        near.retain(|&other| !self.are_apart(at, other as usize));
    }

    /// True if one of the two is certainly on one side of the other's line.
    fn are_apart(&self, at: usize, other: usize) -> bool {
        let beside = |line: usize, of: usize| {
            let [first, second] = [0, 1].map(|end| self.certain_side(line, of, end));
            first.is_some() && first == second
        };
        beside(at, other) || beside(other, at)
    }

    /// The side of an end of a segment on the line of another segment, if rounding cannot have changed it.
    fn certain_side(&self, line: usize, of: usize, end: usize) -> Option<Ordering> {
        let ([a, b], p) = (self.segments[line], self.segments[of][end]);
        let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        (turn.abs() > self.certain).then(|| turn.total_cmp(&0.0))
    }

    /// The side of an end of a segment on the line of another segment: as [`side`], and an end of that line is on it.
    pub(super) fn side(&self, line: usize, of: usize, end: usize) -> Ordering {
        let ([a, b], p) = (self.exact[line], self.exact[of][end]);
        if std::ptr::eq(p, a) || std::ptr::eq(p, b) {
            return Ordering::Equal;
        }
        self.certain_side(line, of, end).unwrap_or_else(|| side(a, b, p))
    }

    /// The intersection of two of the segments.
    pub(super) fn common(&self, at: usize, other: usize) -> Common {
        let both = [at, other];
        by_sides(both.map(|at| self.exact[at]), |line, end| self.side(both[line], both[1 - line], end))
    }
}

/// The winding number of closed chains of edges around a point; `None` for a point on an edge.
pub(super) fn winding<'a>(edges: impl Iterator<Item = [&'a Point; 2]>, p: &Point) -> Option<i32> {
    let mut winding = 0;
    for [a, b] in edges {
        let is_below = [a[1] <= p[1], b[1] <= p[1]];
        if is_below[0] == is_below[1] {
            if a[1] == p[1] && is_on(a, b, p) {
                return None;
            }
            continue;
        }
        match (side(a, b, p), is_below[0]) {
            (Ordering::Equal, _) => return None,
            (Ordering::Greater, true) => winding += 1,
            (Ordering::Less, false) => winding -= 1,
            _ => {}
        }
    }
    Some(winding)
}

/// Twice the area of closed chains of edges.
pub(super) fn area<'a>(edges: impl Iterator<Item = [&'a Point; 2]>) -> Rational {
    let mut terms: Vec<Rational> = Vec::new();
    // Relative to one of the points: far from the origin the area would be the difference of large numbers.
    let mut origin: Option<&Point> = None;
    for [a, b] in edges {
        let origin = *origin.get_or_insert(a);
        terms.push(turn(origin, a, b));
    }
    sum(terms)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The intersection by its definition: parts of both segments, in rationals.
    fn plainly([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> Common {
        let of = |p: &Point, q: &Point, r: &Point| turn(p, q, r).cmp0();
        let cross = |p: Ordering, q: Ordering| p.is_ne() && p == q.reverse();
        if cross(of(a, b, c), of(a, b, d)) && cross(of(c, d, a), of(c, d, b)) {
            return Common::Crossing;
        }
        let holds = |p: &Point, q: &Point, r: &Point| of(p, q, r).is_eq() && is_between(p, q, r) && r != p && r != q;
        let is_touched = holds(a, b, c) || holds(a, b, d) || holds(c, d, a) || holds(c, d, b);
        if is_touched { Common::Touch } else { Common::Nothing }
    }

    /// Segments between points of a small grid and points on them, or beside them by a little, near the origin or far
    /// from it.
    #[test]
    fn pairs_of_rounded_segments_meet_as_in_rationals() {
        let mut state = 9_u64;
        let mut next = |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u32::try_from(state >> 33).expect("31 bits") % bound
        };
        let mut counts = [0; 3];
        for far in [0_u64, 1 << 40] {
            let mut nodes: Vec<Point> =
                (0..12).map(|_| [0, 1].map(|_| Rational::from((next(5), 3)) + Rational::from(far))).collect();
            for _ in 0..24 {
                let [a, b] = [0, 1].map(|_| nodes[next(12) as usize].clone());
                let part = Rational::from((next(7), 6));
                let off = Rational::from((next(2), 1_u64 << (next(60) + 1)));
                nodes.push([0, 1].map(|i| Rational::from(&b[i] - &a[i]) * &part + &a[i] + &off));
            }
            let count = u32::try_from(nodes.len()).expect("few");
            let segments: Vec<[usize; 2]> = (0..200).map(|_| [0, 1].map(|_| next(count) as usize)).collect();
            let neighbours = Neighbours::new(segments.iter().map(|ends| ends.map(|at| &nodes[at])).collect()).unwrap();
            let mut near = Vec::new();
            for at in 0..segments.len() {
                neighbours.of(at, &mut near);
                for other in (0..segments.len()).filter(|&other| other != at) {
                    let [one, two] = [at, other].map(|at| segments[at].map(|node| &nodes[node]));
                    let truth = plainly(one, two);
                    assert_eq!(neighbours.common(at, other), truth, "{one:?} {two:?}");
                    assert_eq!(common(one, two), truth, "{one:?} {two:?}");
                    assert!(truth == Common::Nothing || near.iter().any(|&near| near as usize == other));
                    counts[truth as usize] += 1;
                }
            }
        }
        assert!(counts.iter().all(|&count| count > 500), "{counts:?}");
    }
}
