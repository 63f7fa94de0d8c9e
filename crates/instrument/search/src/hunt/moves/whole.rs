//! Moves of the whole scene: other sizes, positions and directions of the same shape.
//!
//! Most moves are exact while coordinates are short: the new scene is as degenerate as the old one, where doubles are
//! coarser or finer.

use predicament_formats::bits::{power_of_two, scale, top_exponent};

use super::Draft;
use crate::rows::width;

/// The value floor(log2) of the largest coordinate; `None` if all are zero.
fn top(draft: &Draft<'_>) -> Option<i64> {
    draft.spelled.rows().into_iter().flatten().filter_map(|&x| top_exponent(x)).max()
}

/// Multiplies all coordinates by a power of two, anywhere from the smallest doubles to the largest.
pub(super) fn scaled(draft: &mut Draft<'_>) -> bool {
    let Some(top) = top(draft) else { return false };
    let k = if draft.random.one_in(3) { draft.random.nonzero(60) } else { draft.random.integer(-1060, 1022) - top };
    // Two steps, since one scaling does not cover twice the range of exponents.
    draft.each(|_, x| scale(scale(x, k / 2), k - k / 2))
}

/// An exponent to scale a part of the scene by: near zero, or far from it.
fn part(draft: &mut Draft<'_>) -> i64 {
    if draft.random.one_in(3) { draft.random.integer(-900, 900) } else { draft.random.nonzero(60) }
}

/// Multiplies one axis by a power of two: lines and planes stay lines and planes.
pub(super) fn axis_scaled(draft: &mut Draft<'_>) -> bool {
    let (k, axis) = (part(draft), draft.below(3));
    draft.each(|along, x| if along == axis { scale(x, k) } else { x })
}

/// Multiplies one point by a power of two.
pub(super) fn point_scaled(draft: &mut Draft<'_>) -> bool {
    let Some((at, row)) = draft.pick() else { return false };
    let k = part(draft);
    let moved: Vec<f64> = row.iter().map(|&x| scale(x, k)).collect();
    draft.put(at, &moved)
}

/// Moves all points far away along one axis or all axes, where doubles are coarser.
pub(super) fn far_away(draft: &mut Draft<'_>) -> bool {
    let Some(top) = top(draft) else { return false };
    let exponent = (top + draft.random.integer(0, 50)).clamp(-1022, 1020);
    #[allow(clippy::cast_precision_loss)] // small
    let factor = draft.random.nonzero(3) as f64;
    let (shift, axis) = (factor * power_of_two(exponent), draft.below(4));
    draft.each(|along, x| if along == axis || axis == 3 { x + shift } else { x })
}

/// Moves all points so that one point is the origin.
pub(super) fn to_origin(draft: &mut Draft<'_>) -> bool {
    let Some((_, pivot)) = draft.pick() else { return false };
    draft.each(|axis, x| x - pivot.get(axis).copied().unwrap_or(0.0))
}

/// Rotates and scales the scene in integers: by a Pythagorean triple about an axis, or by a quaternion.
pub(super) fn turned(draft: &mut Draft<'_>) -> bool {
    const TRIPLES: [[f64; 2]; 6] = [[3.0, 4.0], [5.0, 12.0], [8.0, 15.0], [7.0, 24.0], [20.0, 21.0], [4.0, 3.0]];
    let length = draft.spelled.rows().first().map_or(0, |row| row.len());
    let [a, b] = TRIPLES[draft.below(TRIPLES.len())];
    let matrix: [[f64; 3]; 3] = match length {
        2 => [[a, -b, 0.0], [b, a, 0.0], [0.0; 3]],
        3 if draft.random.one_in(2) => {
            let hypotenuse = (a * a + b * b).sqrt();
            let mut matrix = [[0.0; 3]; 3];
            let about = draft.below(3);
            let [i, j] = [(about + 1) % 3, (about + 2) % 3];
            (matrix[i][i], matrix[i][j], matrix[j][i], matrix[j][j]) = (a, -b, b, a);
            matrix[about][about] = hypotenuse;
            matrix
        }
        3 => {
            let mut part = || -> f64 {
                #[allow(clippy::cast_precision_loss)] // small
                let part = draft.random.integer(-3, 3) as f64;
                part
            };
            let [w, x, y, z] = [part(), part(), part(), part()];
            [
                [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
            ]
        }
        _ => return false,
    };
    if matrix.as_flattened().iter().all(|entry| *entry == 0.0) {
        return false;
    }
    mapped(draft, &matrix)
}

/// Adds a multiple of one axis to another: degenerate lines and planes stay degenerate.
pub(super) fn sheared(draft: &mut Draft<'_>) -> bool {
    let length = draft.spelled.rows().first().map_or(0, |row| row.len());
    // (Rows of four are cubes, which have no shear.)
    if !(2..=3).contains(&length) {
        return false;
    }
    let axis = draft.below(length);
    let other = (axis + 1 + draft.below(length - 1)) % length;
    let mut matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    #[allow(clippy::cast_precision_loss)] // small
    let factor = draft.random.nonzero(5) as f64;
    matrix[axis][other] = factor * power_of_two(draft.random.integer(-12, 3));
    mapped(draft, &matrix)
}

/// Permutes the axes, and reverses some of them.
pub(super) fn axes_exchanged(draft: &mut Draft<'_>) -> bool {
    let length = draft.spelled.rows().first().map_or(0, |row| row.len());
    if !(2..=3).contains(&length) {
        return false;
    }
    let mut matrix = [[0.0; 3]; 3];
    let first = draft.below(length);
    let step = 1 + draft.below(length.max(2) - 1);
    for axis in 0..length {
        matrix[axis][(first + axis * step) % length] = if draft.random.one_in(3) { -1.0 } else { 1.0 };
    }
    mapped(draft, &matrix)
}

fn mapped(draft: &mut Draft<'_>, matrix: &[[f64; 3]; 3]) -> bool {
    let mut changed = false;
    let widths: Vec<usize> = draft.spelled.rows().iter().map(|row| width(&draft.spelled, row.len())).collect();
    for (row, width) in draft.spelled.rows_mut().zip(widths) {
        for point in row.chunks_mut(width.max(1)) {
            let old = point.to_vec();
            for (new, entries) in point.iter_mut().zip(matrix) {
                let terms = entries.iter().zip(&old).filter(|(entry, _)| **entry != 0.0);
                *new = terms.map(|(entry, x)| entry * x).sum();
            }
            changed |= *point != old;
        }
    }
    changed
}

/// Rounds all coordinates to a grid, most often a coarse one: then many are equal, and many triples are in line.
pub(super) fn onto_grid(draft: &mut Draft<'_>) -> bool {
    let Some(top) = top(draft) else { return false };
    let unit = top - if draft.random.one_in(3) { draft.random.integer(4, 20) } else { draft.random.integer(0, 3) };
    draft.each(|_, x| scale(scale(x, -unit).round(), unit))
}
