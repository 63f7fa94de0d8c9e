//! Moves of single coordinates.

use predicament_formats::bits::{power_of_two, rounded, step, top_exponent};

use super::super::climb::ulp;
use super::Draft;

/// Changes one coordinate, given with its row and axis.
fn one(draft: &mut Draft<'_>, change: impl FnOnce(&mut Draft<'_>, f64, usize, usize) -> Option<f64>) -> bool {
    let Some((at, mut row)) = draft.pick() else { return false };
    let axis = draft.below(row.len());
    let Some(new) = change(draft, row[axis], at, axis) else { return false };
    row[axis] = new;
    draft.put(at, &row)
}

/// Moves a coordinate by some ulps up or down, most often few.
pub(super) fn ulps(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, _, _| {
        let bits = if draft.random.one_in(2) { 2 } else { draft.random.integer(1, 40) };
        let most = 1_i64 << bits;
        let moved = step(x, draft.random.nonzero(most));
        moved.is_finite().then_some(moved)
    })
}

/// Moves a coordinate just beside a power of two, where half an ulp is relatively largest.
pub(super) fn beside_power(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, _, _| {
        let exponent = top_exponent(x).unwrap_or(0) + draft.random.integer(0, 1);
        let power = power_of_two(exponent.clamp(-1000, 1000)).copysign(x);
        let ulps = draft.random.integer(0, 3);
        Some(if draft.random.one_in(2) { step(power, ulps) } else { power * (1.0 + draft.small(52)) })
    })
}

/// Moves a coordinate by or to half an ulp of another one, where a difference rounds the other way.
pub(super) fn half_ulp(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, at, _| {
        let length = draft.row(at).len();
        let (_, other) = draft.another(length, &[])?;
        let half = 0.5 * ulp(other[draft.below(length)]);
        let half = if draft.random.one_in(2) { half } else { -half };
        Some(if draft.random.one_in(2) { half * (1.0 + draft.small(30)) } else { x + half })
    })
}

/// Reduces the number of significant bits.
pub(super) fn fewer_bits(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, _, _| {
        let bits = u32::try_from(draft.random.integer(1, 40)).unwrap_or(1);
        Some(rounded(x, bits))
    })
}

/// Copies the coordinate of another point: the points are then in line with an axis.
pub(super) fn copied(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, _, at, axis| {
        let length = draft.row(at).len();
        let (_, other) = draft.another(length, &[at])?;
        let axis = if draft.random.one_in(4) { draft.below(length) } else { axis };
        Some(other[axis])
    })
}

/// Moves a coordinate nearer to that of another point, or a little off.
pub(super) fn nearer(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, at, axis| {
        let length = draft.row(at).len();
        let (_, other) = draft.another(length, &[at])?;
        let pivot = other[axis];
        let factor = if draft.random.one_in(2) { draft.small(53) } else { 1.0 + draft.small(53) };
        Some(pivot + (x - pivot) * factor)
    })
}

/// Changes the sign of a coordinate.
pub(super) fn negated(draft: &mut Draft<'_>) -> bool {
    one(draft, |_, x, _, _| Some(-x))
}

/// Changes the exponent, by some binades or to any value.
pub(super) fn exponent(draft: &mut Draft<'_>) -> bool {
    one(draft, |draft, x, _, _| {
        let k = if draft.random.one_in(3) { draft.random.integer(-1000, 1000) } else { draft.random.nonzero(60) };
        let moved = predicament_formats::bits::scale(x, k);
        moved.is_finite().then_some(moved)
    })
}
