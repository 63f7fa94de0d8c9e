//! Dyadic numbers against rationals.

use std::cmp::Ordering;

use predicament_arithmetic::{
    dyadic::{
        Number, Space,
        Take::{Minus, Plus},
    },
    rational,
};
use proptest::prelude::*;
use rug::{Integer, Rational, integer::Order};

/// Enough limbs for all numbers of a test that multiplies four sums of doubles.
const ROOM: usize = 40 * 34;

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
        // Few bits anywhere, so that terms overlap, cancel and leave zero limbs.
        (-3i32..4, -1074i32..1022).prop_map(|(few, e)| f64::from(few) * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)),
        (-300i32..300).prop_map(f64::from),
        Just(-0.0),
    ]
}

fn value(number: Number) -> Rational {
    let magnitude = Rational::from(Integer::from_digits(number.limbs, Order::Lsf)) << (64 * number.low);
    if number.negative { -magnitude } else { magnitude }
}

/// The required length of a number: the limbs from its lowest to its highest set bit.
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

/// Checks that both are the same number, in its unique form.
fn same(number: Number, expected: &Rational) -> Result<(), TestCaseError> {
    prop_assert_eq!(&value(number), expected);
    prop_assert_eq!(number.cmp0(), expected.cmp0());
    prop_assert_eq!(number.is_zero(), expected.is_zero());
    prop_assert!(!(number.is_zero() && number.negative), "zero has no sign");
    prop_assert_eq!(number.limbs.len(), limbs_of(expected), "{:?} is not trimmed", number);
    Ok(())
}

fn sum<'a>(space: &mut Space<'a>, a: Number, b: Number) -> Number<'a> {
    Number::sum(space, [(a, Number::ONE, Plus), (Number::ONE, b, Plus)])
}

fn difference<'a>(space: &mut Space<'a>, a: Number, b: Number) -> Number<'a> {
    Number::sum(space, [(a, Number::ONE, Plus), (Number::ONE, b, Minus)])
}

fn product<'a>(space: &mut Space<'a>, a: Number, b: Number) -> Number<'a> {
    Number::sum(space, [(a, b, Plus)])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    #[test]
    fn doubles_are_themselves(x in finite(), shift in -3000i32..3000) {
        let mut limbs = [0; 4];
        let space = &mut Space::new(&mut limbs);
        let expected = rational(x).unwrap();
        same(Number::scaled(space, x, 0), &expected)?;
        same(Number::scaled(space, x, shift), &(expected << shift))?;
    }

    #[test]
    fn sums_and_products(x in finite(), y in finite()) {
        let mut limbs = [0; ROOM];
        let space = &mut Space::new(&mut limbs);
        let [a, b] = [x, y].map(|x| Number::scaled(space, x, 0));
        let [p, q] = [x, y].map(|x| rational(x).unwrap());
        same(sum(space, a, b), &Rational::from(&p + &q))?;
        same(difference(space, a, b), &Rational::from(&p - &q))?;
        same(product(space, a, b), &Rational::from(&p * &q))?;
        same(product(space, a, a), &Rational::from(p.square_ref()))?;
    }

    /// Long numbers: products of sums, and sums of those products.
    #[test]
    fn polynomials(x in prop_oneof![
        prop::array::uniform8(finite()),
        // Few bits and exponents, so that much cancels.
        prop::array::uniform8((-128i32..128, -9i32..9).prop_map(|(x, e)| f64::from(x) * 2f64.powi(e * 100))),
    ]) {
        let mut limbs = [0; ROOM];
        let space = &mut Space::new(&mut limbs);
        let n = x.map(|x| Number::scaled(space, x, 0));
        let q = x.map(|x| rational(x).unwrap());
        let [(a, p), (b, q), (c, r), (d, s)] =
            [0, 2, 4, 6].map(|i| (difference(space, n[i], n[i + 1]), Rational::from(&q[i] - &q[i + 1])));
        let (ab, pq) = (product(space, a, b), Rational::from(&p * &q));
        let (cd, rs) = (product(space, c, d), Rational::from(&r * &s));
        same(ab, &pq)?;
        same(sum(space, ab, cd), &Rational::from(&pq + &rs))?;
        same(difference(space, ab, cd), &Rational::from(&pq - &rs))?;
        same(product(space, ab, cd), &Rational::from(&pq * &rs))?;
        // In one sum, as determinants do.
        same(Number::sum(space, [(a, b, Minus), (c, d, Plus)]), &Rational::from(&rs - &pq))?;
        // (a + b)(a − b) = a² − b², to the last bit.
        let [both, apart] = [sum(space, a, b), difference(space, a, b)];
        same(Number::sum(space, [(both, apart, Plus), (a, a, Minus), (b, b, Plus)]), &Rational::new())?;
    }
}

#[test]
fn far_numbers_have_short_products_and_long_sums() {
    let mut limbs = [0; ROOM];
    let space = &mut Space::new(&mut limbs);
    let [small, large] = [5e-324, f64::MAX].map(|x| Number::scaled(space, x, 0));
    assert_eq!(product(space, small, small).limbs.len(), 1);
    let both = sum(space, large, small);
    assert_eq!(both.limbs.len(), 33);
    let back = difference(space, both, large);
    assert_eq!((value(back), back.limbs.len()), (value(small), 1));
    assert_eq!(Number::ZERO.cmp0(), Ordering::Equal);
    assert_eq!(difference(space, large, large).cmp0(), Ordering::Equal);
}

/// A full number of two limbs, 2^128 − 1.
const FULL: Number = Number { limbs: &[u64::MAX; 2], low: 0, negative: false };

#[test]
fn what_fits_is_right_to_the_last_limb() {
    // The sign takes a bit in addition to the four limbs of the square.
    let mut limbs = [0; 5];
    let square = product(&mut Space::new(&mut limbs), FULL, FULL);
    assert_eq!(value(square), Rational::from((Integer::from(1) << 128) - 1u32).square());
    // The carry leaves a single limb, but needs a third limb temporarily.
    let mut limbs = [0; 3];
    assert_eq!(sum(&mut Space::new(&mut limbs), FULL, Number::ONE).limbs, [1]);
}

#[test]
#[should_panic(expected = "the space suffices")]
fn a_carry_beyond_the_space_panics() {
    let _ = sum(&mut Space::new(&mut [0; 2]), FULL, Number::ONE);
}

#[test]
#[should_panic(expected = "the space suffices")]
fn a_product_beyond_the_space_panics() {
    let _ = product(&mut Space::new(&mut [0; 4]), FULL, FULL);
}

#[test]
#[should_panic(expected = "the space suffices")]
fn a_wide_sum_beyond_the_space_panics() {
    let mut limbs = [0; 4 + 32];
    let space = &mut Space::new(&mut limbs);
    let [small, large] = [5e-324, f64::MAX].map(|x| Number::scaled(space, x, 0));
    let _ = sum(space, large, small);
}

#[test]
#[should_panic(expected = "the space suffices")]
fn a_double_beyond_the_space_panics() {
    let _ = Number::scaled(&mut Space::new(&mut [0; 1]), 1.0, 0);
}
