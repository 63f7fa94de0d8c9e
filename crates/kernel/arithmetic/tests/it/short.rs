//! The bit limit of short rows: 61 bits are accepted, 62 are not, whatever the exponent.

use predicament_arithmetic::{rational, short_rows};
use rug::Rational;

/// The number of bits that differences may span.
const BITS: i32 = 61;

/// The rows of differences of one number each, to zero, if they are accepted; in proportion to the differences.
fn rows<const N: usize>(differences: [f64; N]) -> Option<[i64; N]> {
    let mut points = [[0.0; 4]; 2];
    points[0][..N].copy_from_slice(&differences);
    let rows = short_rows(points)?;
    let integers: [i64; N] = std::array::from_fn(|i| rows[0][i].limbs()[0].cast_signed());
    let exact = differences.map(|x| rational(x).expect("finite"));
    for (i, x) in exact.iter().enumerate() {
        for (j, y) in exact.iter().enumerate() {
            let [left, right] = [Rational::from(x * integers[j]), Rational::from(y * integers[i])];
            assert_eq!(left, right, "{differences:?} as {integers:?}");
        }
    }
    assert!(integers.iter().zip(&differences).all(|(integer, x)| (*integer == 0) == (*x == 0.0)));
    assert!(integers.iter().all(|integer| integer.unsigned_abs() < 1 << BITS), "{integers:?}");
    Some(integers)
}

/// The normal double 2^k.
fn power(k: i32) -> f64 {
    f64::from_bits(u64::try_from(k + 1023).expect("normal") << 52)
}

#[test]
fn the_last_bit_that_is_taken_and_the_first_that_is_not() {
    // The unit is 2^(low): its inverse must be a double, and so must the largest value.
    for low in -1021..=1023 - BITS {
        for bits in [1, 2, 53, 54, BITS - 1, BITS, BITS + 1, BITS + 2, 64, 65] {
            let top = low + bits - 1;
            if top > 1023 {
                continue;
            }
            let (least, largest) = (power(low), power(top));
            // The largest number of this many bits; beyond 53 bits, the largest double.
            let full = if bits <= 53 { 2.0 * (largest - least / 2.0) } else { largest * (2.0 - f64::EPSILON) };
            let least_first = [least, -largest, 0.0];
            let taken = rows(least_first).is_some();
            assert_eq!(taken, rows([largest, least, -least]).is_some());
            if full.is_finite() {
                assert_eq!(taken, rows([-full, least]).is_some(), "{full:e} and {least:e}");
            }
            // If the unit is not a double, nothing is accepted, and no answer is wrong.
            let has_unit = top + 1023 >= BITS - 1;
            assert_eq!(taken, bits <= BITS && has_unit, "{bits} bits from 2^{low}");
        }
    }
}

#[test]
fn differences_are_what_is_counted() {
    let far = power(80);
    // Far from the origin, and 61 or 62 bits apart from each other.
    for (bits, taken) in [(BITS, true), (BITS + 1, false)] {
        let step = power(80 - 52);
        let wide = step * power(bits - 1);
        let rows = short_rows([[wide, far + step], [0.0, far]]);
        assert_eq!(rows.is_some(), taken, "{bits} bits");
    }
    assert!(short_rows([[far], [0.5]]).is_none(), "81 bits: no double");
    assert!(short_rows([[far + power(80 - 52)], [power(20)]]).is_none(), "rounded");
}
