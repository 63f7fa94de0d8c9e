//! The rungs of the ladder for a query without a scene.

use predicament_arithmetic::Sign;

use crate::common_unit::{self, Short};
use crate::few_bits::doubles_are_exact;
use crate::predicate::Predicate;
use crate::stage;

/// The lowest bit of determinants for which the slack of [`anywhere`](crate::anywhere) is less than that bit, as an
/// exponent.
///
/// A determinant of degree k is a multiple of 2^(k·l). With differences below 2^(l + b), b ≤ 126, the slack is less
/// than 2^-960 · (4·2^(l + b) + 1) for degree 3, 2^-960 · (6·4^(l + b) + 1) for degree 4, and for degree 5 less than
/// 2^-960 · (12·4^(l + b)·(4·2^(l + b) + 1) + 1). Over 2^(k·l), with l ≥ -900/k ≥ -450 and, as nothing overflows,
/// k·(l + b) ≤ 1023: the largest is at degree 5, 2^(-960 + 6 + 3·(l + b) - 5·l) = 2^(-954 - 2·l + 3·b) ≤ 2^(-954 +
/// 360 + 378), less than 1.
pub(crate) const SLACK_IS_LESS: i32 = -900;

/// The sign of a query without a scene that its own filter has left open, and its stage; `None` if a coordinate is not
/// finite.
///
/// The rungs before the last ones find no sign for numbers that are not finite, so only the last ones look for them.
#[inline(always)]
pub(crate) fn alone<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: &[[f64; D]; N],
) -> Option<(Sign, usize)> {
    if let Some(sign) = P::products(*points) {
        return Some((sign, stage::INTEGER));
    }
    // Two equal rows. (A point that is named twice is the most frequent tie of random queries.)
    for row in 1..N {
        if points[..row].contains(&points[row]) && points.as_flattened().iter().all(|x| x.is_finite()) {
            return Some((Sign::Zero, stage::DOUBLE));
        }
    }
    if P::estimate(*points).determinant == 0.0 && doubles_are_exact::<P, D, N>(points) {
        return Some((Sign::Zero, stage::DOUBLE));
    }
    if let Some(Short { rows, bits, low }) = common_unit::rows(points) {
        let (determinant, form) = (P::DETERMINANT, P::DETERMINANT.form);
        // If nothing overflows and the slack is less than a unit, the filter has bounded the determinant.
        let leaves_little = (form.degree * low >= SLACK_IS_LESS) & (form.degree * (low + bits) + form.growth <= 1023);
        let limbs = if leaves_little { determinant.limbs_left_open(bits) } else { determinant.limbs(bits) };
        return Some((P::integer(rows, limbs), stage::INTEGER));
    }
    // (Integers in units of differences are counted with the last stage.)
    alone_at_length::<P, D, N>(points).map(|sign| (sign, stage::DYADIC))
}

#[inline(never)]
fn alone_at_length<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[f64; D]; N]) -> Option<Sign> {
    if !points.as_flattened().iter().all(|x| x.is_finite()) {
        return None;
    }
    Some(P::short(*points).unwrap_or_else(|| P::dyadic(*points)))
}
