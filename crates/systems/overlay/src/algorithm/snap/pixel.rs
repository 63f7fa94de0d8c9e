//! Pixels: the pixel of a point or a crossing, and the pixels that a segment meets. Coordinates are in units of pixels.

use std::cmp::Ordering;

use super::plane::{crossing_estimate, crossing_pixel, double, turn};

/// A pixel as its centre, in units of pixels: the square from half a unit below to half a unit above along each axis,
/// without its upper ends.
pub type Pixel = [i64; 2];

/// The bound of coordinates in pixels, 2^50: larger coordinates are refused.
pub const SIDES: f64 = 1_125_899_906_842_624.0; // 2^50

/// The nearest integer: the i with i − 1/2 ≤ x < i + 1/2.
#[allow(clippy::cast_possible_truncation)] // below 2^50, and an integer
pub fn nearest(x: f64) -> i64 {
    let low = x.floor();
    // Below 2^50 both differences are exact.
    (if x - low >= 0.5 { low + 1.0 } else { low }) as i64
}

/// The pixel of a point.
pub fn pixel_of_point(point: [f64; 2]) -> Pixel {
    point.map(nearest)
}

/// The pixel of the crossing of two segments; `None` if they are parallel, or do not cross.
pub fn pixel_of_crossing(first: [[f64; 2]; 2], second: [[f64; 2]; 2]) -> Option<Pixel> {
    let [a, b] = first;
    let [c, d] = second;
    let apart = |p, q, r, s| {
        let side = turn(p, q, r);
        side != Ordering::Equal && side == turn(p, q, s)
    };
    if apart(a, b, c, d) || apart(c, d, a, b) {
        return None;
    }
    let (estimate, wrong) = crossing_estimate(first, second);
    let mut pixel = [0; 2];
    for (axis, index) in pixel.iter_mut().enumerate() {
        let within = [estimate[axis] - wrong[axis], estimate[axis] + wrong[axis]];
        if within.iter().any(|x| x.is_nan() || x.abs() >= SIDES) || nearest(within[0]) != nearest(within[1]) {
            return crossing_pixel(first, second);
        }
        *index = nearest(within[0]);
    }
    Some(pixel)
}

/// Returns true if a segment meets a pixel.
///
/// A segment and a closed square are apart if and only if they are so along an axis or across the segment (separating
/// axes of convex sets). Strict comparisons leave out the upper sides. If a line only touches the square, only the
/// lower left corner counts, or a side that ends there.
pub fn meets([a, b]: [[f64; 2]; 2], pixel: Pixel) -> bool {
    let [low, high] = [-0.5, 0.5].map(|half| pixel.map(|i| double(i) + half));
    let overlaps = |axis: usize| a[axis].max(b[axis]) >= low[axis] && a[axis].min(b[axis]) < high[axis];
    if !overlaps(0) || !overlaps(1) {
        return false;
    }
    if a == b {
        return true;
    }
    let corner = turn(a, b, low);
    let others = [[high[0], low[1]], [low[0], high[1]], high].map(|corner| turn(a, b, corner));
    corner == Ordering::Equal || others.contains(&corner.reverse())
}
