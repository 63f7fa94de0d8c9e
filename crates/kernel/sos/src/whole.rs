//! Doubles as integers over a common power of two, which changes no sign of a homogeneous polynomial.

use predicament_arithmetic::Parts;

use crate::integer::Integer;

/// Doubles in units of their lowest bit.
///
/// The unit's exponent comes first, then significands and exponents from 0 on.
pub(crate) fn parts(doubles: impl IntoIterator<Item = f64>) -> (i32, Vec<(i64, u32)>) {
    let parts: Vec<(i64, i32)> = doubles.into_iter().map(significand).collect();
    let lowest = parts.iter().filter(|(m, _)| *m != 0).map(|(_, exponent)| *exponent).min().unwrap_or(0);
    let raise = |(m, exponent): (i64, i32)| (m, (exponent - lowest).max(0).unsigned_abs());
    (lowest, parts.into_iter().map(raise).collect())
}

/// Doubles as integers of any length, in units of their lowest bit.
pub(crate) fn integers<const N: usize>(doubles: [f64; N]) -> [Integer; N] {
    let (_, parts) = parts(doubles);
    std::array::from_fn(|at| Integer::from(parts[at].0) << parts[at].1)
}

/// The pair (m, e) with x = m · 2^e; 0 · 2^0 for zero.
pub(crate) fn significand(x: f64) -> (i64, i32) {
    let Parts { negative, significand, exponent } = Parts::of(x).expect("scenes are finite").odd();
    let m = significand.cast_signed();
    if m == 0 { (0, 0) } else { (if negative { -m } else { m }, exponent) }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::integer::tests::value;

    const DOUBLES: [f64; 9] = [0.0, -0.0, 1.0, -1.5, 0.1, 5e-324, -f64::MIN_POSITIVE, f64::MAX, f64::from_bits(48)];

    #[test]
    fn significands_are_exact() {
        for x in DOUBLES {
            let (m, e) = significand(x);
            assert_eq!(Rational::from(m) * (Rational::from(1) << e), Rational::from_f64(x).unwrap(), "{x:e}");
        }
    }

    #[test]
    fn integers_are_the_doubles_over_the_largest_common_power_of_two() {
        for doubles in [DOUBLES, DOUBLES.map(|x| if x.abs() < 1.0 { 3.0 } else { x }), [-0.0; 9]] {
            let (unit, _) = parts(doubles);
            let whole = integers(doubles);
            for (x, integer) in doubles.iter().zip(&whole) {
                assert_eq!(Rational::from(value(integer)) << unit, Rational::from_f64(*x).unwrap(), "{x:e}");
            }
            let odd = whole.iter().any(|integer| value(integer).is_odd());
            assert!(odd || doubles == [0.0; 9], "{doubles:?}");
        }
    }
}
