//! Floating point with a proved error bound and an unlimited exponent.
//!
//! If coordinates span all exponents, products underflow or overflow long before their signs become doubtful. A
//! [`Ball`] stores a double, an integer exponent and a bound on the distance to the real value. Its sign is therefore
//! either proved or reported as unknown. It runs before [dyadic numbers](crate::dyadic) on input with a wide exponent
//! range, where exact numbers are long and most signs are clear.
//!
//! # The error bound
//! A ball (m, r, e) holds a real value v with |v·2^−e − m| ≤ r. It is normalized so that max(|m|, r) lies in \[1, 2),
//! or m = r = 0, which is exact zero. u = 2^−53.
//!
//! **Products.** |m₁ + δ₁||m₂ + δ₂| differs from m₁m₂ by at most |m₁|r₂ + |m₂|r₁ + r₁r₂, and the product of doubles
//! rounds by at most u|m|.
//!
//! **Sums.** The summand with the lower exponent is scaled by 2^−d exactly, for a difference of exponents d ≤ 500. For
//! larger d, 2^−500 replaces 2^−d: both the true and the replaced value lie within (|m| + r)·2^−500 < 2^−498 of zero.
//! This difference is negligible beside the slack of a radius (below), which is at least u after a sum. The sum of
//! doubles rounds by at most u|m|.
//!
//! **Differences of doubles** round by half a unit in the last place at most, which is u for a result scaled to \[1,
//! 2), and not at all if they are subnormal.
//!
//! **The bound itself** is computed in at most eight roundings of relative error u. A factor of 1 + 16u covers them,
//! with at least 4u to spare. A radius is zero, for a double or an exact zero, or at least u, as every operation adds
//! u|m|; scaled, it is at least u·2^−500 and loses nothing. A center below 1 has a radius of 1 or more: if such a
//! center underflows in a product or by scaling, by 2^−1075 at most, the radius has 2^−551 to spare.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use crate::parts::{field, power_of_two};

/// The unit roundoff u = 2^−53.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
/// The factor 1 + 16u, which covers the roundings in the bound.
const ROOM: f64 = 1.0 + 8.0 * f64::EPSILON;
/// The largest difference of exponents; beyond it the lower summand counts as error.
const REACH: i32 = 500;
/// The exponent of zero, lower than all others.
///
/// A product of half a million doubles could reach it; it panics.
const LOWEST: i32 = i32::MIN / 4;

/// An approximate number of any magnitude with a proved bound on its error.
///
/// The module's source has the proof.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    center: f64,
    radius: f64,
    exponent: i32,
}

impl Ball {
    /// The ball of a finite double, without error.
    ///
    /// NaN and infinity count as an unspecified number of 2^1024 or more.
    #[inline(always)]
    #[must_use]
    pub fn new(x: f64) -> Ball {
        let field = field(x);
        if field == 0 {
            return Ball::subnormal(x);
        }
        let center = f64::from_bits(x.to_bits() & !(0x7ff << 52) | 1023 << 52);
        Ball { center, radius: 0.0, exponent: field - 1023 }
    }

    /// The ball of x − y, from one subtraction of doubles; both must be finite.
    #[inline(always)]
    #[must_use]
    pub fn difference(x: f64, y: f64) -> Ball {
        let difference = x - y;
        if difference.is_finite() {
            // The rounding error is half a unit in the last place; the result is exact if zero or subnormal.
            let ball = Ball::new(difference);
            Ball { radius: ball.center.abs().min(1.0) * UNIT_ROUNDOFF, ..ball }
        } else {
            Ball::new(x) - Ball::new(y)
        }
    }

    #[cold]
    fn subnormal(x: f64) -> Ball {
        // A factor of 2^64 is exact here and gives a normal number, or zero.
        let center = x * power_of_two(64);
        Ball { center, radius: 0.0, exponent: -64 }.normal()
    }

    /// A double with the sign of the value, or `None` if the ball contains zero and other numbers.
    #[inline(always)]
    #[must_use]
    pub fn certain(self) -> Option<f64> {
        (self.center.abs() > self.radius || self.radius == 0.0).then_some(self.center)
    }

    /// The comparison of the value with zero, or `None` if the ball leaves it open.
    #[must_use]
    pub fn cmp0(self) -> Option<Ordering> {
        self.certain().and_then(|center| center.partial_cmp(&0.0))
    }

    /// The same ball, normalized so that max(|center|, radius) is in [1, 2).
    #[inline(always)]
    fn normal(self) -> Ball {
        // Neither is NaN, so this is the maximum.
        let center = self.center.abs();
        let magnitude = if center > self.radius { center } else { self.radius };
        if magnitude == 0.0 {
            return Ball { center: 0.0, radius: 0.0, exponent: LOWEST };
        }
        // The magnitude is a normal number, so its exponent field holds the exponent.
        let shift = field(magnitude) - 1023;
        let scale = power_of_two(-shift);
        let exponent = self.exponent + shift;
        assert!(exponent.abs() < -LOWEST, "the exponent of a ball is below 2^29");
        Ball { center: self.center * scale, radius: self.radius * scale, exponent }
    }
}

impl Add for Ball {
    type Output = Ball;

    #[inline(always)]
    fn add(self, other: Ball) -> Ball {
        // Both are scaled, one of them by 1: a branch would be hard to predict.
        let apart = self.exponent - other.exponent;
        let [mine, yours] = [(-apart).max(0), apart.max(0)].map(|below| power_of_two(-below.min(REACH)));
        let center = self.center * mine + other.center * yours;
        let radius = (self.radius * mine + other.radius * yours + center.abs() * UNIT_ROUNDOFF) * ROOM;
        Ball { center, radius, exponent: self.exponent.max(other.exponent) }.normal()
    }
}

impl Sub for Ball {
    type Output = Ball;

    #[inline(always)]
    fn sub(self, other: Ball) -> Ball {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Ball;

    #[inline(always)]
    fn mul(self, other: Ball) -> Ball {
        let center = self.center * other.center;
        let radius = (self.center.abs() * other.radius
            + other.center.abs() * self.radius
            + self.radius * other.radius
            + center.abs() * UNIT_ROUNDOFF)
            * ROOM;
        Ball { center, radius, exponent: self.exponent + other.exponent }.normal()
    }
}

impl Neg for Ball {
    type Output = Ball;

    #[inline(always)]
    fn neg(self) -> Ball {
        Ball { center: -self.center, ..self }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;
    use crate::rational;

    /// The exact error |v·2^−e − m|.
    fn error(ball: Ball, value: &Rational) -> Rational {
        let exponent = if ball.exponent == LOWEST { 0 } else { ball.exponent };
        (Rational::from(value >> exponent) - rational(ball.center).unwrap()).abs()
    }

    fn holds(ball: Ball, value: &Rational) -> bool {
        let magnitude = ball.center.abs().max(ball.radius);
        let normal = (1.0..2.0).contains(&magnitude) || (magnitude == 0.0 && ball.exponent == LOWEST);
        normal && error(ball, value) <= rational(ball.radius).unwrap()
    }

    fn finite() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
            (any::<f32>(), -900..900)
                .prop_map(|(x, e)| f64::from(x % 64.0) * 2f64.powi(e))
                .prop_filter("finite", |x| x.is_finite()),
            -1.0..1.0f64,
            Just(0.0),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

        /// Every intermediate of random straight-line programs is within its ball.
        #[test]
        fn balls_hold_their_values(x in proptest::collection::vec(finite(), 2..6), steps in proptest::collection::vec((0..3, any::<[prop::sample::Index; 2]>()), 1..10)) {
            let mut numbers: Vec<(Ball, Rational)> = x.iter().map(|&x| (Ball::new(x), rational(x).unwrap())).collect();
            let [first, second] = [rational(x[0]).unwrap(), rational(x[1]).unwrap()];
            numbers.push((Ball::difference(x[0], x[1]), first - second));
            prop_assert!(numbers.iter().all(|(ball, value)| holds(*ball, value)));
            for (operation, [i, j]) in steps {
                let ((a, p), (b, q)) = (i.get(&numbers), j.get(&numbers));
                let (ball, value) = match operation {
                    0 => (*a + *b, Rational::from(p + q)),
                    1 => (*a - *b, Rational::from(p - q)),
                    _ => (*a * *b, Rational::from(p * q)),
                };
                prop_assert!(holds(ball, &value), "{ball:?} without {value}");
                if value.numer().significant_bits() < 20_000 && value.denom().significant_bits() < 20_000 {
                    numbers.push((ball, value));
                }
            }
        }
    }

    /// A ball with a radius of any size relative to its center.
    fn ball() -> impl Strategy<Value = Ball> {
        (-2.0..2.0f64, 0.0..2.0f64, prop_oneof![Just(0), -60..0i32], -40..40i32).prop_map(
            |(center, radius, below, exponent)| Ball { center, radius: radius * 2f64.powi(below), exponent }.normal(),
        )
    }

    /// The ends of a ball: center minus and plus radius, in units of 1.
    fn ends(ball: Ball) -> [Rational; 2] {
        let [center, radius] = [ball.center, ball.radius].map(|x| rational(x).unwrap());
        let exponent = if ball.exponent == LOWEST { 0 } else { ball.exponent };
        [Rational::from(&center - &radius) << exponent, (center + radius) << exponent]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

        /// Sums and products of balls contain the results of all their numbers, including the ends.
        ///
        /// The result is wider by at most 40u of the center and of the radius.
        #[test]
        fn balls_hold_the_results_of_all_their_numbers(a in ball(), b in ball()) {
            let room = rational(40.0 * UNIT_ROUNDOFF).unwrap();
            let sum = |x: &Rational, y: &Rational| Rational::from(x + y);
            let product = |x: &Rational, y: &Rational| Rational::from(x * y);
            for (ball, of) in [(a + b, &sum as &dyn Fn(&Rational, &Rational) -> Rational), (a * b, &product)] {
                let [[p, q], [r, s]] = [ends(a), ends(b)];
                let results = [of(&p, &r), of(&p, &s), of(&q, &r), of(&q, &s)];
                prop_assert!(results.iter().all(|result| holds(ball, result)), "{a:?}, {b:?}: {ball:?}");
                let exponent = if ball.exponent == LOWEST { 0 } else { ball.exponent };
                let furthest = results.iter().map(|result| error(ball, result)).max().unwrap();
                let more = room.clone() * (Rational::from(1) + &furthest);
                prop_assert!(rational(ball.radius).unwrap() <= furthest + more, "{ball:?} by 2^{exponent}");
            }
        }
    }

    /// The bound is tight: the test above would detect an omitted error term, or an error term that is 2% too small.
    #[test]
    fn the_bound_is_reached() {
        let ratio = |ball: Ball, value: Rational| (error(ball, &value) / rational(ball.radius).unwrap()).to_f64();
        let mut worst = [0f64; 4];
        for k in 1..2000u32 {
            // x·y and x + z are about half an ulp from a double near 1.
            let x = 1.0 + f64::from(65_536 + k) * f64::EPSILON;
            let y = 1.0 + f64::from(32_768 - k % 7) * 2f64.powi(-32);
            let z = 2f64.powi(-40) + f64::from((1 << 19) - k) * 2f64.powi(-72);
            let [p, q] = [x, y].map(|x| rational(x).unwrap());
            let product = Ball::new(x) * Ball::new(y);
            worst[0] = worst[0].max(ratio(product, Rational::from(&p * &q)));
            let sum = Ball::new(x) + Ball::new(z);
            worst[1] = worst[1].max(ratio(sum, Rational::from(&p + &rational(z).unwrap())));
            // An inherited radius: the rest of a product after cancellation.
            let left = product - Ball::new(x * y);
            let rounded = Ball::difference(x, -z);
            worst[3] = worst[3].max(ratio(rounded, Rational::from(&p + &rational(z).unwrap())));
            worst[2] = worst[2].max(ratio(left, Rational::from(&p * &q) - rational(x * y).unwrap()));
        }
        assert!(worst.iter().all(|&ratio| (0.98..=1.0).contains(&ratio)), "{worst:?}");
    }

    #[test]
    fn the_least_and_the_largest() {
        let [least, largest] = [5e-324, f64::MAX].map(Ball::new);
        assert_eq!((least * least * least).cmp0(), Some(Ordering::Greater));
        assert_eq!((least - largest * largest).cmp0(), Some(Ordering::Less));
        assert_eq!((largest - largest).cmp0(), Some(Ordering::Equal));
        assert_eq!((largest - largest + least).cmp0(), Some(Ordering::Greater));
        // Beyond the reach, the lower summand is not known to be zero.
        assert_eq!((largest + least - largest).cmp0(), None);
    }
}
