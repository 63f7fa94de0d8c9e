//! The pixel maps of Kettner, Mehlhorn, Pion, Schirra and Yap: every pixel is a neighbour of p, coloured by its turn
//! with q and r.

use predicament_predicates::Vertex;

use super::Cloud;
use crate::bits::integer;

/// The step between pixels if a scene does not name one.
pub const STEP: i64 = -53;
/// The number of pixels in a row if a scene does not name one.
pub const SIDE: u64 = 256;

/// The reason why there is no pixel map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PixelError {
    /// The step is not a power of two.
    Step,
    /// A coordinate plus a number of steps is not a double.
    Inexact {
        /// The coordinate.
        x: f64,
        /// The number of steps.
        steps: i64,
    },
}

/// A square of points against two fixed ones.
#[derive(Clone, PartialEq, Debug)]
pub struct PixelMap {
    /// The coordinates of columns and of rows: those of p plus k steps, exactly.
    grid: [Vec<f64>; 2],
    q: [f64; 2],
    r: [f64; 2],
}

impl PixelMap {
    /// The square of `side` × `side` points from `corner` on, `step` apart.
    ///
    /// # Errors
    /// The reason why there is no such square.
    pub fn new(corner: [f64; 2], [q, r]: [[f64; 2]; 2], side: i64, step: f64) -> Result<PixelMap, PixelError> {
        if !is_power_of_two(step) {
            return Err(PixelError::Step);
        }
        let moved = |x: f64, k: i64| exact_sum(x, integer(k) * step).ok_or(PixelError::Inexact { x, steps: k });
        let [columns, rows] = corner.map(|c| (0..side).map(|k| moved(c, k)).collect::<Result<Vec<_>, _>>());
        Ok(PixelMap { grid: [columns?, rows?], q, r })
    }

    /// The number of pixels, with one query each.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.grid[0].len() * self.grid[1].len()
    }

    /// The pixels, row by row, then q and r; one query (pixel, q, r) for each.
    #[must_use]
    pub fn points(&self) -> Cloud {
        let n = self.pixels();
        let [columns, rows] = &self.grid;
        let mut coordinates: Vec<f64> = Vec::with_capacity(2 * (n + 2));
        coordinates.extend(rows.iter().flat_map(|&y| columns.iter().flat_map(move |&x| [x, y])));
        coordinates.extend([self.q, self.r].as_flattened());
        let args = (0..n).flat_map(|pixel| [pixel, n, n + 1].map(Vertex::input)).collect();
        Cloud { coordinates, args: Some(args), constructions: Vec::new() }
    }
}

/// True if x is a power of two, so that every multiple with up to 53 bits is a double, too.
fn is_power_of_two(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0 && x > 0.0
}

/// The value x + y if that is a double: if the error term of Knuth's sum is zero.
fn exact_sum(x: f64, y: f64) -> Option<f64> {
    let sum = x + y;
    let y_seen = sum - x;
    let error = (x - (sum - y_seen)) + (y - y_seen);
    (sum.is_finite() && error == 0.0).then_some(sum)
}
