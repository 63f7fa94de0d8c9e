//! The rungs of the ladder above the filters, and the plan that a session makes when a query first climbs to them.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{Arithmetic, Fixed, Plan};
use predicament_predicates::{Axis, Plane, Sign, Vertex};

use crate::alone::SLACK_IS_LESS;
use crate::common_unit::{self, Short};
use crate::differences::Rows;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::scene_integers::{Integers, scaled};
use crate::stage;

/// The consequences of a plan for one predicate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prepared {
    /// The bound of the static filter.
    ///
    /// Zero if doubles make no error; NaN, with which no filter ever answers, if filters are not allowed.
    pub static_bound: f64,
    /// The stage that counts queries settled by the static bound.
    pub static_stage: usize,
    /// The bound of the semi-static filter, or NaN.
    pub semi_static_bound: f64,
    /// True if a query that a filter has left open has a small determinant and needs fewer limbs.
    leaves_little: bool,
    /// The limbs for a query that a filter has left open, in integers of the scene's unit.
    limbs: usize,
    /// The scale that makes every coordinate along these axes an integer less than 2^63 in magnitude.
    ///
    /// Differences then have one limb. Zero if there is no such power of two.
    pub scale: f64,
    /// The exponent of a unit in which differences have two limbs at most.
    ///
    /// Every coordinate is a multiple of two to this power.
    two_limbs: Option<i32>,
}

impl Prepared {
    pub fn new<P: Predicate<D, N>, const D: usize, const N: usize>(plan: &Plan<D>) -> Prepared {
        Prepared::after::<P, D, N>(plan, true)
    }

    /// The consequences for queries that the query's own filter `has_left` open, or for all queries.
    pub fn after<P: Predicate<D, N>, const D: usize, const N: usize>(plan: &Plan<D>, has_left: bool) -> Prepared {
        let form = P::DETERMINANT.form;
        let (arithmetic, allows_filters) = (plan.arithmetic(form), plan.allows_filters(form));
        let (static_bound, semi_static_bound, static_stage) = if arithmetic == Arithmetic::Double {
            (0.0, 0.0, stage::DOUBLE)
        } else if allows_filters {
            (P::static_bound(plan.axes().map(|axis| axis.extent())), P::DETERMINANT.bound, stage::STATIC)
        } else {
            (f64::NAN, f64::NAN, stage::STATIC)
        };
        let leaves_little = has_left && allows_filters && form.degree * plan.lowest() >= SLACK_IS_LESS;
        let determinant = P::DETERMINANT;
        let limbs =
            if leaves_little { determinant.limbs_left_open(plan.bits()) } else { determinant.limbs(plan.bits()) };
        let two_limbs = (arithmetic <= Arithmetic::WideInteger).then(|| plan.lowest());
        let scale = if arithmetic <= Arithmetic::Integer { plan.scale().unwrap_or(0.0) } else { 0.0 };
        Prepared { static_bound, static_stage, semi_static_bound, leaves_little, limbs, scale, two_limbs }
    }

    /// Returns true if doubles make no error.
    #[inline(always)]
    pub fn is_double(&self) -> bool {
        self.static_stage == stage::DOUBLE
    }

    /// The sign of a query that a filter has left open.
    ///
    /// `points` are those of the vertices, seen along these axes of the integers.
    #[inline(always)]
    pub fn exactly<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: &[[f64; D]; N],
        integers: (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> (Sign, usize) {
        if self.is_double() {
            return (Sign::of(P::estimate(*points).determinant), stage::DOUBLE);
        }
        if self.scale != 0.0 {
            return (P::integer(scaled(points, self.scale), self.limbs), stage::INTEGER);
        }
        let (integers, axes, vertices) = integers;
        if let Some(rows) = integers.of_scene(axes, vertices) {
            return (P::integer(rows, self.limbs), stage::INTEGER);
        }
        // (Differences that are doubles are those of integers.)
        if let Some(sign) = P::products(*points) {
            return (sign, stage::INTEGER);
        }
        if let Some(Short { rows, bits, .. }) = common_unit::rows(points) {
            return (P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER);
        }
        self.rest::<P, D, N>(points)
    }

    /// The sign of a query by the stages up to `last`, in their order; `None` if they leave it open.
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

    /// The sign of a query that both filters have left open, by the exact stages up to `last`.
    #[inline(never)]
    fn exactly_to<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        points: &[[f64; D]; N],
        (integers, axes, vertices): (&Integers<E>, [usize; D], [Vertex; N]),
        last: usize,
    ) -> Option<(Sign, usize)> {
        if let Some(Short { rows, bits, .. }) = common_unit::rows(points) {
            return Some((P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER));
        }
        if self.scale != 0.0 {
            return Some((P::integer(scaled(points, self.scale), self.limbs), stage::INTEGER));
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

    /// The sign of a query that fits in one limb neither in units of the scene nor in units of the query.
    ///
    /// Not inlined, so that the other rungs need no stack.
    #[inline(never)]
    fn rest<P: Predicate<D, N>, const D: usize, const N: usize>(&self, points: &[[f64; D]; N]) -> (Sign, usize) {
        let Some(lowest) = self.two_limbs else {
            let short = P::short(*points).map(|sign| (sign, stage::INTEGER));
            return short.unwrap_or_else(|| (P::dyadic(*points), stage::DYADIC));
        };
        let rows = Rows::new(points, lowest);
        match rows.shortened() {
            Some((rows, bits)) => (P::integer(rows, self.limbs_of::<P, D, N>(bits)), stage::INTEGER),
            None => (wide_integer::<P, D, N>(rows.whole(), self.limbs), stage::WIDE_INTEGER),
        }
    }

    /// The limbs for a query that the query's own filter leaves open, in integers of this many bits.
    #[inline(always)]
    fn limbs_of<P: Predicate<D, N>, const D: usize, const N: usize>(&self, bits: i32) -> usize {
        if self.leaves_little { P::DETERMINANT.limbs_left_open(bits) } else { P::DETERMINANT.limbs(bits) }
    }
}

#[inline(never)]
fn wide_integer<P: Predicate<D, N>, const D: usize, const N: usize>(rows: [[Fixed<2>; D]; N], limbs: usize) -> Sign {
    P::wide_integer(rows, limbs)
}

/// The plan of a scene of the plane.
pub(crate) struct Flat {
    pub orient2d: Prepared,
    pub incircle: Prepared,
    pub integers: Integers<2>,
}

impl Flat {
    pub fn new(points: &[[f64; 2]]) -> Flat {
        let plan = Plan::of(points);
        let incircle = Prepared::new::<Incircle, 2, 4>(&plan);
        // If doubles suffice for the predicate of the highest degree, they suffice for all.
        let integers = if incircle.is_double() { Integers::None } else { Integers::new(&plan, points) };
        Flat { orient2d: Prepared::new::<Orient2d, 2, 3>(&plan), incircle, integers }
    }
}

/// The plan of a scene of space.
pub(crate) struct Solid {
    /// The rungs of the turn in each plane: xy, yz, zx.
    pub orient2d: [Prepared; 3],
    pub orient3d: Prepared,
    pub insphere: Prepared,
    pub integers: Integers<3>,
}

impl Solid {
    pub fn new(points: &[[f64; 3]]) -> Solid {
        let plan = Plan::of(points);
        let insphere = Prepared::new::<Insphere, 3, 5>(&plan);
        let of_plane = |plane: Plane| Prepared::new::<Orient2d, 2, 3>(&plan.project(plane.axes().map(Axis::index)));
        let integers = if insphere.is_double() { Integers::None } else { Integers::new(&plan, points) };
        Solid {
            orient2d: [Plane::Xy, Plane::Yz, Plane::Zx].map(of_plane),
            orient3d: Prepared::new::<Orient3d, 3, 4>(&plan),
            insphere,
            integers,
        }
    }
}
