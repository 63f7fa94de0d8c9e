//! Edges between points with integer coordinates, below 2^60: exact in 128 bits.

use super::Pixel;

fn turn(a: Pixel, b: Pixel, c: Pixel) -> i128 {
    let [ab, ac] = [b, c].map(|p| [0, 1].map(|axis| i128::from(p[axis]) - i128::from(a[axis])));
    ab[0] * ac[1] - ab[1] * ac[0]
}

/// Whether two edges have a point in common that is not an end of both; the same edge twice, and edges that
/// share an end and nothing else, do not cross.
pub fn cross([a, b]: [Pixel; 2], [c, d]: [Pixel; 2]) -> bool {
    if a == b || c == d || [a, b] == [c, d] || [a, b] == [d, c] {
        return false;
    }
    let is_inside = |p: Pixel, [q, r]: [Pixel; 2]| {
        let within = |axis: usize| q[axis].min(r[axis]) <= p[axis] && p[axis] <= q[axis].max(r[axis]);
        p != q && p != r && turn(q, r, p) == 0 && within(0) && within(1)
    };
    if is_inside(a, [c, d]) || is_inside(b, [c, d]) || is_inside(c, [a, b]) || is_inside(d, [a, b]) {
        return true;
    }
    let opposite = |s: i128, t: i128| (s < 0 && t > 0) || (s > 0 && t < 0);
    opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b))
}

/// Whether a point is at least so far from an edge; the square of the distance is a fraction. Coordinates are below 2^31.
pub fn distance2_at_least([a, b]: [Pixel; 2], p: Pixel, [numerator, denominator]: [i128; 2]) -> bool {
    let difference = |p: Pixel, q: Pixel| [0, 1].map(|axis| i128::from(p[axis]) - i128::from(q[axis]));
    let dot = |p: [i128; 2], q: [i128; 2]| p[0] * q[0] + p[1] * q[1];
    let [ab, ap, bp] = [difference(b, a), difference(p, a), difference(p, b)];
    let square = dot(ab, ab);
    let (distance, over) = match dot(ab, ap) {
        before if before <= 0 => (dot(ap, ap), 1),
        along if along >= square => (dot(bp, bp), 1),
        _ => {
            let height = ab[0] * ap[1] - ab[1] * ap[0];
            (height.unsigned_abs().checked_pow(2).and_then(|h| i128::try_from(h).ok()).unwrap_or(i128::MAX), square)
        }
    };
    distance.saturating_mul(denominator) >= over.saturating_mul(numerator)
}
