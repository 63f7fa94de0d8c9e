//! What happens to a query that the scene's static filter leaves open.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Arithmetic, Fixed, Plan, Unit};
use predicament_predicates::Sign;

use crate::{integers::Rows, predicate::Predicate, stage};

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
    /// Whether differences are doubles, and integers of one limb.
    has_double_differences: bool,
    unit: Unit,
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
        Prepared {
            static_bound,
            static_stage,
            semi_static_bound,
            has_double_differences: arithmetic == Arithmetic::Integer && plan.has_exact_differences(),
            unit: plan.unit(),
        }
    }

    /// The sign of a query that the static filter leaves open; `rows` are its
    /// differences in integers, if the scene has them.
    #[inline(always)]
    pub fn climb<P: Predicate<D, N>, const D: usize, const N: usize>(
        &self,
        points: [[f64; D]; N],
        rows: impl FnOnce() -> Option<Rows<D, N>>,
    ) -> (Sign, usize) {
        if let Some(sign) = P::estimate(points).certain(self.semi_static_bound) {
            return (sign, stage::SEMI_STATIC);
        }
        if self.has_double_differences {
            return (self.integer::<P, D, N>(points), stage::INTEGER);
        }
        rest::<P, D, N>(points, rows)
    }

    #[inline(always)]
    fn integer<P: Predicate<D, N>, const D: usize, const N: usize>(&self, points: [[f64; D]; N]) -> Sign {
        let mut rows = [[Fixed::ZERO; D]; N];
        for row in 0..N - 1 {
            for axis in 0..D {
                let difference = points[row][axis] - points[N - 1][axis];
                rows[row][axis] = Fixed::<1>::from_double(self.unit.scale(difference));
            }
        }
        P::integer(rows)
    }
}

/// What no filter settles. (Not inlined, so that filters need no stack.)
#[inline(never)]
fn rest<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: [[f64; D]; N],
    rows: impl FnOnce() -> Option<Rows<D, N>>,
) -> (Sign, usize) {
    let Some(rows) = rows() else { return alone::<P, D, N>(points) };
    if let Some(rows) = rows.short() {
        return (P::integer(rows), stage::INTEGER);
    }
    if P::TRIES_ONE_LIMB
        && let Some(rows) = rows.shortened()
    {
        return (P::integer(rows), stage::INTEGER);
    }
    (wide_integer::<P, D, N>(&rows), stage::WIDE_INTEGER)
}

#[inline(never)]
fn wide_integer<P: Predicate<D, N>, const D: usize, const N: usize>(rows: &Rows<D, N>) -> Sign {
    P::wide_integer(rows.long())
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
