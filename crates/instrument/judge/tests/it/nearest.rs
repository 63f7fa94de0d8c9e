//! The nearest double, against the definition and against the parser of decimals.

use predicament_judge::{nearest, rational};
use proptest::prelude::*;
use rug::ops::Pow;
use rug::{Integer, Rational};

#[test]
fn halfway_goes_to_the_even_one_and_nothing_overflows() {
    let half_ulp = rational(2.0_f64.powi(-53));
    assert_eq!(nearest(&(rational(1.0) + &half_ulp)), 1.0);
    assert_eq!(nearest(&(rational(1.0_f64.next_up()) + half_ulp)), 1.0 + 2.0 * f64::EPSILON);
    assert_eq!(nearest(&Rational::from((1, 3))), 1.0 / 3.0);
    assert_eq!(nearest(&Rational::from((-2, 3))), -2.0 / 3.0);
    let tiny = rational(f64::from_bits(1)) / 2_u32;
    assert_eq!(nearest(&tiny), 0.0);
    assert_eq!(nearest(&(tiny * Rational::from((3, 2)))), f64::from_bits(1));
    let huge = rational(f64::MAX) * 2_u32;
    assert_eq!([nearest(&huge), nearest(&-huge)], [f64::MAX, f64::MIN]);
}

proptest! {
    #[test]
    fn no_double_is_nearer(n in any::<i64>(), d in 1..i64::MAX, shift in 0..1200_u32) {
        for x in [Rational::from((n, d)), Rational::from((n, d)) >> shift, Rational::from((n, d)) << (shift / 2)] {
            let found = nearest(&x);
            let off = |y: f64| (rational(y) - &x).abs();
            for other in [found.next_up(), found.next_down()] {
                prop_assert!(off(found) <= off(other), "{found:e} for {x}, not {other:e}");
            }
        }
    }

    #[test]
    fn decimals_are_rounded_as_the_parser_does(digits in 1..10_000_000_000_000_000_000_i128, places in 0..30_u32) {
        let x = Rational::from((Integer::from(digits), Integer::from(10).pow(places)));
        let text = format!("{digits}e-{places}");
        prop_assert_eq!(nearest(&x), text.parse::<f64>().unwrap());
    }
}
