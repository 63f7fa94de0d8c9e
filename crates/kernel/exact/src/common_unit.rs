//! Integers of one limb for a query without a plan, with its coordinates in a unit of the query.
//!
//! A scene may span more bits than a limb holds while each of its queries spans few: clusters far from each other,
//! figures of many sizes, a few coordinates with long tails. The code finds out by trying, from the query's points
//! alone.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Fixed, power_of_two};

use crate::truncate::to_integer;

/// Differences of one limb.
pub(crate) struct Short<const D: usize, const N: usize> {
    /// The differences in units of 2^`low`.
    pub rows: [[Fixed<1>; D]; N],
    /// An upper bound on their bits.
    pub bits: i32,
    /// The exponent of the unit.
    pub low: i32,
}

/// The differences to the last point as integers in units of some power of two.
///
/// `None` if all coordinates together span more than 61 bits.
#[inline(always)]
pub(crate) fn rows<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> Option<Short<D, N>> {
    // The order of magnitudes is the order of their bits.
    let mut largest = 0;
    for row in 0..N {
        for axis in 0..D {
            let bits = points[row][axis].to_bits() & !(1 << 63);
            largest = if bits > largest { bits } else { largest };
        }
    }
    #[allow(clippy::cast_possible_truncation)] // 11 bits
    let exponent = (largest >> 52) as i32;
    // With the biased exponent e, it is less than 2^(e - 1022); scaled it is less than 2^61.
    if !(61..2047).contains(&exponent) {
        return None;
    }
    let unit = power_of_two(1022 + 61 - exponent);
    let (mut whole, mut all, mut integers) = (true, 0, [[0; D]; N]);
    for row in 0..N {
        for axis in 0..D {
            let x = points[row][axis];
            let scaled = x * unit;
            let integer = to_integer(scaled);
            // (A coordinate that underflows in scaling is not an integer either. For any other the product is exact.)
            #[allow(clippy::cast_precision_loss)] // the comparison detects rounding
            let same = (integer as f64 == scaled) & ((scaled == 0.0) == (x == 0.0));
            whole &= same;
            all |= integer;
            integers[row][axis] = integer;
        }
    }
    if !whole {
        return None;
    }
    // All of them have at least this many trailing zeros, and differences are below 2^62.
    let zeros = all.trailing_zeros() & 63;
    let mut rows = [[Fixed::ZERO; D]; N];
    for row in 0..N - 1 {
        for axis in 0..D {
            rows[row][axis] = Fixed::from((integers[row][axis] - integers[N - 1][axis]) >> zeros);
        }
    }
    let zeros = zeros.cast_signed();
    Some(Short { rows, bits: 62 - zeros, low: exponent - 1022 - 61 + zeros })
}

#[cfg(test)]
mod tests {
    use predicament_arithmetic::rational;
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
            (-9..9_i32).prop_map(f64::from),
            (0..3_u64).prop_map(|ulps| f64::from_bits(0.1_f64.to_bits() + ulps)),
            (-70..0_i32).prop_map(power_of_two),
            Just(-0.0),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

        /// All entries are the differences in the unit, and `bits` bounds their length.
        #[test]
        fn rows_are_proportional_to_differences(p in prop::array::uniform3(prop::array::uniform2(double()))) {
            if let Some(Short { rows, bits, low }) = rows(&p) {
                let exact = |row: usize, axis: usize| rational(p[row][axis]).unwrap() - rational(p[2][axis]).unwrap();
                let integer = |row: usize, axis: usize| Rational::from(rows[row][axis].limbs()[0].cast_signed());
                let all: Vec<_> = (0..4).map(|i| (exact(i / 2, i % 2), integer(i / 2, i % 2))).collect();
                prop_assert!(bits <= 62 && all.iter().all(|(_, integer)| integer.clone().abs() < (1_u64 << bits)));
                for (exact, integer) in all {
                    prop_assert_eq!(exact, if low < 0 { integer >> -low } else { integer << low });
                }
            }
        }
    }

    #[test]
    fn what_is_common_and_what_is_not() {
        let bits = |points: &[[f64; 2]; 2]| rows(points).map(|short| short.bits);
        assert_eq!(bits(&[[1.0, 0.5], [0.5, 0.25]]), Some(4), "three bits, and one for differences");
        assert_eq!(bits(&[[1.0, power_of_two(-60)], [0.5, 0.25]]), Some(62), "the last bit that is taken");
        assert_eq!(bits(&[[1.0, power_of_two(-61)], [0.5, 0.25]]), None, "the first that is not");
        assert_eq!(bits(&[[1e17, 0.5], [0.1, 0.0]]), None);
        assert!(bits(&[[0.9, 0.0078125], [0.1, 0.0]]).is_some(), "a difference that is rounded");
        assert_eq!(bits(&[[0.0, -0.0], [0.0, 0.0]]), None, "nothing to scale");
        assert_eq!(bits(&[[1e200, 1e-200], [0.0, 0.0]]), None, "lost in scaling");
        assert_eq!(bits(&[[f64::MAX, 0.0], [-f64::MAX, 0.0]]), Some(54));
        assert!(bits(&[[f64::NAN, 0.0], [0.0, 0.0]]).is_none() && bits(&[[f64::INFINITY, 0.0], [0.0, 0.0]]).is_none());
        assert_eq!(bits(&[[power_of_two(-963), 0.0], [0.0, 0.0]]), None, "units too small to be doubles");
        assert_eq!(bits(&[[power_of_two(-962), 0.0], [0.0, 0.0]]), Some(2));
    }
}
