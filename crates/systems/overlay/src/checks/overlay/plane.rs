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
pub(super) fn common([a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> Common {
    let [c_side, d_side] = [side(a, b, c), side(a, b, d)];
    if c_side == d_side && c_side.is_ne() {
        return Common::Nothing;
    }
    let [a_side, b_side] = [side(c, d, a), side(c, d, b)];
    if a_side.is_ne() && b_side.is_ne() && c_side.is_ne() && d_side.is_ne() {
        return if a_side == b_side { Common::Nothing } else { Common::Crossing };
    }
    let touches = |[a, b]: [&Point; 2], p: &Point| p != a && p != b && is_on(a, b, p);
    let is_touched = touches([a, b], c) || touches([a, b], d) || touches([c, d], a) || touches([c, d], b);
    if is_touched { Common::Touch } else { Common::Nothing }
}

/// Rounded segments, to find pairs that may intersect.
pub(super) struct Neighbours {
    /// The segments as pairs of ends; the error of each coordinate is below 2^-52 of the largest one.
    segments: Vec<[[f64; 2]; 2]>,
    index: Boxes<2>,
    /// A bound on the error of boxes.
    reach: f64,
    /// The magnitude beyond which a turn of rounded points has the true sign.
    certain: f64,
}

impl Neighbours {
    /// Rounds the segments; `None` if there are none, or some exceed the range of doubles.
    pub(super) fn new<'a>(segments: impl Iterator<Item = [&'a Point; 2]>) -> Option<Neighbours> {
        let rounded = |ends: [&Point; 2]| ends.map(|p| [0, 1].map(|i: usize| p[i].to_f64()));
        let segments: Vec<[[f64; 2]; 2]> = segments.map(rounded).collect();
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
        Some(Neighbours { segments, index, reach: largest * 2.0_f64.powi(-50), certain })
    }

    /// The segments that may have a point in common with this one: a superset of those that do, including itself.
    pub(super) fn of(&self, at: usize, near: &mut Vec<u32>) {
        self.index.near(&self.index.all()[at], self.reach, near);
        near.retain(|&other| !self.are_apart(at, other as usize));
    }

    /// True if one of the two is certainly on one side of the other's line.
    fn are_apart(&self, at: usize, other: usize) -> bool {
        let beside = |[a, b]: [[f64; 2]; 2], ends: [[f64; 2]; 2]| {
            let turns = ends.map(|p| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
            turns.iter().all(|&turn| turn > self.certain) || turns.iter().all(|&turn| turn < -self.certain)
        };
        let [one, two] = [at, other].map(|at| self.segments[at]);
        beside(one, two) || beside(two, one)
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
