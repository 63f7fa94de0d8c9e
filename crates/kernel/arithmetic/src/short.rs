//! Differences of coordinates that need fewer bits than the coordinates.
//!
//! A scene may span more bits than a limb holds while each of its queries spans few: clusters far from each other,
//! figures of many sizes. Nothing is known about such a query in advance; the code tries one limb and checks that it
//! succeeded. Any doubles are allowed.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use crate::{
    Fixed,
    parts::{field, power_of_two},
};

/// The differences to the last point, as integers in units of some power of two.
///
/// `None` if a difference is not a double, or if they span more than 61 bits.
#[inline(always)]
#[must_use]
pub fn short_rows<const D: usize, const N: usize>(points: [[f64; D]; N]) -> Option<[[Fixed<1>; D]; N]> {
    let differences = exact_differences(points)?;
    let largest = largest(&differences);
    // With the biased exponent e, it is less than 2^(e - 1022); scaled it is less than 2^61.
    let exponent = field(largest);
    if !(60..2047).contains(&exponent) {
        return None;
    }
    let unit = power_of_two(1022 + 61 - exponent);
    let mut whole = true;
    let mut rows = [[Fixed::ZERO; D]; N];
    for row in 0..N - 1 {
        for axis in 0..D {
            let scaled = differences[row][axis] * unit;
            let integer = Fixed::<1>::from_double(scaled);
            // (A difference that underflows in scaling is not an integer either.)
            whole &= (integer.to_double() == scaled) & ((scaled == 0.0) == (differences[row][axis] == 0.0));
            rows[row][axis] = integer;
        }
    }
    whole.then_some(rows)
}

/// The largest magnitude, found pair by pair: a chain of maxima would have a long latency.
#[inline(always)]
fn largest<const D: usize, const N: usize>(entries: &[[f64; D]; N]) -> f64 {
    let max = |x: f64, y: f64| if x > y { x } else { y };
    let mut sizes = [0.0; 16];
    for row in 0..N - 1 {
        for axis in 0..D {
            let at = (row * D + axis) % 16;
            sizes[at] = max(entries[row][axis].abs(), sizes[at]);
        }
    }
    for half in [8, 4, 2, 1] {
        for at in 0..half {
            sizes[at] = max(sizes[at], sizes[at + half]);
        }
    }
    sizes[0]
}

/// The differences to the last point; `None` if one of them is not a double.
#[inline(always)]
#[must_use]
pub fn exact_differences<const D: usize, const N: usize>(points: [[f64; D]; N]) -> Option<[[f64; D]; N]> {
    let mut exact = true;
    let mut differences = [[0.0; D]; N];
    for row in 0..N - 1 {
        for axis in 0..D {
            let (a, b) = (points[row][axis], points[N - 1][axis]);
            let difference = a - b;
            // From the larger of a and b the other is recovered without rounding (Dekker): if both come out right,
            // nothing was lost.
            exact &= (a - difference == b) & (difference + b == a);
            differences[row][axis] = difference;
        }
    }
    exact.then_some(differences)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::rational;

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
            (-9..9_i32).prop_map(f64::from),
            (0..3_u64).prop_map(|ulps| f64::from_bits(0.1_f64.to_bits() + ulps)),
            Just(-0.0),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

        #[test]
        fn exact_means_exact(a in double(), b in double()) {
            let difference = rational(a).unwrap() - rational(b).unwrap();
            let lost = rational(a - b).is_none_or(|rounded| rounded != difference);
            prop_assert_eq!(exact_differences([[a], [b]]).is_none(), lost);
        }

        /// All entries are the differences, in one common unit.
        #[test]
        fn rows_are_proportional_to_differences(p in prop::array::uniform3(prop::array::uniform2(double()))) {
            if let Some(rows) = short_rows(p) {
                let exact = |row: usize, axis: usize| rational(p[row][axis]).unwrap() - rational(p[2][axis]).unwrap();
                let integer = |row: usize, axis: usize| rug::Rational::from(rows[row][axis].limbs()[0].cast_signed());
                let all: Vec<_> = (0..4).map(|i| (exact(i / 2, i % 2), integer(i / 2, i % 2))).collect();
                let largest = all.iter().max_by_key(|(exact, _)| exact.clone().abs()).unwrap();
                prop_assert!(largest.0 == 0 || largest.1 != 0);
                for (exact, integer) in &all {
                    prop_assert_eq!(rug::Rational::from(exact * &largest.1), rug::Rational::from(integer * &largest.0));
                }
            }
        }
    }

    #[test]
    fn what_is_short_and_what_is_not() {
        assert!(short_rows([[1.0, f64::EPSILON], [0.5, 0.25]]).is_some());
        assert!(short_rows([[1.0, 1e-25], [0.5, 0.0]]).is_none(), "83 bits");
        assert!(short_rows([[1e200, 1e-200], [0.0, 0.0]]).is_none(), "lost in scaling");
        assert!(short_rows([[1e17, 0.5], [0.1, 0.0]]).is_none(), "a difference that is rounded");
        assert!(short_rows([[f64::MAX], [-f64::MAX]]).is_none(), "an infinite difference");
        assert!(short_rows([[f64::NAN], [0.0]]).is_none());
        assert!(short_rows([[1e-300, 0.0], [0.0, 0.0]]).is_none(), "units too small to be doubles");
    }
}
