//! Points of 64-bit integers as doubles: moved along each axis so that all coordinates are doubles without rounding.
//!
//! A move changes no sign: determinants depend on differences alone, and perturbations belong to the points. It changes
//! no constructed vertex but by the same move.

/// The coordinates of points, moved.
///
/// # Errors
/// The index of a point that no such move makes a double along some axis.
pub(crate) fn doubles(coordinates: &[i64], dimension: usize) -> Result<Vec<f64>, usize> {
    let origins: Vec<i128> =
        (0..dimension).map(|axis| origin(coordinates.iter().skip(axis).step_by(dimension))).collect();
    let moved = coordinates
        .iter()
        .enumerate()
        .map(|(at, &x)| exactly(i128::from(x) - origins[at % dimension]).ok_or(at / dimension));
    moved.collect()
}

/// The origin of an axis: zero, or the middle of the coordinates if one of them is not a double.
fn origin<'x>(coordinates: impl Iterator<Item = &'x i64> + Clone) -> i128 {
    let all = coordinates.map(|&x| i128::from(x));
    if all.clone().all(|x| exactly(x).is_some()) {
        return 0;
    }
    let (least, most) = all.clone().fold((i128::MAX, i128::MIN), |(least, most), x| (least.min(x), most.max(x)));
    // In units of the largest power of two that divides all differences.
    let zeros = all.fold(0, |bits, x| bits | (x - least)).trailing_zeros().min(63);
    least + ((((most - least) >> zeros) / 2) << zeros)
}

/// The double with this value, if there is one.
#[allow(clippy::cast_precision_loss)] // 53 bits
fn exactly(x: i128) -> Option<f64> {
    let magnitude = x.unsigned_abs();
    let bits = u128::BITS - magnitude.leading_zeros();
    (bits.saturating_sub(magnitude.trailing_zeros()) <= f64::MANTISSA_DIGITS).then_some(x as f64)
}
