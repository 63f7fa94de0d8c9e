//! Discs and thick edges, in doubles. Radii are rounded up, so that coverage holds after rounding.

use predicament_grid::Bounds;

pub(super) type Point = [f64; 2];

/// A thick vertex: a disc.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Disc {
    /// The centre.
    pub centre: [f64; 2],
    /// The radius: an upper bound on the distance of the represented vertex from the centre.
    pub radius: f64,
}

/// The side of a thick edge that a vertex is on, in the edge's direction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// To the left of the edge.
    Left,
    /// The disc and the edge overlap.
    On,
    /// To the right of the edge.
    Right,
}

/// The side of a vertex relative to a thick edge with this radius, from the first point of `line` to the second.
#[must_use]
pub fn side(line: [[f64; 2]; 2], radius: f64, p: Disc) -> Side {
    if distance(line, p.centre).0 <= radius + p.radius {
        Side::On
    } else if turn(line, p.centre) > 0.0 {
        Side::Left
    } else {
        Side::Right
    }
}

/// The cross product (b − a) × (p − a), rounded.
pub(super) fn turn([a, b]: [Point; 2], p: Point) -> f64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// The distance of a point from a segment, and the position of the nearest point on it, from 0 to 1; rounded.
pub(super) fn distance([a, b]: [Point; 2], p: Point) -> (f64, f64) {
    let [ab, ap] = [b, p].map(|to| [to[0] - a[0], to[1] - a[1]]);
    let square = ab[0] * ab[0] + ab[1] * ab[1];
    let along = if square > 0.0 { ((ab[0] * ap[0] + ab[1] * ap[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    ((ap[0] - along * ab[0]).hypot(ap[1] - along * ab[1]), along)
}

/// An upper bound on the distance of a point from a segment, valid for any rounding.
pub(super) fn distance_at_most(line: [Point; 2], p: Point) -> f64 {
    // The computed nearest point counts as a point of the segment, so only the way from it to p is rounded. Along each
    // axis, the error is less than four times 2^-53 of the operands of the subtraction.
    let reach = |q: Point| (q[0] - line[0][0]).abs() + (q[1] - line[0][1]).abs();
    up(distance(line, p).0 + 4.0 * f64::EPSILON * (reach(line[1]) + reach(p)))
}

/// A slightly larger radius, which covers the error of a few roundings.
pub(super) fn up(radius: f64) -> f64 {
    radius * (1.0 + 4.0 * f64::EPSILON)
}

impl Disc {
    /// The smallest disc that covers two discs, rounded up.
    pub(super) fn cover(self, other: Disc) -> Disc {
        let apart = self.apart(other);
        let [small, large] = if self.radius < other.radius { [self, other] } else { [other, self] };
        if apart + small.radius <= large.radius {
            return large;
        }
        let radius = (apart + small.radius + large.radius) / 2.0;
        // From the larger disc's centre towards the other one.
        let part = (radius - large.radius) / apart;
        let centre = [0, 1].map(|axis: usize| large.centre[axis] + part * (small.centre[axis] - large.centre[axis]));
        // The centre is rounded, too.
        let rounding = 2.0 * f64::EPSILON * (centre[0].abs() + centre[1].abs());
        Disc { centre, radius: up(radius) + rounding }
    }

    /// The distance between the centres, rounded.
    pub(super) fn apart(self, other: Disc) -> f64 {
        (other.centre[0] - self.centre[0]).hypot(other.centre[1] - self.centre[1])
    }

    pub(super) fn overlaps(self, other: Disc) -> bool {
        self.apart(other) <= self.radius + other.radius
    }

    pub(super) fn bounds(self) -> Bounds<2> {
        thick(Bounds::of([self.centre]), self.radius)
    }
}

/// A box enlarged by this radius on all sides.
pub(super) fn thick(bounds: Bounds<2>, radius: f64) -> Bounds<2> {
    Bounds { low: bounds.low.map(|x| (x - radius).next_down()), high: bounds.high.map(|x| (x + radius).next_up()) }
}

/// The approximate crossing of two segments, and its position along each, from 0 to 1. Each segment must have the
/// other's ends on different sides.
pub(super) fn crossing(e: [Point; 2], f: [Point; 2]) -> (Point, [f64; 2]) {
    let along = |line: [Point; 2], other: [Point; 2]| {
        let [n, m] = line.map(|p| turn(other, p));
        n / (n - m)
    };
    let [on_e, on_f] = [along(e, f).clamp(0.0, 1.0), along(f, e).clamp(0.0, 1.0)];
    let [a, b] = e;
    ([0, 1].map(|axis: usize| a[axis] + on_e * (b[axis] - a[axis])), [on_e, on_f])
}
