//! Climbing by the rounding of one determinant alone: no backend runs, so a step costs a tenth of a microsecond.
//!
//! Simulated annealing towards points at which plain doubles err as much as they can. At first the merit is the error
//! over the permanent, for determinants that are small beside it. Then the price of a nonzero determinant rises, until
//! the error carries the remaining determinant to the other side. The bound of a filter is not known here: only the
//! backend shows if it was fooled.

use predicament_corpus::Random;
use predicament_formats::bits::{power_of_two, scale, step, top_exponent};
use predicament_predicates::PredicateKind;

use super::twofold::{Points, Rounding};

/// A random number generator that is cheap enough for climbing steps (splitmix64).
struct Quick(u64);

impl Quick {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() % n as u64).unwrap_or_default()
    }

    fn exponent(&mut self, n: i32) -> i32 {
        i32::try_from(self.bits() % u64::from(n.unsigned_abs())).unwrap_or_default()
    }

    fn unit(&mut self) -> f64 {
        #[allow(clippy::cast_precision_loss)] // 53 bits
        let integer = (self.bits() >> 11) as f64;
        integer * power_of_two(-53)
    }

    /// A nearly exponentially distributed number that is the same on every machine; a logarithm would not be.
    fn patience(&mut self) -> f64 {
        std::f64::consts::LN_2 * (f64::from(self.bits().leading_zeros()) + self.unit())
    }

    /// A number of magnitude at most one half, of any size down to 2^-`bits`.
    fn small(&mut self, bits: i32) -> f64 {
        (self.unit() - 0.5) * power_of_two(-i64::from(self.exponent(bits)))
    }
}

/// The options of a climb of one determinant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Climb {
    /// The predicate.
    pub kind: PredicateKind,
    /// The number of coordinates of a point that the predicate uses.
    pub dimension: usize,
    /// The number of changes to try.
    pub steps: u32,
    /// The initial temperature, in u.
    pub temperature: f64,
}

impl Climb {
    /// Climbs from `start`; returns the points whose determinant is carried farthest to the wrong side, or most nearly
    /// there.
    pub(super) fn run(self, start: &Points, random: &mut Random) -> Points {
        let mut quick = Quick(random.integer(0, i64::MAX).cast_unsigned());
        let (mut points, mut score) = (*start, f64::NEG_INFINITY);
        let (mut best, mut height) = (*start, merit(&Rounding::of(self.kind, start)));
        let steps = f64::from(self.steps.max(1));
        for count in 0..self.steps {
            let progress = f64::from(count) / steps;
            let cooling = (1.0 - progress / 0.8).max(0.0);
            let price = price(progress);
            if count % 1024 == 0 {
                score = Rounding::of(self.kind, &points).carried(price);
            }
            let mut moved = points;
            self.change(&mut moved, &mut quick);
            if quick.below(8) == 0 {
                self.change(&mut moved, &mut quick);
            }
            let rounding = Rounding::of(self.kind, &moved);
            let reached = rounding.carried(price);
            if reached >= score - self.temperature * cooling * cooling * quick.patience() {
                (points, score) = (moved, reached);
                let merit = merit(&rounding);
                if merit > height {
                    (best, height) = (moved, merit);
                }
            }
        }
        best
    }

    fn change(self, points: &mut Points, quick: &mut Quick) {
        let (row, axis) = (quick.below(self.kind.arity()), quick.below(self.dimension));
        let (other, beside) = (quick.below(self.kind.arity()), quick.below(self.dimension));
        let x = points[row][axis];
        let changed = match quick.below(9) {
            0..=3 => jiggled(x, 40, quick),
            4 => {
                let pivot = points[other][axis];
                pivot + (x - pivot) * (1.0 + quick.small(53))
            }
            // Just beside a power of two, where half an ulp is relatively largest.
            5 => {
                let exponent = top_exponent(x).unwrap_or(0) + i64::from(quick.exponent(2));
                let size =
                    power(exponent) * (1.0 + (quick.unit() - 0.25) * power_of_two(-i64::from(quick.exponent(53))));
                size.copysign(x)
            }
            // By nearly half an ulp of another coordinate: it changes the rounding of their difference.
            6 => {
                let half = 0.5 * ulp(points[other][beside]);
                let half = if quick.below(2) == 0 { half } else { -half };
                if quick.below(2) == 0 { half * (1.0 + quick.small(30)) } else { x + half }
            }
            7 => -x,
            _ => {
                points[other][beside] = jiggled(points[other][beside], 20, quick);
                jiggled(x, 20, quick)
            }
        };
        if changed.is_finite() {
            points[row][axis] = changed;
        }
    }
}

/// The price of a nonzero determinant: nearly zero at first, so that errors can grow, and twice the determinant in the
/// end.
fn price(progress: f64) -> f64 {
    if progress < 0.5 {
        return 15.0 * f64::EPSILON / 2.0;
    }
    // From 2^-50 to 2^1, by factors of two, so that the price is the same on every machine.
    #[allow(clippy::cast_possible_truncation)] // a small number
    let doublings = ((progress - 0.5) / 0.3 * 51.0).min(51.0) as i64;
    power_of_two(doublings - 50)
}

/// The merit of a rounding: a wrong sign ranks first, then the amount.
fn merit(rounding: &Rounding) -> f64 {
    rounding.wrong().unwrap_or_else(|| rounding.carried(2.0) - 20.0)
}

fn jiggled(x: f64, bits: i32, quick: &mut Quick) -> f64 {
    let most = 1_u64 << quick.exponent(bits);
    let ulps = (quick.bits() % most).cast_signed() + 1;
    step(x, if quick.below(2) == 0 { ulps } else { -ulps })
}

fn power(exponent: i64) -> f64 {
    power_of_two(exponent.clamp(-1000, 1000))
}

/// The unit in the last place.
pub(super) fn ulp(x: f64) -> f64 {
    scale(1.0, top_exponent(x).map_or(-1074, |top| (top - 52).max(-1074)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_climb_from_small_integers_gets_near_what_rounding_can_do() {
        let mut best = 0_f64;
        for seed in 1..=6 {
            let mut random = Random::new("hunt", "climb", seed);
            let mut points = [[0.0; 3]; 5];
            for x in points.iter_mut().flatten() {
                *x = f64::from(i32::try_from(random.integer(-8, 8)).unwrap());
            }
            let climb = Climb { kind: PredicateKind::Orient2d, dimension: 2, steps: 200_000, temperature: 0.1 };
            let end = climb.run(&points, &mut random);
            best = best.max(Rounding::of(PredicateKind::Orient2d, &end).wrong().unwrap_or(0.0));
        }
        assert!(best > 1.99 && best <= 3.0, "{best} u");
    }
}
