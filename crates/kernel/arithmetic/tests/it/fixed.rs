//! Limbs against GMP: every length that a rung uses, and every carry of short ones.

use predicament_arithmetic::Fixed;
use proptest::prelude::*;
use rug::{Integer, integer::Order};

/// Limbs at which carries and borrows begin, go on and end.
const EDGES: [u64; 6] = [0, 1, u64::MAX >> 1, 1 << 63, u64::MAX - 1, u64::MAX];

fn value<const L: usize>(x: Fixed<L>) -> Integer {
    let unsigned = Integer::from_digits(x.limbs(), Order::Lsf);
    if x.is_negative() { unsigned - (Integer::from(1) << bits::<L>()) } else { unsigned }
}

fn bits<const L: usize>() -> u32 {
    64 * u32::try_from(L).expect("few")
}

/// The numbers whose limbs are all at an edge.
fn at_edges<const L: usize>() -> Vec<Fixed<L>> {
    let count = EDGES.len().pow(u32::try_from(L).expect("few"));
    let one = |at: usize| {
        Fixed::from_limbs(std::array::from_fn(|limb| {
            EDGES[at / EDGES.len().pow(u32::try_from(limb).expect("few")) % EDGES.len()]
        }))
    };
    (0..count).map(one).collect()
}

fn sums<const L: usize>(a: Fixed<L>, b: Fixed<L>) {
    assert_eq!(value(a.plus(b)), (value(a) + value(b)).keep_signed_bits(bits::<L>()), "{a:?} + {b:?}");
    assert_eq!(value(a.minus(b)), (value(a) - value(b)).keep_signed_bits(bits::<L>()), "{a:?} - {b:?}");
}

fn product<const A: usize, const B: usize, const P: usize>(a: Fixed<A>, b: Fixed<B>) {
    let kept = 64 * u32::try_from(P.min(A + B)).expect("few");
    assert_eq!(value(a.times::<B, P>(b)), (value(a) * value(b)).keep_signed_bits(kept), "{a:?} * {b:?} in {P} limbs");
}

#[test]
fn every_carry_of_short_numbers() {
    let (one, two, three) = (at_edges::<1>(), at_edges::<2>(), at_edges::<3>());
    for &a in &one {
        for &b in &one {
            sums(a, b);
            product::<1, 1, 2>(a, b);
            product::<1, 1, 1>(a, b);
        }
        for &b in &two {
            product::<1, 2, 3>(a, b);
            product::<2, 1, 2>(b, a);
        }
    }
    for &a in &two {
        for &b in &two {
            sums(a, b);
            product::<2, 2, 4>(a, b);
            product::<2, 2, 3>(a, b);
        }
    }
    for (at, &a) in three.iter().enumerate() {
        for &b in three.iter().skip(at % 3).step_by(3) {
            sums(a, b);
            product::<3, 3, 6>(a, b);
        }
    }
}

/// Limbs that are often at an edge.
fn limbs<const L: usize>() -> impl Strategy<Value = Fixed<L>> {
    let limb = prop_oneof![any::<u64>(), prop::sample::select(&EDGES[..]), (0..64_u32).prop_map(|bit| 1 << bit)];
    prop::collection::vec(limb, L).prop_map(|limbs| Fixed::from_limbs(std::array::from_fn(|at| limbs[at])))
}

/// The lengths of differences, lifts, minors and determinants, of one, two and four limbs a difference.
macro_rules! lengths {
    ($($name:ident: $length:literal),*) => {
        proptest! {
            #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]
            $(
                #[test]
                fn $name(a in limbs::<$length>(), b in limbs::<$length>(), c in limbs::<1>(), d in limbs::<2>()) {
                    sums(a, b);
                    product::<$length, $length, { 2 * $length }>(a, b);
                    product::<$length, $length, $length>(a, b);
                    product::<$length, 1, { $length + 1 }>(a, c);
                    product::<$length, 2, { $length + 2 }>(a, d);
                }
            )*
        }
    };
}

lengths!(
    one_limb: 1, two_limbs: 2, three_limbs: 3, four_limbs: 4, five_limbs: 5, six_limbs: 6, eight_limbs: 8, ten_limbs: 10,
    twelve_limbs: 12, sixteen_limbs: 16, twenty_limbs: 20
);
