//! Two triangles whose planes meet in a line.
//!
//! Each triangle meets the line in an interval: a point or a segment, from a border point to a border point. The two
//! intervals are compared by the orientation of the four vertices of two edges (Guigue and Devillers, *Fast and robust
//! triangle-triangle overlap test using orientation predicates*, 2003), here with closed triangles: an end is a corner
//! or a point inside of an edge, and equal ends are found as zeros.
//!
//! The line has the direction d of the product of both normals. Seen from its front, the first triangle has the part
//! behind the second one on the left of d; the second triangle has the part in front of the first one there.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::found::{Found, Simplex};
use super::triangle::Triangle;

/// An end of an interval.
#[derive(Clone, Copy)]
struct End {
    /// The corner, or the edge that crosses the other plane.
    at: Simplex,
    /// Two corners: the first at the end or across the other plane from the second.
    corners: [Vertex; 2],
    /// The side of the other plane on which the second corner is.
    side: Sign,
}

/// The part of a triangle on the line, in the direction of the line.
struct Interval {
    low: End,
    high: End,
    /// The simplex between its ends.
    inside: Simplex,
}

/// The interval of a triangle whose corners have these sides of the other plane, where the corners on the left of the
/// line have the side `left`; `None` if the triangle is beside the line.
fn interval(triangle: &Triangle, sides: [Sign; 3], left: Sign) -> Option<Interval> {
    let [mut low, mut high] = [None, None];
    let mut inside = Simplex::Triangle(triangle.place);
    let off = (0..3).find(|&i| !sides[i].is_zero())?;
    let at_corner = |i: usize| End {
        at: Simplex::Vertex(triangle.corners[i]),
        corners: [triangle.corners[i], triangle.corners[off]],
        side: sides[off],
    };
    for i in 0..3 {
        let (next, before) = ((i + 1) % 3, (i + 2) % 3);
        if !sides[i].is_zero() {
            if sides[next] == -sides[i] {
                // The border passes from the right of the line to its left at the high end.
                let corners = [triangle.corners[i], triangle.corners[next]];
                let end = End { at: Simplex::Edge(triangle.edges[i]), corners, side: sides[next] };
                *(if sides[next] == left { &mut high } else { &mut low }) = Some(end);
            }
        } else if sides[next].is_zero() {
            // The edge is on the line; its triangle is on its left.
            let ahead = sides[before] == left;
            let [from, to] = if ahead { [i, next] } else { [next, i] };
            low = Some(at_corner(from));
            high = Some(at_corner(to));
            inside = Simplex::Edge(triangle.edges[i]);
            break;
        } else if !sides[before].is_zero() {
            if sides[before] == sides[next] {
                low = Some(at_corner(i));
                high = low;
                break;
            }
            *(if sides[next] == left { &mut high } else { &mut low }) = Some(at_corner(i));
        }
    }
    Some(Interval { low: low?, high: high?, inside })
}

/// The sign of the position of the second triangle's end less that of the first one's, along the line.
fn ahead(session: &dyn Predicates, first: &End, second: &End) -> Sign {
    let ([a, b], [c, d]) = (first.corners, second.corners);
    // No other two are one vertex: the second corners are off the other triangle's plane.
    if a == c {
        return Sign::Zero;
    }
    -session.orient3d(c, d, a, b) * first.side * second.side
}

/// Adds the points of two triangles; `sides` are the sides of the second triangle's plane for the first one's corners,
/// and the sides of the first one's plane for the second one's.
pub(super) fn add(session: &dyn Predicates, triangles: [&Triangle; 2], sides: [[Sign; 3]; 2], found: &mut Found) {
    let first = interval(triangles[0], sides[0], Sign::Positive);
    let second = interval(triangles[1], sides[1], Sign::Negative);
    let (Some(first), Some(second)) = (first, second) else { return };
    let ahead = |a: &End, b: &End| ahead(session, a, b);
    let to_high = ahead(&first.low, &second.high);
    let to_low = ahead(&first.high, &second.low);
    if to_high == Sign::Negative || to_low == Sign::Positive {
        return;
    }
    // The simplex of an interval at the end of the other: an end of the interval, or its inside.
    let within = |is_end: bool, end: &End, inside: Simplex| if is_end { end.at } else { inside };
    let low = match ahead(&first.low, &second.low) {
        Sign::Zero => [first.low.at, second.low.at],
        Sign::Positive => [within(to_low.is_zero(), &first.high, first.inside), second.low.at],
        Sign::Negative => [first.low.at, within(to_high.is_zero(), &second.high, second.inside)],
    };
    let high = match ahead(&first.high, &second.high) {
        Sign::Zero => [first.high.at, second.high.at],
        Sign::Positive => [first.high.at, within(to_low.is_zero(), &second.low, second.inside)],
        Sign::Negative => [within(to_high.is_zero(), &first.low, first.inside), second.high.at],
    };
    found.add([first.inside, second.inside], [low, high]);
}
