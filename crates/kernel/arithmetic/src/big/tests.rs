//! Integers of any length against GMP's.

use alloc::vec::Vec;

use proptest::prelude::*;
use rug::{Integer, integer::Order};

use super::BigInt;

fn value(integer: &BigInt) -> Integer {
    let magnitude = Integer::from_digits(integer.limbs(), Order::Lsf);
    if integer.is_negative() { -magnitude } else { magnitude }
}

/// Limbs that are often all zeros or all ones, as carries and wrong estimates of quotients need them.
fn limb() -> impl Strategy<Value = u64> {
    prop_oneof![3 => any::<u64>(), 1 => Just(0), 1 => Just(u64::MAX), 1 => Just(1), 1 => Just(1 << 63)]
}

fn integer(most: usize) -> impl Strategy<Value = BigInt> {
    (any::<bool>(), prop::collection::vec(limb(), 0..=most)).prop_map(|(negative, limbs)| BigInt::new(negative, limbs))
}

/// Compares sums in place, which reuse the limbs of either number.
fn check_in_place(a: &BigInt, b: &BigInt, common: &BigInt) {
    let [x, y, z] = [a, b, common].map(value);
    let (mut plus, mut minus, mut product) = (a.clone(), a.clone(), a.clone());
    plus += b;
    minus -= b;
    product.add_product(b, common);
    assert_eq!([&plus, &minus].map(value), [Integer::from(&x + &y), Integer::from(&x - &y)]);
    assert_eq!(value(&product), x + y * z);
    for number in [plus, minus, product] {
        assert_eq!(number, BigInt::new(number.is_negative(), number.limbs().to_vec()), "zeros at the upper end");
    }
}

fn check(a: &BigInt, b: &BigInt, common: &BigInt) {
    check_in_place(a, b, common);
    check_in_place(a, &-a.clone(), &BigInt::ZERO);
    // The product cancels the number, except for the second factor.
    check_in_place(&(a * b), &-a.clone(), &(b + &BigInt::from(1_u64)));
    let [x, y] = [a, b].map(value);
    assert_eq!(value(&(a + b)), Integer::from(&x + &y));
    assert_eq!(value(&(a - b)), Integer::from(&x - &y));
    let product = a * b;
    assert_eq!(value(&product), Integer::from(&x * &y));
    assert_eq!(product.cmp0(), Integer::from(&x * &y).cmp0());
    assert_eq!(value(&a.gcd(b)), Integer::from(x.gcd_ref(&y)));
    let [left, right] = [a, b].map(|number| number * common);
    let divisor = left.gcd(&right);
    assert_eq!(value(&divisor), value(&left).gcd(&value(&right)));
    if !divisor.is_zero() {
        for number in [&left, &right] {
            assert_eq!(value(&number.div_exact(&divisor)), value(number) / value(&divisor));
        }
    }
    if !b.is_zero() {
        assert_eq!(&product.div_exact(b), a);
        let mut rest = a.limbs().to_vec();
        super::divisor::remainder(&mut rest, b.limbs());
        assert_eq!(value(&BigInt::new(false, rest)), value(a).abs() % value(b).abs());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

    #[test]
    fn short_numbers_agree_with_gmp(a in integer(5), b in integer(5), common in integer(3)) {
        check(&a, &b, &common);
    }

    #[test]
    fn long_numbers_agree_with_gmp(a in integer(150), b in integer(150), common in integer(60)) {
        check(&a, &b, &common);
    }
}

#[test]
fn integers_of_a_machine_and_their_multiples_by_powers_of_two() {
    for number in [0, 1, -1, 12_345_678_901_234_567, i64::MAX, i64::MIN] {
        for places in [0, 1, 63, 64, 65, 128, 2098] {
            let shifted = BigInt::from(number) << places;
            assert_eq!(value(&shifted), Integer::from(number) << places, "{number} · 2^{places}");
            assert_eq!(shifted, BigInt::new(number < 0, shifted.limbs().to_vec()));
        }
    }
}

#[test]
fn remainders_of_the_fibonacci_numbers_are_the_most_steps() {
    let (mut a, mut b) = (BigInt::from(1_u64), BigInt::from(1_u64));
    for _ in 0..2000 {
        (a, b) = (b.clone(), &a + &b);
    }
    check(&a, &b, &BigInt::from(12_u64));
    assert_eq!(a.gcd(&b), BigInt::from(1_u64));
}

#[test]
fn zero_has_no_limbs_and_no_sign() {
    let zero = BigInt::new(true, Vec::from([0, 0]));
    assert_eq!((&zero, zero.is_negative(), zero.limbs().len()), (&BigInt::ZERO, false, 0));
    assert_eq!(-zero, BigInt::ZERO);
    assert_eq!(BigInt::ZERO.gcd(&-BigInt::from(6_u64)), BigInt::from(6_u64));
    assert_eq!(BigInt::ZERO.div_exact(&BigInt::from(6_u64)), BigInt::ZERO);
}

/// A quotient that three limbs overestimate: the divisor is added back (Knuth, algorithm D, step D6).
#[test]
fn a_remainder_is_right_where_a_quotient_was_estimated_too_large() {
    let top = 1 << 63;
    for (number, divisor) in [([0, 0, top, top - 1], [1, 0, top]), ([3, 0, top, top - 1], [5, 0, top])] {
        let mut rest = number.to_vec();
        super::divisor::remainder(&mut rest, &divisor);
        let [number, divisor] = [&number[..], &divisor].map(|limbs| Integer::from_digits(limbs, Order::Lsf));
        assert_eq!(Integer::from_digits(&rest, Order::Lsf), number % divisor);
    }
}
