//! Doubles by their bits: neighbours, exponents and exact scaling.

use predicament_arithmetic::Parts;

/// The exponent of the lowest bit of the smallest subnormal.
pub const LOWEST: i64 = -1074;
/// The exponent of the highest bit of the largest double.
pub const HIGHEST: i64 = 1023;

/// The exponent of the highest bit; `None` for zero.
pub fn top_exponent(x: f64) -> Option<i64> {
    finite(x).highest().map(|highest| i64::from(highest) - 1)
}

/// The exponent of the lowest bit that is set; `None` for zero.
pub fn lowest_bit(x: f64) -> Option<i64> {
    finite(x).lowest().map(i64::from)
}

fn finite(x: f64) -> Parts {
    Parts::of(x).expect("coordinates are finite")
}

/// The double `k` steps above `x` (below for negative `k`) in the order of all doubles; ±0 count as one double.
pub fn step(x: f64, k: i64) -> f64 {
    let magnitude = i64::try_from(x.abs().to_bits()).expect("the sign bit is off");
    let place = if x.is_sign_negative() { -magnitude } else { magnitude } + k;
    let moved = f64::from_bits(place.unsigned_abs());
    if place < 0 { -moved } else { moved }
}

/// The nearest double with at most `bits` significant bits (1 to 53), ties away from zero. Subnormals have fewer bits.
pub fn rounded(x: f64, bits: u32) -> f64 {
    let dropped = 53 - bits;
    let half = (1_u64 << dropped) >> 1;
    f64::from_bits((x.to_bits() + half) >> dropped << dropped)
}

/// The double 2^k, for an exponent of a normal double.
///
/// # Panics
/// If 2^k is not a normal double.
pub fn power_of_two(k: i64) -> f64 {
    assert!((-1022..=HIGHEST).contains(&k), "2^{k} is not a normal double");
    predicament_arithmetic::power_of_two(i32::try_from(k).expect("eleven bits"))
}

/// The double x·2^k for |k| ≤ 2044, rounded once if it becomes subnormal.
pub fn scale(x: f64, k: i64) -> f64 {
    if k < -1022 {
        // The second step loses any bits that the first step could round.
        x * power_of_two(k + 1022) * power_of_two(-1022)
    } else if k > HIGHEST {
        x * power_of_two(HIGHEST) * power_of_two(k - HIGHEST)
    } else {
        x * power_of_two(k)
    }
}

/// The double equal to an integer of at most 2^53 in magnitude.
///
/// # Panics
/// If the magnitude is larger.
pub fn integer(n: i64) -> f64 {
    assert!(n.unsigned_abs() <= 1 << 53, "{n} has more bits than a double");
    #[allow(clippy::cast_precision_loss)] // at most 53 bits
    let x = n as f64;
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_go_through_zero_and_agree_with_the_neighbours() {
        for x in [1.0, -1.0, 0.5, 5e-324, -5e-324, 0.0, 1e300, f64::MIN_POSITIVE] {
            assert_eq!(step(x, 1), x.next_up());
            assert_eq!(step(x, -1), x.next_down());
            assert_eq!(step(step(x, 7), -7), x);
        }
        assert_eq!(step(-5e-324, 2), 5e-324);
    }

    #[test]
    fn exponents_of_the_highest_and_the_lowest_bit() {
        for (x, top) in [(1.0, 0), (-3.0, 1), (0.75, -1), (5e-324, -1074), (f64::MAX, 1023), (1e-320, -1064)] {
            assert_eq!(top_exponent(x), Some(top), "{x:e}");
        }
        for (x, low) in [(1.0, 0), (-12.0, 2), (0.75, -2), (5e-324, -1074), (f64::MAX, 971), (1e-320, -1071)] {
            assert_eq!(lowest_bit(x), Some(low), "{x:e}");
        }
        assert_eq!([top_exponent(-0.0), lowest_bit(0.0)], [None; 2]);
    }

    #[test]
    fn scaling_is_exact_where_it_can_be() {
        assert_eq!(scale(1.0, -1074), 5e-324);
        assert_eq!(scale(0.75, 1023), 0.75 * power_of_two(1023));
        assert_eq!(scale(scale(0.1, -900), 900), 0.1);
        assert_eq!(scale(5e-324, 1074), 1.0);
        assert_eq!(scale(f64::MAX, -2044), f64::MAX * power_of_two(-1022) * power_of_two(-1022));
        // 1 + 2^-52 down to the subnormals: one rounding, to even.
        assert_eq!(scale(1.0 + f64::EPSILON, -1074), 5e-324);
        assert_eq!(scale(1.5, -1074), 1e-323);
    }
}
