//! Pixels: the pixel of a point or a crossing, and the pixels that a segment meets. Coordinates are in units of pixels.

use std::cmp::Ordering;

use super::plane::{crossing_against, crossing_estimate, double, turn};

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
        if within.iter().all(|x| x.abs() < SIDES) && nearest(within[0]) == nearest(within[1]) {
            *index = nearest(within[0]);
            continue;
        }
        // The crossing is on both segments, so it is within their ranges.
        let reach = |s: [[f64; 2]; 2]| [s[0][axis].min(s[1][axis]), s[0][axis].max(s[1][axis])];
        let [r, s] = [reach(first), reach(second)];
        let [mut low, mut high] = [nearest(r[0].max(s[0])), nearest(r[1].min(s[1]))];
        let against = |i: i64| crossing_against(first, second, axis, double(i) - 0.5);
        // From the estimate outwards in growing steps, then by bisection: low ≤ index ≤ high.
        let guess =
            if estimate[axis].is_finite() && estimate[axis].abs() < SIDES { nearest(estimate[axis]) } else { low };
        let guess = guess.clamp(low, high.max(low));
        let mut step = 1;
        if against(guess)? == Ordering::Less {
            high = guess - 1;
            while high > low && high - step > low {
                if against(high - step)? != Ordering::Less {
                    low = high - step;
                    break;
                }
                high -= step + 1;
                step *= 2;
            }
        } else {
            low = guess;
            while low + step <= high {
                if against(low + step)? == Ordering::Less {
                    high = low + step - 1;
                    break;
                }
                low += step;
                step *= 2;
            }
        }
        while low < high {
            let middle = low + (high - low + 1) / 2;
            if against(middle)? == Ordering::Less { high = middle - 1 } else { low = middle }
        }
        *index = low;
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
