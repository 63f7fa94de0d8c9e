//! The data of a session before any query: the bounds of the static filters, from one pass over the points.
//!
//! A static bound is computed from the extents of the scene's axes ([`bound`](predicament_arithmetic::bound)). It holds
//! if nothing underflows or overflows. To prove that, a [`Plan`](predicament_arithmetic::Plan) finds the lowest bit of
//! all coordinates, which costs several times as much as extents do. Extents alone prove it if each of them is zero or
//! from 2⁻¹⁴⁰ to 2²⁰⁰:
//!
//! * Nothing overflows: 5·200 + 7 ≤ 1023.
//! * A product that underflows is off by 2⁻¹⁰⁷⁵ at most, instead of by a relative u. Its later factors are entries
//!   within their extents. With E the product of a term's extents, the error is at most 2⁻¹⁰⁷⁵·E/F with F a product of
//!   at least two extents, F ≥ 2⁻²⁸⁰ (with a lift, F ≥ 2⁻⁷⁰⁰). A hundred such errors are less than 2⁻³⁰⁰·E, negligible
//!   beside the 2⁻⁵⁰·u·E by which [`MARGIN`] exceeds the need of roundings.
//! * If an extent is zero, all differences along it are, and every product of every term has a factor of zero: the
//!   determinant is exactly zero in doubles, and so is the bound.
//!
//! Otherwise there are no static bounds: queries use their own filters.

use predicament_arithmetic::{difference_up, power_of_two};

use crate::predicate::Predicate;

/// The least nonzero extent for which filters are proved.
const LOWEST: f64 = power_of_two(-140);
const HIGHEST: f64 = power_of_two(200);
/// The factor that covers underflow: 2⁻⁵⁰ of the bound.
const MARGIN: f64 = 1.0 + 4.0 * f64::EPSILON;

/// The extent of the points along each axis, rounded up.
pub(crate) fn extents<const D: usize>(points: &[[f64; D]]) -> [f64; D] {
    // Four points at a time, so that no minimum waits for the previous one.
    let mut low = [[f64::INFINITY; D]; 4];
    let mut high = [[f64::NEG_INFINITY; D]; 4];
    let mut widen = |lane: usize, point: &[f64; D]| {
        for axis in 0..D {
            let x = point[axis];
            low[lane][axis] = if x < low[lane][axis] { x } else { low[lane][axis] };
            high[lane][axis] = if x > high[lane][axis] { x } else { high[lane][axis] };
        }
    };
    let (fours, rest) = points.as_chunks::<4>();
    // (Without points, the lowest is above the highest.)
    for four in fours {
        four.iter().enumerate().for_each(|(lane, point)| widen(lane, point));
    }
    rest.iter().for_each(|point| widen(0, point));
    core::array::from_fn(|axis| {
        let min = |x: f64, y: f64| if x < y { x } else { y };
        let max = |x: f64, y: f64| if x > y { x } else { y };
        let least = min(min(low[0][axis], low[1][axis]), min(low[2][axis], low[3][axis]));
        let most = max(max(high[0][axis], high[1][axis]), max(high[2][axis], high[3][axis]));
        if most < least { 0.0 } else { difference_up(most, least) }
    })
}

/// The static bound of a determinant, if extents prove it; else NaN.
pub(crate) fn bound<const D: usize>(extent: [f64; D], of: impl Fn([f64; D]) -> f64) -> f64 {
    let is_safe = extent.iter().all(|x| *x == 0.0 || (LOWEST..=HIGHEST).contains(x));
    if is_safe { of(extent) * MARGIN } else { f64::NAN }
}

/// The bound for determinants that are expanded along one line or plane ([`side`](crate::side)), with a margin for
/// underflow.
///
/// Extents are at most 2²⁰⁰. A minor of the normal is off by 2⁻¹⁰⁷⁴ and multiplied with an extent, and each product is
/// off by 2⁻¹⁰⁷⁵: together less than 2⁻⁸⁷⁰. Let b be the bound without the margin. If b ≤ 2⁻⁸¹⁰, adding 2⁻⁸⁶⁰ and
/// rounding makes it larger by 2⁻⁸⁶¹ at least. Otherwise 2⁻⁸⁷⁰ is less than 2⁻⁶⁰·b, which [`MARGIN`] covers.
pub(crate) fn beside(bound: f64) -> f64 {
    const SLACK: f64 = power_of_two(-860);
    bound * MARGIN + SLACK
}

/// The filter that a predicate runs first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum First {
    /// The static filter, with the scene's bound.
    Scene,
    /// The query's own filter: the scene has no bound, or one that is too large for most of its figures.
    Query,
}

/// The least number of points for which sampling pays off.
const LOOKED_AT_FROM: usize = 1 << 11;
/// The number of sampled queries.
const LOOKS: usize = 24;

/// The filter that decides most queries of these points, estimated from a sample.
///
/// It only chooses an order: any order gives the same signs. The result depends only on the points.
pub(crate) fn choose<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: &[[f64; D]],
    static_bound: f64,
) -> First {
    if static_bound.is_nan() {
        return First::Query;
    }
    if points.len() < LOOKED_AT_FROM {
        return First::Scene;
    }
    // Samples of random vertices, and of neighbours in the list.
    let mut decided = [[0; 2]; 2];
    for look in 0..LOOKS {
        for (among, [by_scene, by_query]) in decided.iter_mut().enumerate() {
            let query = looked_at(look, among == 1, points.len()).map(|at| points[at]);
            *by_scene += usize::from(P::estimate(query).above(static_bound).is_some());
            *by_query += usize::from(P::anywhere(query).certain().is_some());
        }
    }
    // A filter that fails sometimes causes as many mispredictions, which cost more than the permanent.
    let is_worse = |[by_scene, by_query]: [usize; 2]| by_scene * 8 < by_query * 7;
    if decided.into_iter().any(is_worse) { First::Query } else { First::Scene }
}

/// Returns true if a predicate's own filter leaves many queries of a sample open.
///
/// Like [`choose`], it only chooses an order.
pub(crate) fn leaves_much<P: Predicate<D, N>, const D: usize, const N: usize>(
    count: usize,
    point: impl Fn(usize) -> [f64; D],
) -> bool {
    if count < LOOKED_AT_FROM {
        return false;
    }
    let mut open = [0; 2];
    for look in 0..LOOKS {
        for (among, open) in open.iter_mut().enumerate() {
            let query = looked_at(look, among == 1, count).map(&point);
            *open += usize::from(P::anywhere(query).certain().is_none());
        }
    }
    open.into_iter().any(|open| open * 8 >= LOOKS)
}

/// Returns true if most queries of a sample are decided: of random vertices, and of neighbours in the list.
///
/// Like [`choose`], it only chooses an order.
#[cfg(feature = "formulas")]
pub(crate) fn is_mostly(
    count: usize,
    arity: usize,
    is_decided: impl Fn(&[predicament_predicates::Vertex]) -> bool,
) -> bool {
    if count < LOOKED_AT_FROM {
        return true;
    }
    let decided = |are_neighbours: bool| {
        let query = |look: usize| -> Vec<_> {
            let first = place(look, count / arity) * arity;
            let at = |i: usize| if are_neighbours { first + i } else { place(look * arity + i, count) };
            (0..arity).map(|i| predicament_predicates::Vertex::input(at(i))).collect()
        };
        (0..LOOKS).filter(|&look| is_decided(&query(look))).count()
    };
    decided(false) * 8 >= LOOKS * 7 && decided(true) * 8 >= LOOKS * 7
}

/// The vertices of a sampled query: anywhere, or neighbours in the list.
///
/// Typical queries are about near points, and points near in space are often near in the list.
fn looked_at<const N: usize>(look: usize, are_neighbours: bool, count: usize) -> [usize; N] {
    if are_neighbours {
        let first = place(look, count / N) * N;
        core::array::from_fn(|i| first + i)
    } else {
        core::array::from_fn(|i| place(look * N + i, count))
    }
}

/// The k-th of some indices that are spread over the whole list, in no order.
#[allow(clippy::cast_possible_truncation)] // less than the length
fn place(k: usize, length: usize) -> usize {
    let spread = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    ((u128::from(spread) * length as u128) >> 64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predicate::{Orient2d, Orient3d};
    use predicament_arithmetic::{Plan, bound};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn extents_are_those_of_plans(points in prop::collection::vec(prop::array::uniform3(-1e3..1e3f64), 0..23)) {
            prop_assert_eq!(extents(&points), Plan::of(&points).axes().map(|axis| axis.extent()));
            let flat: Vec<[f64; 2]> = points.iter().map(|&[x, y, _]| [x, y]).collect();
            prop_assert_eq!(extents(&flat), Plan::of(&flat).axes().map(|axis| axis.extent()));
        }
    }

    #[test]
    fn bounds_are_there_in_range_only() {
        let with = |x: f64| bound([1.0, x], bound::static_orient2d);
        assert_eq!(with(0.0), 0.0);
        for x in [LOWEST, 1.0, HIGHEST] {
            assert!(with(x) > bound::static_orient2d([1.0, x]));
            assert!(with(x) < bound::static_orient2d([1.0, x]) * (1.0 + 1e-14));
        }
        for x in [LOWEST.next_down(), 5e-324, HIGHEST.next_up(), f64::INFINITY] {
            assert!(with(x).is_nan());
        }
    }

    /// A pseudo-random coordinate from 0 to 1.
    fn noise(at: usize) -> f64 {
        let mixed = (at as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        f64::from(u32::try_from((mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 32).unwrap())
            / 2f64.powi(32)
    }

    fn scattered(count: usize) -> Vec<[f64; 3]> {
        (0..count).map(|at| [0, 1, 2].map(|axis| noise(3 * at + axis))).collect()
    }

    fn chosen(points: &[[f64; 3]]) -> First {
        choose::<Orient3d, 3, 4>(points, bound(extents(points), bound::static_orient3d))
    }

    #[test]
    fn the_filter_that_decides_more_is_first() {
        let mut points = scattered(LOOKED_AT_FROM);
        assert_eq!(chosen(&points), First::Scene);
        assert_eq!(choose::<Orient3d, 3, 4>(&points, f64::NAN), First::Query, "no bound");
        // One far point makes the scene's bound too large for all other points.
        points[0] = [1e9; 3];
        assert_eq!(chosen(&points), First::Query);
        points.pop();
        assert_eq!(chosen(&points), First::Scene, "too few to be looked at");
        // Neighbours in the list are close together, and far from all others.
        let clustered = |at: usize| [0, 1, 2].map(|axis| noise(3 * (at / 4) + axis) + 1e-7 * noise(3 * at + axis));
        let clusters: Vec<[f64; 3]> = (0..LOOKED_AT_FROM).map(clustered).collect();
        assert_eq!(chosen(&clusters), First::Query);
        // In one plane neither filter decides anything.
        let flat: Vec<[f64; 3]> = scattered(LOOKED_AT_FROM).into_iter().map(|[x, y, _]| [x, y, 1.0]).collect();
        assert_eq!(chosen(&flat), First::Scene);
    }

    #[test]
    fn much_is_left_where_lines_are_straight() {
        let leaves = |count: usize, point: &dyn Fn(usize) -> [f64; 2]| leaves_much::<Orient2d, 2, 3>(count, point);
        let scattered = |at: usize| [noise(2 * at), noise(2 * at + 1)];
        let line = |at: usize| [0.1, 0.3].map(|slope| slope * f64::from(u32::try_from(at).unwrap()));
        assert!(!leaves(5000, &scattered) && leaves(5000, &line) && !leaves(LOOKED_AT_FROM - 1, &line));
        assert!(leaves(LOOKED_AT_FROM, &line));
        // Only neighbours are on a line.
        assert!(leaves(5000, &|at| if at % 3 == 2 {
            let [p, q] = [at - 2, at - 1].map(scattered);
            [0, 1].map(|axis| 2.0 * q[axis] - p[axis])
        } else {
            scattered(at)
        }));
    }

    #[test]
    fn queries_that_are_looked_at_are_spread_over_all() {
        for count in [LOOKED_AT_FROM, 10_007] {
            let mut seen = [0; 8];
            for look in 0..LOOKS {
                let [a, b, c, d] = looked_at::<4>(look, true, count);
                assert!(a.is_multiple_of(4) && [b, c, d] == [a + 1, a + 2, a + 3] && d < count);
                let anywhere = looked_at::<4>(look, false, count);
                assert!(anywhere.iter().all(|&at| at < count));
                anywhere.into_iter().chain([a]).for_each(|at| seen[at * 8 / count] += 1);
            }
            // Expected: 15 each.
            assert!(seen.iter().all(|seen| (8..=22).contains(seen)), "{seen:?}");
        }
    }

    #[test]
    fn bounds_are_for_extents_that_prove_them() {
        let of = |extent: [f64; 2]| bound(extent, |[x, y]| x + y);
        assert_eq!(of([1.0, 2.0]), 3.0 * MARGIN);
        assert_eq!(of([0.0, 2.0]), 2.0 * MARGIN);
        assert_eq!(of([LOWEST, HIGHEST]), (LOWEST + HIGHEST) * MARGIN);
        for outside in [LOWEST.next_down(), HIGHEST.next_up(), f64::INFINITY, f64::NAN] {
            assert!(of([1.0, outside]).is_nan() && of([outside, 1.0]).is_nan(), "{outside:e}");
        }
        assert_eq!(beside(1.0), MARGIN);
        assert_eq!(beside(0.0), power_of_two(-860));
        assert!(beside(power_of_two(-810)) >= power_of_two(-810) + power_of_two(-861));
    }
}
