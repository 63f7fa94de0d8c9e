//! Conversion of a rational to the nearest double.

use rug::Rational;

use crate::rational;

/// The nearest double, ties to even; beyond the largest double, the largest double.
#[must_use]
pub fn nearest(x: &Rational) -> f64 {
    // `to_f64` rounds towards zero: the other candidate is the next double away from zero.
    let inner = x.to_f64();
    let outer = if *x < 0 { inner.next_down() } else { inner.next_up() };
    if !inner.is_finite() || !outer.is_finite() {
        return inner.clamp(f64::MIN, f64::MAX);
    }
    let [to_inner, to_outer] = [inner, outer].map(|candidate| (rational(candidate) - x).abs());
    let is_even = inner.to_bits() & 1 == 0;
    if to_inner < to_outer || (to_inner == to_outer && is_even) { inner } else { outer }
}
