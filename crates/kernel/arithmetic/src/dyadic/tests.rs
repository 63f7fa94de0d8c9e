//! Sums of products against rationals, limb by limb.

use proptest::prelude::*;
use rug::{Integer, Rational, integer::Order};

use super::*;

fn value(number: Number) -> Rational {
    let magnitude = Rational::from(Integer::from_digits(number.limbs, Order::Lsf)) << (64 * number.low);
    if number.negative { -magnitude } else { magnitude }
}

/// Limbs that are often all zeros, all ones or a single bit; the test trims them.
fn limbs() -> impl Strategy<Value = (Vec<u64>, i32, bool)> {
    let limb = prop_oneof![any::<u64>(), Just(0), Just(u64::MAX), (0..64_u32).prop_map(|bit| 1 << bit)];
    (proptest::collection::vec(limb, 0..6), -3..4, any::<bool>())
}

fn check<const N: usize>(parts: &[(Vec<u64>, i32, bool)], takes: u8) {
    let number = |i: usize| {
        let (limbs, low, negative) = &parts[i % parts.len()];
        Number::trimmed(limbs, *low, *negative)
    };
    let take = |i: usize| if takes >> i & 1 == 1 { Take::Minus } else { Take::Plus };
    let terms: [Term; N] = std::array::from_fn(|i| (number(2 * i), number(2 * i + 1), take(i)));
    let mut limbs = [0; 32];
    let sum = Number::sum(&mut Space::new(&mut limbs), terms);
    let mut truth = Rational::new();
    for (a, b, take) in terms {
        let product = value(a) * value(b);
        if take == Take::Plus { truth += product } else { truth -= product }
    }
    assert_eq!(value(sum), truth);
    assert_eq!(sum.cmp0(), truth.cmp0());
    assert!(sum.limbs.first() != Some(&0) && sum.limbs.last() != Some(&0));
    if !sum.is_zero() {
        let magnitude = Rational::from(truth.abs_ref());
        let power = |exponent: i32| Rational::from(1) << exponent;
        assert!(magnitude < power(sum.high()) && magnitude >= power(sum.high() - 1));
        assert!(magnitude < power(64 * sum.top()));
        let (bits, exponent) = sum.leading().expect("not zero");
        let cut = &magnitude - Rational::from(bits) * power(exponent);
        assert!(bits >> 127 == 1 && cut >= 0 && cut < power(exponent));
        check_quotient(sum, number(0));
    }
}

fn check_quotient(x: Number, y: Number) {
    let Some((mantissa, exponent)) = x.quotient(y) else {
        assert!(x.is_zero() || y.is_zero());
        return;
    };
    let power = |exponent: i32| Rational::from(1) << exponent;
    let truth = (value(x) / value(y)).abs();
    assert!((2f64.powi(63)..=2f64.powi(65)).contains(&mantissa));
    let error = Rational::from_f64(mantissa).expect("finite") * power(exponent) - &truth;
    assert!(error.abs() <= truth * (power(-53) + power(-60)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn sums_of_products_are_those_of_gmp(parts in proptest::collection::vec(limbs(), 12), takes in any::<u8>()) {
        check::<1>(&parts, takes);
        check::<2>(&parts, takes);
        check::<3>(&parts, takes);
        check::<6>(&parts, takes);
    }

    /// Numbers of one limb have their own code path.
    #[test]
    fn short_sums_too(parts in proptest::collection::vec(any::<(u64, bool)>(), 12), bits in 0..64_u32, takes in any::<u8>()) {
        let parts: Vec<_> = parts.into_iter().map(|(limb, negative)| (vec![limb >> bits], 0, negative)).collect();
        check::<2>(&parts, takes);
        check::<3>(&parts, takes);
        check::<6>(&parts, takes);
        // Cancellation to zero.
        check::<2>(&parts[..2], 0b10);
    }

    #[test]
    fn doubles_are_scaled_exactly(bits in any::<u64>(), shift in -2200..2200_i32) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        let mut limbs = [0; 2];
        let number = Number::scaled(&mut Space::new(&mut limbs), x, shift);
        prop_assert_eq!(value(number), Rational::from_f64(x).unwrap() << shift);
    }
}

/// Capacities count from the lowest place.
#[test]
fn zero_has_no_low_place() {
    for (zero, shift) in [(0.0, 0), (-0.0, 58), (0.0, -2000)] {
        let mut limbs = [0; 2];
        assert_eq!(Number::scaled(&mut Space::new(&mut limbs), zero, shift).low, 0);
    }
}

#[test]
fn one_is_one() {
    assert!(Number::ONE.is_one() && !Number::ZERO.is_one());
    assert_eq!((value(Number::ONE), value(Number::ZERO)), (Rational::from(1), Rational::new()));
}
