//! Rational points of the plane.

use std::cmp::Ordering;

use predicament_grid::{Bounds, BoxIndex};
use rug::Rational;

use crate::sum::sum;

/// A point.
pub type Point = [Rational; 2];

/// (b − a) × (p − a).
pub(super) fn turn(a: &Point, b: &Point, p: &Point) -> Rational {
    let minus = |p: &Point, i: usize| Rational::from(&p[i] - &a[i]);
    minus(b, 0) * minus(p, 1) - minus(b, 1) * minus(p, 0)
}

/// The side of p on the line from a to b.
pub(super) fn side(a: &Point, b: &Point, p: &Point) -> Ordering {
    turn(a, b, p).cmp0()
}

/// Whether p, which is on the line of a and b, is not beyond either.
pub(super) fn is_between(a: &Point, b: &Point, p: &Point) -> bool {
    (0..2).all(|i| (a[i] <= p[i] && p[i] <= b[i]) || (b[i] <= p[i] && p[i] <= a[i]))
}

/// Whether p is on the closed segment from a to b.
pub(super) fn is_on(a: &Point, b: &Point, p: &Point) -> bool {
    is_between(a, b, p) && side(a, b, p).is_eq()
}

/// What two segments have in common besides equal ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Common {
    /// Nothing.
    Nothing,
    /// Inner points of both cross.
    Crossing,
    /// A point that is no end of both, without a crossing: one touches or overlaps the other.
    Touch,
}

/// What two segments have in common.
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

/// Boxes of segments between points, and how far these may be off.
pub(super) fn index<'a>(segments: impl Iterator<Item = [&'a Point; 2]>) -> Option<(BoxIndex<2>, f64)> {
    let mut largest = 0.0_f64;
    let boxes: Vec<Bounds<2>> = segments
        .map(|ends| {
            let ends = ends.map(|p| [0, 1].map(|i: usize| p[i].to_f64()));
            ends.as_flattened().iter().for_each(|x| largest = largest.max(x.abs()));
            Bounds::of(ends)
        })
        .collect();
    // Coordinates are rounded by less than a part in 2^52.
    (!boxes.is_empty() && largest.is_finite()).then(|| (BoxIndex::new(boxes), largest * 2.0_f64.powi(-50)))
}

/// The winding number of closed chains of edges around a point; none for a point of an edge.
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
    // From one of the points: what is far from the origin would be the difference of large numbers.
    let mut origin: Option<&Point> = None;
    for [a, b] in edges {
        let origin = *origin.get_or_insert(a);
        terms.push(turn(origin, a, b));
    }
    sum(terms)
}
