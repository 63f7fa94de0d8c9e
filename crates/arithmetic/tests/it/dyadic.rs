//! Dyadic numbers against rationals.

use std::cmp::Ordering;

use predicament_arithmetic::{Ball, Dyadic, rational};
use proptest::prelude::*;
use rug::{Integer, Rational};

/// Enough for products of four sums of doubles.
const CAP: usize = 4 * 34;
type Number = Dyadic<CAP>;

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
        // Few bits anywhere, so that terms meet, cancel and leave zero limbs.
        (-3i32..4, -1074i32..1022).prop_map(|(few, e)| f64::from(few) * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)),
        (-300i32..300).prop_map(f64::from),
        Just(-0.0),
    ]
}

/// How long a number must be: the limbs from its lowest to its highest set bit.
fn limbs_of(value: &Rational) -> usize {
    if value.is_zero() {
        return 0;
    }
    // As an integer over a power of two whose exponent is a multiple of 64.
    let low = if value.denom() == &1 {
        i64::from(value.numer().find_one(0).unwrap())
    } else {
        -i64::from(value.denom().significant_bits() - 1)
    };
    let odd = if value.denom() == &1 {
        i64::from(value.numer().significant_bits()) - low
    } else {
        i64::from(value.numer().significant_bits())
    };
    usize::try_from((low + odd - 1).div_euclid(64) - low.div_euclid(64) + 1).unwrap()
}

/// That both are the same number, in its only form.
fn same<const N: usize>(number: &Dyadic<N>, value: &Rational) -> Result<(), TestCaseError> {
    prop_assert_eq!(&number.to_rational(), value);
    prop_assert_eq!(number.cmp0(), value.cmp0());
    prop_assert_eq!(number.is_zero(), value.is_zero());
    prop_assert_eq!(number.limbs(), limbs_of(value), "{:?} is not trimmed", number);
    Ok(())
}

fn both(x: f64) -> (Number, Rational) {
    (Number::from_f64(x).unwrap(), rational(x).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    #[test]
    fn doubles_are_themselves(x in finite(), exponent in -3000i32..3000) {
        let (number, value) = both(x);
        same(&number, &value)?;
        same(&Dyadic::<2>::from_f64(x).unwrap(), &value)?;
        same(&Number::from_f64_scaled(x, exponent), &(value.clone() >> exponent))?;
        same(&-number, &-value)?;
    }

    #[test]
    fn integers_with_exponents(negative: bool, significand: u64, exponent in -100_000i32..100_000) {
        let magnitude = Rational::from(significand) << exponent;
        same(&Dyadic::<2>::new(negative, significand, exponent), &if negative { -magnitude } else { magnitude })?;
    }

    #[test]
    fn sums_and_products(x in finite(), y in finite()) {
        let ((a, p), (b, q)) = (both(x), both(y));
        same(&Dyadic::<34>::sum(&a, &b), &Rational::from(&p + &q))?;
        same(&Dyadic::<34>::difference(&a, &b), &Rational::from(&p - &q))?;
        same(&Dyadic::<4>::product(&a, &b), &Rational::from(&p * &q))?;
        same(&Dyadic::<4>::square(&a), &Rational::from(p.square_ref()))?;
        prop_assert_eq!(a == b, p == q);
    }

    /// Long numbers: products of sums, and sums of those.
    #[test]
    fn polynomials(x in prop_oneof![
        prop::array::uniform8(finite()),
        // Few bits and exponents: much cancels.
        prop::array::uniform8((-128i32..128, -9i32..9).prop_map(|(x, e)| f64::from(x) * 2f64.powi(e * 100))),
    ]) {
        let n = x.map(|x| both(x).0);
        let q = x.map(|x| both(x).1);
        let pair = |i: usize| (Number::difference(&n[i], &n[i + 1]), Rational::from(&q[i] - &q[i + 1]));
        let [(a, p), (b, q), (c, r), (d, s)] = [pair(0), pair(2), pair(4), pair(6)];
        let (ab, pq) = (Number::product(&a, &b), Rational::from(&p * &q));
        let (cd, rs) = (Number::product(&c, &d), Rational::from(&r * &s));
        same(&ab, &pq)?;
        same(&Number::sum(&ab, &cd), &Rational::from(&pq + &rs))?;
        same(&Number::difference(&ab, &cd), &Rational::from(&pq - &rs))?;
        same(&Number::product(&ab, &cd), &Rational::from(&pq * &rs))?;
        // (a + b)(a − b) = a² − b², to the last bit.
        let left = Number::product(&Number::sum(&a, &b), &Number::difference(&a, &b));
        let right = Number::difference(&Number::square(&a), &Number::square(&b));
        prop_assert!(left == right);
        same(&Number::difference(&left, &right), &Rational::new())?;
    }

    /// What a ball says is true, also about what little is left of a value
    /// after its nearest double is taken away.
    #[test]
    fn balls_are_right_or_silent(x in proptest::collection::vec(finite(), 6)) {
        let b: Vec<Ball> = x.iter().map(|&x| Ball::new(x)).collect();
        let q: Vec<Rational> = x.iter().map(|&x| rational(x).unwrap()).collect();
        let mut ball = (b[0] - b[1]) * (b[2] + b[3]) + b[4] * b[5];
        let mut value = Rational::from(&q[0] - &q[1]) * Rational::from(&q[2] + &q[3]) + Rational::from(&q[4] * &q[5]);
        for _ in 0..3 {
            if let Some(order) = ball.cmp0() {
                prop_assert_eq!(order, value.cmp0());
            }
            let nearest = value.to_f64();
            prop_assume!(nearest.is_finite());
            ball = ball - Ball::new(nearest);
            value -= rational(nearest).unwrap();
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(Number::from_f64(x).is_none());
    }
}

#[test]
fn far_numbers_have_short_products_and_long_sums() {
    let [small, large] = [5e-324, f64::MAX].map(|x| Number::from_f64(x).unwrap());
    assert_eq!(Number::square(&small).limbs(), 1);
    assert_eq!(Number::sum(&large, &small).limbs(), 33);
    let back = Number::difference(&Number::sum(&large, &small), &large);
    assert!(back == small && back.limbs() == 1);
    assert_eq!(Number::ZERO.cmp0(), Ordering::Equal);
    assert_eq!(Number::difference(&large, &large).cmp0(), Ordering::Equal);
}

/// A full number of two limbs, 2^128 − 1.
fn full() -> Dyadic<2> {
    Dyadic::sum(&Dyadic::<1>::new(false, u64::MAX, 64), &Dyadic::<1>::new(false, u64::MAX, 0))
}

#[test]
fn what_fits_is_right_to_the_last_limb() {
    let square = Dyadic::<4>::square(&full());
    assert_eq!(square.to_rational(), Rational::from((Integer::from(1) << 128) - 1u32).square());
    let one = Dyadic::<1>::new(false, 1, 0);
    // The carry leaves a single limb behind, but asks for a third one on its way.
    assert_eq!(Dyadic::<3>::sum(&full(), &one).limbs(), 1);
}

#[test]
#[should_panic(expected = "exceeds the capacity")]
fn a_carry_beyond_the_capacity_panics() {
    let two = Dyadic::<1>::new(false, 2, 0);
    let _ = Dyadic::<2>::sum(&full(), &two);
}

#[test]
#[should_panic(expected = "exceeds the capacity")]
fn a_product_beyond_the_capacity_panics() {
    let _ = Dyadic::<3>::square(&full());
}

#[test]
#[should_panic(expected = "exceeds the capacity")]
fn a_wide_sum_beyond_the_capacity_panics() {
    let [small, large] = [5e-324, f64::MAX].map(|x| Number::from_f64(x).unwrap());
    let _ = Dyadic::<32>::sum(&large, &small);
}

#[test]
#[should_panic(expected = "exceeds the capacity")]
fn a_double_beyond_the_capacity_panics() {
    let _ = Dyadic::<1>::from_f64(f64::from(1u32 << 31) + 2f64.powi(-21));
}
