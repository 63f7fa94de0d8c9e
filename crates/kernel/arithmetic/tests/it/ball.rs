//! Balls against rationals.

use predicament_arithmetic::{Ball, rational};
use proptest::prelude::*;
use rug::Rational;

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
        // Few bits anywhere, so that terms overlap and cancel.
        (-3i32..4, -1074i32..1022).prop_map(|(few, e)| f64::from(few) * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)),
        (-300i32..300).prop_map(f64::from),
        Just(-0.0),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// A ball's answer is right, also about the small rest of a value after its nearest double is subtracted.
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
