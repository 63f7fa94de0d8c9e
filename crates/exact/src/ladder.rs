//! What happens to a query that the scene's static filter leaves open.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Arithmetic, Fixed, Plan};
use predicament_predicates::{Sign, Vertex};

use crate::integers::Integers;
use crate::predicate::{ALL, Predicate};
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
}

impl Prepared {
    pub fn new<P: Predicate<D, N>, const D: usize, const N: usize>(plan: &Plan<D>) -> Prepared {
        let form = P::DETERMINANT.form;
        let (static_bound, semi_static_bound, static_stage) = if plan.arithmetic(form) == Arithmetic::Double {
            (0.0, 0.0, stage::DOUBLE)
        } else if plan.allows_filters(form) {
            (P::static_bound(plan.axes().map(|axis| axis.extent())), P::DETERMINANT.bound, stage::STATIC)
        } else {
            (f64::NAN, f64::NAN, stage::STATIC)
        };
        let limbs = if static_bound.is_nan() { ALL } else { P::DETERMINANT.limbs(plan.bits()) };
        Prepared { static_bound, static_stage, semi_static_bound, limbs }
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
        let rows = integers.short(axes, vertices)?;
        let skips = P::FILTERS_PAY && self.is_small(determinant);
        (!skips).then(|| (P::integer(rows, self.limbs), stage::INTEGER))
    }

    /// The sign of a query, from the semi-static filter on; `points` are those
    /// of the vertices, seen along these axes of the integers.
    #[inline(always)]
    pub fn climb<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: [[f64; D]; N],
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> (Sign, usize) {
        if let Some(sign) = P::estimate(points).certain(self.semi_static_bound) {
            return (sign, stage::SEMI_STATIC);
        }
        match integers.short(axes, vertices) {
            Some(rows) => (P::integer(rows, self.limbs), stage::INTEGER),
            None => self.rest::<P, D, N, E>(points, (integers, axes, vertices)),
        }
    }

    /// What no filter settles, in a scene without integers of one limb. (Not
    /// inlined, so that filters need no stack.)
    #[inline(never)]
    pub fn rest<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: [[f64; D]; N],
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> (Sign, usize) {
        let Some(rows) = integers.long(axes, vertices) else { return alone::<P, D, N>(points) };
        if P::TRIES_ONE_LIMB
            && let Some((rows, bits)) = rows.shortened()
        {
            // (Where filters are not allowed, none has left this open.)
            let limbs = if self.limbs == ALL { ALL } else { P::DETERMINANT.limbs(bits) };
            return (P::integer(rows, limbs), stage::INTEGER);
        }
        (wide_integer::<P, D, N>(rows.whole(), self.limbs), stage::WIDE_INTEGER)
    }

    /// Whether a determinant is so small that it is more likely that of a
    /// small figure, with roundings as small, than the remains of a large one
    /// that has cancelled: those are some hundred times smaller than the bound.
    #[inline(always)]
    fn is_small(&self, determinant: f64) -> bool {
        const FRACTION: f64 = power(-20);
        (determinant.abs() < FRACTION * self.static_bound) & (determinant != 0.0)
    }
}

#[inline(never)]
fn wide_integer<P: Predicate<D, N>, const D: usize, const N: usize>(rows: [[Fixed<2>; D]; N], limbs: usize) -> Sign {
    P::wide_integer(rows, limbs)
}

/// A query of a scene that is too wide for integers.
#[inline(never)]
pub(crate) fn alone<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[f64; D]; N]) -> (Sign, usize) {
    if is_ordinary(&points)
        && let Some(sign) = P::estimate(points).certain(P::DETERMINANT.bound)
    {
        return (sign, stage::SEMI_STATIC);
    }
    if let Some(sign) = P::short(points) {
        return (sign, stage::INTEGER);
    }
    (P::dyadic(points), stage::DYADIC)
}

/// Whether filters are allowed, for every predicate here, without looking for the lowest bit.
///
/// Coordinates of at least 2^-141 are multiples of 2^-193, and 5·193 ≤ 969;
/// differences of coordinates up to 2^200 are at most 2^201, and
/// 5·201 + 7 ≤ 1023 (see [`Plan`]).
#[inline(always)]
fn is_ordinary<const D: usize>(points: &[[f64; D]]) -> bool {
    const LOWEST: f64 = power(-141);
    const HIGHEST: f64 = power(200);
    let ordinary = |x: f64| (x.abs() <= HIGHEST) & ((x.abs() >= LOWEST) | (x == 0.0));
    points.as_flattened().iter().fold(true, |all, &x| all & ordinary(x))
}

/// 2^`exponent`, a normal double.
pub(crate) const fn power(exponent: i64) -> f64 {
    f64::from_bits((exponent + 1023).cast_unsigned() << 52)
}
