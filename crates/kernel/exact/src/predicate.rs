//! The interface of a determinant predicate to the ladder.
//!
//! The four predicates differ only in their formulas, not in the ladder, so the ladder is written once, generic over
//! this trait.

use predicament_arithmetic::Sign;
use predicament_arithmetic::{Fixed, bound, short_rows};
#[cfg(feature = "scenes")]
use predicament_predicates::PredicateKind;

use crate::anywhere::{self, Bounded};
use crate::determinant::{self, Determinant};
use crate::estimate::{self, Estimate};
use crate::{dyadic, products};

/// A predicate on `N` points of `D` coordinates.
pub trait Predicate<const D: usize, const N: usize> {
    /// The kind of the predicate.
    #[cfg(feature = "scenes")]
    const KIND: PredicateKind;
    /// The determinant as a polynomial.
    const DETERMINANT: Determinant;

    /// The bound of the static filter, from the extents of the scene's axes.
    fn static_bound(extent: [f64; D]) -> f64;

    /// The estimate in plain floating point.
    fn estimate(points: [[f64; D]; N]) -> Estimate;

    /// The determinant in plain floating point, with the magnitude from which on the sign is certain.
    ///
    /// The bound holds whatever underflows or overflows.
    fn anywhere(points: [[f64; D]; N]) -> Bounded;

    /// The sign in integers of this many limbs.
    ///
    /// The rows are the differences to the last point, and the last row is zero.
    fn integer(rows: [[Fixed<1>; D]; N], limbs: usize) -> Sign;

    /// The sign in integers, with differences of two limbs.
    fn wide_integer(rows: [[Fixed<2>; D]; N], limbs: usize) -> Sign;

    /// The sign for points whose differences span few bits; `None` otherwise.
    #[inline(always)]
    fn short(points: [[f64; D]; N]) -> Option<Sign> {
        short_rows(points).map(|rows| Self::integer(rows, Self::DETERMINANT.limbs(determinant::BITS[0])))
    }

    /// The sign in floating point for points whose differences are doubles; `None` otherwise, or if there is no such
    /// method.
    #[inline(always)]
    fn products(_: [[f64; D]; N]) -> Option<Sign> {
        None
    }

    /// The sign for any finite points.
    fn dyadic(points: [[f64; D]; N]) -> Sign;
}

/// The turn of three points.
pub struct Orient2d;

impl Predicate<2, 3> for Orient2d {
    #[cfg(feature = "scenes")]
    const KIND: PredicateKind = PredicateKind::Orient2d;
    const DETERMINANT: Determinant = determinant::ORIENT2D;

    fn static_bound(extent: [f64; 2]) -> f64 {
        bound::static_orient2d(extent)
    }
    #[inline(always)]
    fn estimate([a, b, c]: [[f64; 2]; 3]) -> Estimate {
        estimate::orient2d(a, b, c)
    }
    #[inline(always)]
    fn anywhere(points: [[f64; 2]; 3]) -> Bounded {
        anywhere::orient2d(points)
    }
    #[inline(always)]
    fn integer([a, b, _]: [[Fixed<1>; 2]; 3], _: usize) -> Sign {
        determinant::orient2d::<1, 2>([a, b])
    }
    #[inline(always)]
    fn wide_integer([a, b, _]: [[Fixed<2>; 2]; 3], limbs: usize) -> Sign {
        match limbs {
            ..=2 => determinant::orient2d::<2, 2>([a, b]),
            3 => determinant::orient2d::<2, 3>([a, b]),
            _ => determinant::orient2d::<2, 4>([a, b]),
        }
    }
    #[inline(always)]
    fn short(points: [[f64; 2]; 3]) -> Option<Sign> {
        products::orient2d(points)
    }
    #[inline(always)]
    fn products(points: [[f64; 2]; 3]) -> Option<Sign> {
        products::turn(points)
    }
    fn dyadic([a, b, c]: [[f64; 2]; 3]) -> Sign {
        dyadic::orient2d(a, b, c)
    }
}

/// The side of a point on a plane.
pub struct Orient3d;

impl Predicate<3, 4> for Orient3d {
    #[cfg(feature = "scenes")]
    const KIND: PredicateKind = PredicateKind::Orient3d;
    const DETERMINANT: Determinant = determinant::ORIENT3D;

    fn static_bound(extent: [f64; 3]) -> f64 {
        bound::static_orient3d(extent)
    }
    #[inline(always)]
    fn estimate([a, b, c, d]: [[f64; 3]; 4]) -> Estimate {
        estimate::orient3d(a, b, c, d)
    }
    #[inline(always)]
    fn anywhere(points: [[f64; 3]; 4]) -> Bounded {
        anywhere::orient3d(points)
    }
    #[inline(always)]
    fn integer([a, b, c, _]: [[Fixed<1>; 3]; 4], limbs: usize) -> Sign {
        match limbs {
            ..=2 => determinant::orient3d::<1, 2, 2>([a, b, c]),
            _ => determinant::orient3d::<1, 2, 3>([a, b, c]),
        }
    }
    #[inline(always)]
    fn wide_integer([a, b, c, _]: [[Fixed<2>; 3]; 4], _: usize) -> Sign {
        determinant::orient3d::<2, 4, 6>([a, b, c])
    }
    fn dyadic([a, b, c, d]: [[f64; 3]; 4]) -> Sign {
        dyadic::orient3d(a, b, c, d)
    }
}

/// The position of a point relative to a circle.
pub struct Incircle;

impl Predicate<2, 4> for Incircle {
    #[cfg(feature = "scenes")]
    const KIND: PredicateKind = PredicateKind::Incircle;
    const DETERMINANT: Determinant = determinant::INCIRCLE;

    fn static_bound(extent: [f64; 2]) -> f64 {
        bound::static_incircle(extent)
    }
    #[inline(always)]
    fn estimate([a, b, c, d]: [[f64; 2]; 4]) -> Estimate {
        estimate::incircle(a, b, c, d)
    }
    #[inline(always)]
    fn anywhere(points: [[f64; 2]; 4]) -> Bounded {
        anywhere::incircle(points)
    }
    #[inline(always)]
    fn integer([a, b, c, _]: [[Fixed<1>; 2]; 4], limbs: usize) -> Sign {
        match limbs {
            ..=2 => determinant::incircle::<1, 2, 2>([a, b, c]),
            3 => determinant::incircle::<1, 2, 3>([a, b, c]),
            _ => determinant::incircle::<1, 2, 4>([a, b, c]),
        }
    }
    #[inline(always)]
    fn wide_integer([a, b, c, _]: [[Fixed<2>; 2]; 4], _: usize) -> Sign {
        determinant::incircle::<2, 4, 8>([a, b, c])
    }
    fn dyadic([a, b, c, d]: [[f64; 2]; 4]) -> Sign {
        dyadic::incircle(a, b, c, d)
    }
}

/// The position of a point relative to a sphere.
pub struct Insphere;

impl Predicate<3, 5> for Insphere {
    #[cfg(feature = "scenes")]
    const KIND: PredicateKind = PredicateKind::Insphere;
    const DETERMINANT: Determinant = determinant::INSPHERE;

    fn static_bound(extent: [f64; 3]) -> f64 {
        bound::static_insphere(extent)
    }
    #[inline(always)]
    fn estimate([a, b, c, d, e]: [[f64; 3]; 5]) -> Estimate {
        estimate::insphere(a, b, c, d, e)
    }
    #[inline(always)]
    fn anywhere(points: [[f64; 3]; 5]) -> Bounded {
        anywhere::insphere(points)
    }
    #[inline(always)]
    fn integer([a, b, c, d, _]: [[Fixed<1>; 3]; 5], limbs: usize) -> Sign {
        match limbs {
            ..=2 => determinant::insphere::<1, 2, 2, 2>([a, b, c, d]),
            3 => determinant::insphere::<1, 2, 3, 3>([a, b, c, d]),
            4 => determinant::insphere::<1, 2, 3, 4>([a, b, c, d]),
            _ => determinant::insphere::<1, 2, 3, 5>([a, b, c, d]),
        }
    }
    #[inline(always)]
    fn wide_integer([a, b, c, d, _]: [[Fixed<2>; 3]; 5], _: usize) -> Sign {
        determinant::insphere::<2, 4, 6, 10>([a, b, c, d])
    }
    fn dyadic([a, b, c, d, e]: [[f64; 3]; 5]) -> Sign {
        dyadic::insphere(a, b, c, d, e)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differences::Rows;
    use crate::rational;
    use crate::scene_integers::scaled;

    /// A small generator for reproducible samples (splitmix64).
    struct Random(u64);

    impl Random {
        fn below(&mut self, bound: u64) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut x = self.0;
            x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
            (x ^ x >> 31) % bound
        }

        /// A random integer of at most `bits` bits in magnitude, often with the maximum length or with few bits.
        fn coordinate(&mut self, bits: i32) -> f64 {
            let most = 2f64.powi(bits) - 2f64.powi((bits - 53).max(0));
            let magnitude = match self.below(4) {
                0 => most,
                1 => f64::from(u32::try_from(self.below(3)).unwrap()),
                // Up to 31 digits, at the upper end.
                _ => {
                    let digits = bits.min(31);
                    let number = u32::try_from(self.below(1 << digits)).unwrap();
                    f64::from(number) * 2f64.powi(bits - digits)
                }
            };
            if self.below(2) == 0 { -magnitude.min(most) } else { magnitude.min(most) }
        }
    }

    /// Compares every method of a predicate with the exact value; returns the numbers of ties and of answers by
    /// `short`.
    fn check<P: Predicate<D, N>, const D: usize, const N: usize>(
        truth: impl Fn([[f64; D]; N]) -> Sign,
        most_limbs: usize,
    ) -> [usize; 2] {
        let (mut random, mut ties, mut short) = (Random(D as u64 * 10 + N as u64), 0, 0);
        for bits in (2..=61).chain([2; 60]) {
            for _ in 0..20 {
                let points: [[f64; D]; N] = [[0.0; D]; N].map(|point| point.map(|_| random.coordinate(bits)));
                let sign = truth(points);
                ties += usize::from(sign.is_zero());
                let context = || format!("{:?} of {points:?}, {bits} bits", P::KIND);
                assert_eq!(P::dyadic(points), sign, "{}", context());
                for limbs in P::DETERMINANT.limbs(bits + 1)..=most_limbs {
                    assert_eq!(P::integer(scaled(&points, 1.0), limbs), sign, "{limbs} limbs: {}", context());
                }
                for limbs in P::DETERMINANT.limbs(bits + 1)..=2 * most_limbs {
                    assert_eq!(P::wide_integer(Rows::new(&points, 0).whole(), limbs), sign, "wide: {}", context());
                }
                assert!(P::short(points).is_none_or(|short| short == sign), "short: {}", context());
                assert!(P::products(points).is_none_or(|products| products == sign), "products: {}", context());
                short += usize::from(P::short(points).is_some());
                assert!(bits > 20 || P::short(points).is_some(), "{}", context());
                let estimate = P::estimate(points);
                assert!(bits > 9 || Sign::of(estimate.determinant) == sign, "without an error: {}", context());
            }
        }
        for bits in 62..=125 {
            let points: [[f64; D]; N] = [[0.0; D]; N].map(|point| point.map(|_| random.coordinate(bits)));
            let sign = truth(points);
            for limbs in P::DETERMINANT.limbs(bits + 1)..=2 * most_limbs {
                let rows = Rows::new(&points, 0).whole();
                assert_eq!(P::wide_integer(rows, limbs), sign, "{limbs} limbs of {points:?}, {bits} bits");
            }
        }
        [ties, short]
    }

    #[test]
    fn every_way_of_a_predicate_has_its_sign() {
        let seen = [
            check::<Orient2d, 2, 3>(|[a, b, c]| rational::orient2d(a, b, c).sign(), 2),
            check::<Orient3d, 3, 4>(|[a, b, c, d]| rational::orient3d(a, b, c, d).sign(), 3),
            check::<Incircle, 2, 4>(|[a, b, c, d]| rational::incircle(a, b, c, d).sign(), 4),
            check::<Insphere, 3, 5>(|[a, b, c, d, e]| rational::insphere(a, b, c, d, e).sign(), 5),
        ];
        assert!(seen.iter().all(|[ties, short]| *ties > 20 && *short > 1200), "{seen:?}");
    }
}
