//! The filter for any finite doubles: its certain answers are right, also if everything underflows or overflows, and
//! its slack is needed.

use crate::common::{self, Random, nudge};
use predicament_arithmetic::bound::{INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D};
use predicament_exact::anywhere::{self, Bounded};
use predicament_exact::estimate::{self, Estimate};
use predicament_predicates::Sign;

/// A predicate with the functions under test.
struct Subject<const D: usize, const N: usize> {
    constant: f64,
    bounded: fn([[f64; D]; N]) -> Bounded,
    estimate: fn([[f64; D]; N]) -> Estimate,
    truth: fn(&[[f64; D]; N]) -> Sign,
}

const TURN: Subject<2, 3> = Subject {
    constant: ORIENT2D,
    bounded: anywhere::orient2d,
    estimate: |[a, b, c]| estimate::orient2d(a, b, c),
    truth: common::orient2d,
};
const SIDE: Subject<3, 4> = Subject {
    constant: ORIENT3D,
    bounded: anywhere::orient3d,
    estimate: |[a, b, c, d]| estimate::orient3d(a, b, c, d),
    truth: common::orient3d,
};
const CIRCLE: Subject<2, 4> = Subject {
    constant: INCIRCLE,
    bounded: anywhere::incircle,
    estimate: |[a, b, c, d]| estimate::incircle(a, b, c, d),
    truth: common::incircle,
};
const SPHERE: Subject<3, 5> = Subject {
    constant: INSPHERE,
    bounded: anywhere::insphere,
    estimate: |[a, b, c, d, e]| estimate::insphere(a, b, c, d, e),
    truth: common::insphere,
};

/// The number of queries of each kind and exponent.
fn queries() -> usize {
    usize::try_from(predicament_effort::cases(8_000)).expect("a number of cases")
}

/// The counts of some queries' results.
#[derive(Default)]
struct Seen {
    certain: usize,
    open: usize,
    /// The number of wrong signs of the filter without its slack.
    wrong_without: usize,
}

impl<const D: usize, const N: usize> Subject<D, N> {
    fn look(&self, points: [[f64; D]; N], seen: &mut Seen) {
        let bounded = (self.bounded)(points);
        let Estimate { determinant, permanent } = (self.estimate)(points);
        let without = determinant.abs() > self.constant * permanent;
        if bounded.certain().is_none() && !without {
            seen.open += 1;
            return;
        }
        let truth = (self.truth)(&points);
        match bounded.certain() {
            Some(sign) => {
                assert_eq!(sign, truth, "{points:?}");
                assert!(without, "the slack makes a bound larger: {points:?}");
                seen.certain += 1;
            }
            None => seen.open += 1,
        }
        seen.wrong_without += usize::from(without && Sign::of(determinant) != truth);
    }

    /// Small integers and points some ulps beside them, in units of this power of two.
    fn near(&self, random: &mut Random, exponent: i32) -> [[f64; D]; N] {
        let (half, rest) = (exponent / 2, exponent - exponent / 2);
        random.points(|random| {
            #[allow(clippy::cast_precision_loss)] // a small number
            let whole = random.below(8) as f64;
            let ulps = *random.pick(&[0, 0, 0, 1, -1]);
            nudge(whole, ulps) * 2f64.powi(half) * 2f64.powi(rest)
        })
    }

    fn check(&self, degree: i32) {
        let mut random = Random(71);
        let mut seen = Seen::default();
        // Exponents at which products are about as small as doubles can be, and as large.
        let (least, most) = (-1074 / degree, 1020 / degree);
        for _ in 0..queries() {
            for exponent in
                [least - 12, least - 3, least - 2, least - 1, least, least + 20, -960 / degree, 0, most - 8, most + 9]
            {
                self.look(self.near(&mut random, exponent), &mut seen);
            }
            // A separate exponent for each coordinate, of the whole range, or near an end.
            for (low, high) in [(-1074, 1023), (-1074, -900), (900, 1023), (least - 60, least + 60), (-60, 60)] {
                let points = random.points(|random| {
                    let range = usize::try_from(high - low + 1).expect("a range");
                    let exponent = low + i32::try_from(random.below(range)).expect("small");
                    let (half, rest) = (exponent / 2, exponent - exponent / 2);
                    let sign = *random.pick(&[1.0, -1.0]);
                    sign * (1.0 + random.unit()) * 2f64.powi(half) * 2f64.powi(rest)
                });
                self.look(points, &mut seen);
            }
        }
        assert!(seen.certain > queries() && seen.open > queries() / 4, "{} {}", seen.certain, seen.open);
        // (Products of two are rounded monotonically: without a slack orient2d errs by zeros, which are not certain.)
        assert_eq!(seen.wrong_without > 0, degree > 2, "without a slack");
    }
}

#[test]
fn what_is_certain_of_turns_is_right() {
    TURN.check(2);
}

#[test]
fn what_is_certain_of_sides_is_right_and_needs_the_slack() {
    SIDE.check(3);
}

#[test]
fn what_is_certain_of_circles_is_right_and_needs_the_slack() {
    CIRCLE.check(4);
}

#[test]
fn what_is_certain_of_spheres_is_right_and_needs_the_slack() {
    SPHERE.check(5);
}

#[test]
fn nothing_is_certain_of_ties_and_of_what_overflows() {
    let max = f64::MAX;
    assert_eq!(anywhere::orient2d([[0.0; 2]; 3]).certain(), None);
    assert_eq!(anywhere::orient2d([[0.1, 0.1], [0.3, 0.3], [0.2, 0.2]]).certain(), None);
    assert_eq!(anywhere::orient2d([[max, 0.0], [0.0, max], [-max, -max]]).certain(), None);
    assert_eq!(anywhere::orient3d([[max; 3], [-max, max, 0.0], [0.0, -max, 1.0], [-max; 3]]).certain(), None);
    assert_eq!(anywhere::incircle([[max, 0.0], [0.0, max], [-max, 0.0], [0.0, -max]]).certain(), None);
    assert_eq!(anywhere::insphere([[max; 3], [-max, max, 0.0], [0.0, -max, 1.0], [-max; 3], [0.0; 3]]).certain(), None);
    assert_eq!(anywhere::orient2d([[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]).certain(), Some(Sign::Positive));
}
