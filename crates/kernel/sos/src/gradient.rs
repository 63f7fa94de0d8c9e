//! The leading terms of a tie in doubles that make no error, from points that are at hand.
//!
//! In the leading terms of a list only the vertex with the smallest index moves. They are the minors of the other rows
//! with one column struck each: a coordinate, or the lift. The formulas here compute all of them at once, for a single
//! query and for the lanes of a batch.
//!
//! # One lift for all minors
//! The lift is that about the vertex that moves, the *first* row. The scheme [`PerCoordinate`](Scheme::PerCoordinate)
//! asks for that along the struck column; along the others the origin may be anywhere. The other scheme has the lift
//! about the origin of coordinates. It differs by multiples of all columns, so its minors differ by multiples of the
//! minor with the lift struck. That is the first term of this scheme, so it is zero where another one decides.
//!
//! # After the leading terms
//! Let i < j be rows at one place. A term with both is zero, and a list begins with the monomials in which no row from
//! i on moves. The first term in which row i moves has the first leading column struck from that row. So it is next,
//! with the largest i of all such pairs. If no two rows are at one place, the next term after the leading ones is that
//! of row 1. `places` checks these claims about each list.
//!
//! # Doubles make no error
//! In the scenes in question (see [`filter`](crate::filter)), integers less than 2^g·M^k units are doubles, with M ≥ 1
//! above all differences of vertices: g = 4, k = 4 in `incircle`, g = 7, k = 5 in `insphere`. Differences are less than
//! M, a lift less than 2M² in the plane and 3M² in space, and so is a difference of lifts, both being positive. In the
//! plane a minor is less than 2 · 2M³. In space, a minor of two columns is less than 2M² or, with the lift, 6M³, and a
//! minor of three columns less than 3 · 2M³ or, with the lift, 3 · 6M⁴. The minors of `orient2d` and `orient3d` are
//! intermediates of these determinants, or as large.

// Loops over indices stay in registers.
#![allow(clippy::needless_range_loop)]

use predicament_predicates::{PredicateKind, Sign};

use crate::leading::Decided;
use crate::{Scheme, Term};

/// The index of a predicate in [`PredicateKind::ALL`].
pub(crate) const ORIENT2D: usize = PredicateKind::Orient2d.index();
pub(crate) const ORIENT3D: usize = PredicateKind::Orient3d.index();
pub(crate) const INCIRCLE: usize = PredicateKind::Incircle.index();
pub(crate) const INSPHERE: usize = PredicateKind::Insphere.index();

/// The minors of the rows after the first: x, then y struck.
#[inline(always)]
pub(crate) fn orient2d([_, p, q]: [[f64; 2]; 3]) -> [f64; 2] {
    [p[1] - q[1], p[0] - q[0]]
}

/// The minors of the rows after the first: x, y, then z struck.
#[inline(always)]
pub(crate) fn orient3d([_, p, q, r]: [[f64; 3]; 4]) -> [f64; 3] {
    across([minus(p, r), minus(q, r)])
}

/// The minors of the rows after the first: x, y, then the lift struck.
#[inline(always)]
pub(crate) fn incircle([first, p, q, r]: [[f64; 2]; 4]) -> [f64; 3] {
    let lifted = |point: [f64; 2]| {
        let [x, y] = minus(point, first);
        [x, y, x * x + y * y]
    };
    let [p, q, r] = [lifted(p), lifted(q), lifted(r)];
    across([minus(p, r), minus(q, r)])
}

/// The minors of the rows after the first: x, y, z, then the lift struck.
#[inline(always)]
pub(crate) fn insphere([first, p, q, r, s]: [[f64; 3]; 5]) -> [f64; 4] {
    let lifted = |point: [f64; 3]| {
        let [x, y, z] = minus(point, first);
        [x, y, z, x * x + y * y + z * z]
    };
    let [p, q, r, s] = [lifted(p), lifted(q), lifted(r), lifted(s)];
    let [p, q, r] = [minus(p, s), minus(q, s), minus(r, s)];
    let minor = |i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
    let [xy, xz, yz] = [minor(0, 1), minor(0, 2), minor(1, 2)];
    let [xl, yl, zl] = [minor(0, 3), minor(1, 3), minor(2, 3)];
    let [x, y, z, l] = r;
    [y * zl - z * yl + l * yz, x * zl - z * xl + l * xz, x * yl - y * xl + l * xy, x * yz - y * xz + z * xy]
}

#[inline(always)]
fn minus<const D: usize>(p: [f64; D], q: [f64; D]) -> [f64; D] {
    let mut difference = [0.0; D];
    for axis in 0..D {
        difference[axis] = p[axis] - q[axis];
    }
    difference
}

/// The minors of two rows with each of three columns struck.
#[inline(always)]
fn across([p, q]: [[f64; 3]; 2]) -> [f64; 3] {
    let minor = |i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
    [minor(1, 2), minor(0, 2), minor(0, 1)]
}

/// The leading terms in the order of a list, from the minors with each column struck.
///
/// `SCHEME` and `KIND` are indices in [`Scheme::ALL`] and [`PredicateKind::ALL`].
#[inline(always)]
pub(crate) fn in_order<const SCHEME: usize, const KIND: usize, const K: usize>(minors: [f64; K]) -> [f64; K] {
    let order = const { order::<K>(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND])) };
    let mut terms = [0.0; K];
    for place in 0..K {
        let (struck, is_negative) = order[place];
        terms[place] = if is_negative { -minors[struck] } else { minors[struck] };
    }
    terms
}

/// The struck column of each leading term, and true if its sign is negative.
const fn order<const K: usize>(terms: &'static [Term]) -> [(usize, bool); K] {
    let mut order = [(0, false); K];
    let mut seen = 0_u32;
    let mut place = 0;
    while place < K {
        let term = terms[place];
        // All rows but the first.
        let all = terms[0].rows.len();
        assert!(
            term.gap.is_none() && term.rows.len() == all && term.rows[0] == 1 && term.rows[all - 1] as usize == all
        );
        // The columns are those of 0..K without one, which may be the lift, the last one.
        let mut struck = K * (K - 1) / 2;
        let mut at = 0;
        while at < term.columns.len() {
            struck -= term.columns[at] as usize;
            at += 1;
        }
        if let Some(lift) = term.lift {
            struck -= K - 1;
            // The lift about the first vertex will do: see the module's page.
            assert!(matches!(lift.about[struck], Some(0)) || (place > 0 && order[0].0 == K - 1));
        }
        order[place] = (struck, matches!(term.sign, Sign::Negative));
        seen |= 1 << struck;
        place += 1;
    }
    assert!(seen == (1 << K) - 1, "each column is struck once");
    order
}

/// The first of the known terms that is not zero, of points with the smallest vertex first.
#[inline(always)]
pub(crate) fn decide<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize, const K: usize>(
    points: [&[f64; D]; N],
    minors: impl Fn([[f64; D]; N]) -> [f64; K],
) -> Decided {
    let terms = in_order::<SCHEME, KIND, K>(minors(points.map(|point| *point)));
    first_nonzero(terms).or_else(|| next::<SCHEME, KIND, D, N, K>(points, minors))
}

/// The same as [`decide`], for single ties of circles and spheres.
///
/// If the first term of the list is one of the plane, or has no lift, the others are evaluated only where it is zero: a
/// branch costs less than they do. In space, the first term of [`Scheme::PerCoordinate`] is zero for half of all ties
/// on circles around the axes.
#[inline(always)]
pub(crate) fn decide_one<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize, const K: usize>(
    points: [&[f64; D]; N],
    minors: impl Fn([[f64; D]; N]) -> [f64; K],
) -> Decided {
    let (struck, is_negative) = const { order::<K>(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]))[0] };
    if D == 3 && struck != K - 1 {
        return decide::<SCHEME, KIND, D, N, K>(points, minors);
    }
    let value = minors(points.map(|point| *point))[struck];
    if value == 0.0 {
        return later::<SCHEME, KIND, D, N, K>(points, minors);
    }
    Some((if (value > 0.0) == is_negative { Sign::Negative } else { Sign::Positive }, 0))
}

/// The same as [`decide`], out of line.
#[cold]
#[inline(never)]
fn later<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize, const K: usize>(
    points: [&[f64; D]; N],
    minors: impl Fn([[f64; D]; N]) -> [f64; K],
) -> Decided {
    decide::<SCHEME, KIND, D, N, K>(points, minors)
}

/// For each row but the last, the place of the first term in which it moves.
const fn places<const N: usize>(terms: &'static [Term]) -> [usize; N] {
    let mut places = [0; N];
    let mut row = 0;
    while row + 1 < N {
        // All terms before have this row and all later ones.
        let mut place = 0;
        while has(terms[place], row) {
            let mut later = row;
            while later < N {
                assert!(has(terms[place], later));
                later += 1;
            }
            place += 1;
        }
        // The term is the first one of the list, for another row.
        let (term, first) = (terms[place], terms[0]);
        assert!(term.gap.is_none() && term.rows.len() == N - 1 && term.columns.len() == first.columns.len());
        let mut at = 0;
        while at < term.columns.len() {
            assert!(term.columns[at] == first.columns[at]);
            at += 1;
        }
        assert!(matches!(term.sign, Sign::Negative) == (matches!(first.sign, Sign::Negative) != (row % 2 == 1)));
        match (term.lift, first.lift) {
            (None, None) => {}
            (Some(lift), Some(_)) => assert!(matches!(lift.about, [Some(about), None, None] if about as usize == row)),
            _ => panic!("a lift in one of two terms"),
        }
        places[row] = place;
        row += 1;
    }
    places
}

/// Returns true if a term has this row.
const fn has(term: Term, row: usize) -> bool {
    let mut at = 0;
    while at < term.rows.len() {
        if term.rows[at] as usize == row {
            return true;
        }
        at += 1;
    }
    false
}

/// The next term after leading terms that are all zero: its sign and place; `None` if it is zero as well.
#[cold]
#[inline(never)]
fn next<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize, const K: usize>(
    mut points: [&[f64; D]; N],
    minors: impl Fn([[f64; D]; N]) -> [f64; K],
) -> Decided {
    let address = |at: usize| std::ptr::from_ref(points[at]).addr();
    let (mut smallest, mut second) = (address(0).min(address(1)), address(0).max(address(1)));
    let mut moved = 0;
    for j in 1..N {
        if j > 1 {
            second = second.min(address(j).max(smallest));
            smallest = smallest.min(address(j));
        }
        for i in 0..j {
            let mut coincide = true;
            for axis in 0..D {
                coincide &= points[i][axis] == points[j][axis];
            }
            let smaller = address(i).min(address(j));
            moved = if coincide & (smaller > moved) { smaller } else { moved };
        }
    }
    let moved = if moved == 0 { second } else { moved };
    let (mut row, mut times) = (0, 0);
    for at in 0..N {
        row += usize::from(address(at) < moved);
        times += usize::from(address(at) == moved);
    }
    if times != 1 || row == 0 {
        return None;
    }
    for at in 1..N {
        if std::ptr::from_ref(points[at]).addr() == moved {
            let other = if at == 1 { 2 } else { 1 };
            (points[0], points[at], points[other]) = (points[at], points[other], points[0]);
        }
    }
    let (struck, is_negative) = const { order::<K>(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND])) }[0];
    let place = const { places::<N>(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND])) }[row];
    let value = minors(points.map(|point| *point))[struck];
    let sign = if value < 0.0 { Sign::Negative } else { Sign::Positive };
    (value != 0.0).then_some((if is_negative { -sign } else { sign }, place))
}

/// The points with that of the smallest vertex first, by an even permutation; `None` if the smallest occurs twice.
///
/// Points of a scene are in the order of their vertices, so they are ordered by their addresses.
#[inline(always)]
pub(crate) fn smallest_first<const D: usize, const N: usize>(mut points: [&[f64; D]; N]) -> Option<[&[f64; D]; N]> {
    let is_less = |p: &[f64; D], q: &[f64; D]| std::ptr::from_ref(p) < std::ptr::from_ref(q);
    // Cycles of three points, which are even.
    let [a, b, c] = [points[0], points[1], points[2]];
    let of_two = if is_less(b, a) { [b, c, a] } else { [a, b, c] };
    let of_three = if is_less(c, of_two[0]) { [c, a, b] } else { of_two };
    points[..3].copy_from_slice(&of_three);
    for row in 3..N {
        let [first, p, q] = [points[0], points[row], points[1]];
        [points[0], points[row], points[1]] = if is_less(p, first) { [p, q, first] } else { [first, p, q] };
    }
    let is_twice = points[1..].iter().fold(false, |is_twice, point| is_twice | std::ptr::eq(*point, points[0]));
    (!is_twice).then_some(points)
}

/// The sign and the place of the first of some values that is not zero; `None` if all are.
///
/// Values are selected as integers, without branches: the first one is zero too often for a branch.
#[inline(always)]
pub(crate) fn first_nonzero<const N: usize>(values: [f64; N]) -> Decided {
    let is_zero = |bits: u64| bits << 1 == 0;
    let (mut first, mut place) = (values[N - 1].to_bits(), N - 1);
    for at in (0..N - 1).rev() {
        let bits = values[at].to_bits();
        (first, place) = if is_zero(bits) { (first, place) } else { (bits, at) };
    }
    const SIGNS: [Sign; 2] = [Sign::Positive, Sign::Negative];
    (!is_zero(first)).then_some((SIGNS[usize::from(first >> 63 == 1)], place))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::coefficient;
    use crate::lanes::{circle, side, sphere, turn};
    use crate::leading::{EDELSBRUNNER_MUCKE, PER_COORDINATE};

    /// Compares what is known of shuffled points with the first nonzero coefficient of the list; returns the numbers of
    /// leading terms and of later ones, found singly and in lanes.
    fn check<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize, const K: usize>(
        minors: impl Fn([[f64; D]; N]) -> [f64; K],
        lane: impl Fn([[f64; D]; N], [f64; N]) -> f64,
    ) -> [[usize; 2]; 2] {
        let mut state = 3_u64;
        let mut below = |bound: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).unwrap() % bound
        };
        let (terms, mut seen) = (Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]), [[0; 2]; 2]);
        for _ in 0..predicament_effort::scaled(3000) {
            // Few places, or few that differ from a common one.
            let mut points = [[0.0; D]; N];
            let values = [0.0, 1.0, 3.0, -0.0, -7.0];
            points.as_flattened_mut().iter_mut().for_each(|x| *x = values[below(5)]);
            if below(2) == 0 {
                points[below(N)] = points[below(N)];
            }
            let (mut order, mut is_odd): ([usize; N], _) = (std::array::from_fn(|at| at), false);
            for last in (1..N).rev() {
                let other = below(last + 1);
                order.swap(last, other);
                is_odd ^= other != last;
            }
            let listed =
                terms.iter().map(|term| coefficient(&points, term)).enumerate().find(|(_, sign)| !sign.is_zero());
            let (place, sign) = listed.expect("the last term is a constant");
            let shuffled = smallest_first(order.map(|at| &points[at])).expect("different vertices");
            let known = decide::<SCHEME, KIND, D, N, K>(shuffled, &minors);
            assert_eq!(decide_one::<SCHEME, KIND, D, N, K>(shuffled, &minors), known, "{order:?} of {points:?}");
            if let Some(known) = known {
                assert_eq!(known, (if is_odd { -sign } else { sign }, place), "{order:?} of {points:?}");
                seen[0][usize::from(place >= K)] += 1;
            }
            #[allow(clippy::cast_precision_loss)] // small
            let numbers = order.map(|at| at as f64);
            let value = lane(order.map(|at| points[at]), numbers);
            if value != 0.0 {
                assert_eq!(Sign::of(value), if is_odd { -sign } else { sign }, "{order:?} of {points:?}");
                seen[1][usize::from(place >= K)] += 1;
            }
        }
        seen
    }

    fn check_all<const SCHEME: usize>() {
        let seen = [
            check::<SCHEME, ORIENT2D, 2, 3, 2>(orient2d, turn::<SCHEME>),
            check::<SCHEME, ORIENT3D, 3, 4, 3>(orient3d, side::<SCHEME>),
            check::<SCHEME, INCIRCLE, 2, 4, 3>(incircle, circle::<SCHEME>),
            check::<SCHEME, INSPHERE, 3, 5, 4>(insphere, sphere::<SCHEME>),
        ];
        let (most, some) = (predicament_effort::scaled(1800), predicament_effort::scaled(60));
        assert!(seen.as_flattened().iter().all(|[leading, later]| leading + later > most && *later > some), "{seen:?}");
    }

    #[test]
    fn known_terms_are_the_first_of_their_lists() {
        check_all::<PER_COORDINATE>();
        check_all::<EDELSBRUNNER_MUCKE>();
    }

    /// A vertex twice: nothing is known, or the lanes' value is zero or NaN.
    #[test]
    fn what_is_of_a_vertex_twice_remains_open() {
        let points = [[0.0, 0.0, 1.0], [4.0, 1.0, 2.0], [2.0, 5.0, 9.0], [7.0, 3.0, 3.0]];
        for j in 0..5 {
            for i in 0..j {
                let mut order = [0, 1, 2, 3, 3];
                order.swap(4, j);
                order.swap(3, i);
                let known = smallest_first(order.map(|at| &points[at]))
                    .and_then(|points| decide::<PER_COORDINATE, INSPHERE, 3, 5, 4>(points, insphere));
                assert_eq!(known, None, "{order:?}");
                let value = sphere::<PER_COORDINATE>(
                    order.map(|at| points[at]),
                    [0, 1, 2, 3, 4].map(|at| f64::from(u8::try_from(order[at]).unwrap())),
                );
                assert!(value == 0.0 || value.is_nan(), "{order:?}: {value}");
            }
        }
    }
}
