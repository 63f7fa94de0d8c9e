//! The rungs of the ladder above the scene's static filter.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Arithmetic, Fixed, Plan, power_of_two};
use predicament_predicates::{Sign, Vertex};

use crate::integers::{Integers, Rows};
use crate::predicate::Predicate;
use crate::stage;

/// What a plan proves for one predicate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prepared {
    /// The bound of the static filter: zero where doubles make no error, NaN
    /// (with which no filter ever answers) where filters are not allowed.
    pub static_bound: f64,
    /// The stage that the static bound stands for.
    pub static_stage: usize,
    /// The bound of the semi-static filter, or NaN.
    pub semi_static_bound: f64,
    /// The limbs of what the static filter leaves open, in integers of the scene's unit.
    limbs: usize,
    /// Every coordinate is a multiple of two to this, and differences over it
    /// have two limbs at most.
    two_limbs: Option<i32>,
}

impl Prepared {
    pub fn new<P: Predicate<D, N>, const D: usize, const N: usize>(plan: &Plan<D>) -> Prepared {
        let form = P::DETERMINANT.form;
        let arithmetic = plan.arithmetic(form);
        let (static_bound, semi_static_bound, static_stage) = if arithmetic == Arithmetic::Double {
            (0.0, 0.0, stage::DOUBLE)
        } else if plan.allows_filters(form) {
            (P::static_bound(plan.axes().map(|axis| axis.extent())), P::DETERMINANT.bound, stage::STATIC)
        } else {
            (f64::NAN, f64::NAN, stage::STATIC)
        };
        let determinant = P::DETERMINANT;
        let limbs = if static_bound.is_nan() {
            determinant.limbs(plan.bits())
        } else {
            determinant.limbs_left_open(plan.bits())
        };
        let two_limbs = (arithmetic <= Arithmetic::WideInteger).then(|| plan.lowest());
        Prepared { static_bound, static_stage, semi_static_bound, limbs, two_limbs }
    }

    /// Whether doubles make no error.
    pub fn is_double(&self) -> bool {
        self.static_stage == stage::DOUBLE
    }

    /// The sign of a query whose `determinant` the static filter has found too
    /// small to be certain of, if integers of one limb are the next rung for it.
    #[inline(always)]
    pub fn next<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        determinant: f64,
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> Option<(Sign, usize)> {
        let rows = integers.of_scene(axes, vertices)?;
        let skips = P::FILTERS_PAY && self.is_small(determinant);
        (!skips).then(|| (P::integer(rows, self.limbs), stage::INTEGER))
    }

    /// The sign of a query, from the semi-static filter on; `points` are those
    /// of the vertices, seen along these axes of the integers.
    #[inline(always)]
    pub fn climb<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: &[[f64; D]; N],
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> (Sign, usize) {
        if let Some(sign) = P::estimate(*points).certain(self.semi_static_bound) {
            return (sign, stage::SEMI_STATIC);
        }
        if let Some((rows, bits)) = integers.of_query(points, vertices) {
            return (P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER);
        }
        if let Some(rows) = integers.of_scene(axes, vertices) {
            return (P::integer(rows, self.limbs), stage::INTEGER);
        }
        self.rest::<P, D, N>(points)
    }

    /// The sign of a query by the stages up to `last`, in their order; none where they leave it open.
    #[inline(always)]
    pub fn decide_to<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: &[[f64; D]; N],
        integers: (&Integers<E>, [usize; D], [Vertex; N]),
        last: usize,
    ) -> Option<(Sign, usize)> {
        let estimate = P::estimate(*points);
        if last >= self.static_stage
            && let Some(sign) = estimate.above(self.static_bound)
        {
            return Some((sign, self.static_stage));
        }
        if last >= stage::SEMI_STATIC
            && let Some(sign) = estimate.certain(self.semi_static_bound)
        {
            return Some((sign, stage::SEMI_STATIC));
        }
        if last >= stage::INTEGER { self.exactly_to::<P, D, N, E>(points, integers, last) } else { None }
    }

    /// The sign of what both filters have left open, by the exact stages up to `last`.
    #[inline(never)]
    fn exactly_to<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: &[[f64; D]; N],
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
        last: usize,
    ) -> Option<(Sign, usize)> {
        if let Some((rows, bits)) = integers.of_query(points, vertices) {
            return Some((P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER));
        }
        if let Some(rows) = integers.of_scene(axes, vertices) {
            return Some((P::integer(rows, self.limbs), stage::INTEGER));
        }
        let Some(lowest) = self.two_limbs else {
            if let Some(sign) = P::short(*points) {
                return Some((sign, stage::INTEGER));
            }
            return (last >= stage::DYADIC).then(|| (P::dyadic(*points), stage::DYADIC));
        };
        let rows = Rows::new(points, lowest);
        match rows.shortened() {
            Some((rows, bits)) => Some((P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER)),
            None if last >= stage::WIDE_INTEGER => {
                Some((wide_integer::<P, D, N>(rows.whole(), self.limbs), stage::WIDE_INTEGER))
            }
            None => None,
        }
    }

    /// What fits in one limb neither in units of the scene nor, as it is, in
    /// units of the query. (Not inlined, so that filters need no stack.)
    #[inline(never)]
    fn rest<P: Predicate<D, N>, const D: usize, const N: usize>(&self, points: &[[f64; D]; N]) -> (Sign, usize) {
        let Some(lowest) = self.two_limbs else { return alone::<P, D, N>(points) };
        let rows = Rows::new(points, lowest);
        match rows.shortened() {
            Some((rows, bits)) => (P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER),
            None => (wide_integer::<P, D, N>(rows.whole(), self.limbs), stage::WIDE_INTEGER),
        }
    }

    /// The limbs of what the semi-static filter leaves open, in integers of so many bits.
    #[inline(always)]
    fn limbs_of<P: Predicate<D, N>, const D: usize, const N: usize>(&self, bits: i32) -> usize {
        // (Where filters are not allowed, none has left it open.)
        let is_left_open = !self.semi_static_bound.is_nan();
        if is_left_open { P::DETERMINANT.limbs_left_open(bits) } else { P::DETERMINANT.limbs(bits) }
    }

    /// Whether a determinant is so small that it is more likely that of a
    /// small figure, with roundings as small, than the remains of a large one
    /// that has cancelled: those are some hundred times smaller than the bound.
    #[inline(always)]
    fn is_small(&self, determinant: f64) -> bool {
        const FRACTION: f64 = power_of_two(-20);
        (determinant.abs() < FRACTION * self.static_bound) & (determinant != 0.0)
    }
}

#[inline(never)]
fn wide_integer<P: Predicate<D, N>, const D: usize, const N: usize>(rows: [[Fixed<2>; D]; N], limbs: usize) -> Sign {
    P::wide_integer(rows, limbs)
}

/// A query of a scene that is too wide for integers.
#[inline(never)]
pub(crate) fn alone<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[f64; D]; N]) -> (Sign, usize) {
    if is_ordinary(points)
        && let Some(sign) = P::estimate(*points).certain(P::DETERMINANT.bound)
    {
        return (sign, stage::SEMI_STATIC);
    }
    if let Some(sign) = P::short(*points) {
        return (sign, stage::INTEGER);
    }
    (P::dyadic(*points), stage::DYADIC)
}

/// Whether filters are allowed, for every predicate here, without looking for the lowest bit.
///
/// Coordinates of at least 2^-141 are multiples of 2^-193, and 5·193 ≤ 969;
/// differences of coordinates up to 2^200 are at most 2^201, and
/// 5·201 + 7 ≤ 1023 (see [`Plan`]).
#[inline(always)]
fn is_ordinary<const D: usize>(points: &[[f64; D]]) -> bool {
    const LOWEST: f64 = power_of_two(-141);
    const HIGHEST: f64 = power_of_two(200);
    let ordinary = |x: f64| (x.abs() <= HIGHEST) & ((x.abs() >= LOWEST) | (x == 0.0));
    points.as_flattened().iter().fold(true, |all, &x| all & ordinary(x))
}
