//! The first terms of many ties at once, on whole registers.
//!
//! A batch evaluates the terms of its ties as it evaluates determinants: each lane of a register has a query. A lane
//! finds the vertex with the smallest index, and the first term of the list, a minor of the other points. For ties of
//! `orient2d`, and of `orient3d` if doubles make no error, all leading terms are evaluated. Terms that are zero or not
//! certain are left to [`leading`](crate::leading). A query with a vertex twice is left to it as well: a minor with two
//! equal rows is zero, and the lane checks the smallest vertex.

// Loops over indices stay in registers.
#![allow(clippy::needless_range_loop)]

use predicament_exact::anywhere::{self, Bounded};
use predicament_lanes::signs_of;
use predicament_predicates::{PredicateKind, Sign, Vertex};

use crate::filter::{self, Struck};
use crate::leading::{self, INCIRCLE, INSPHERE, difference, sign_of, turned_columns};
use crate::{Lift, Scheme, Term};

/// Breaks ties of `orient2d` in the plane, and returns a bit mask of the ties that remain open.
///
/// `SCHEME` is an index in [`Scheme::ALL`].
#[inline]
pub(crate) fn orient2d<const SCHEME: usize>(points: &[[f64; 2]], ties: &[[Vertex; 3]], out: &mut [Sign]) -> u64 {
    if points.is_empty() {
        return u64::MAX;
    }
    signs_of(points, ties, out, |rows, numbers| {
        let (rows, flip) = smallest_first(rows, numbers);
        let [first, second] = const {
            let terms = Scheme::ALL[SCHEME].terms(PredicateKind::Orient2d);
            [difference(terms[0]), difference(terms[1])]
        };
        // (A difference of doubles has the right sign.)
        let compared = |[p, q, column]: [usize; 3]| rows[p][column] - rows[q][column];
        let [first, second] = [compared(first), compared(second)];
        (flip * if first == 0.0 { second } else { first }, 0.0)
    })
}

/// Breaks ties of `orient3d`, and returns a bit mask of the ties that remain open.
///
/// `is_exact` says that doubles make no error, here and below.
#[inline]
pub(crate) fn orient3d<const SCHEME: usize>(
    points: &[[f64; 3]],
    ties: &[[Vertex; 4]],
    out: &mut [Sign],
    is_exact: bool,
) -> u64 {
    if is_exact {
        signs_of(points, ties, out, first_of_orient3d::<SCHEME, true>)
    } else {
        signs_of(points, ties, out, first_of_orient3d::<SCHEME, false>)
    }
}

#[inline(always)]
fn first_of_orient3d<const SCHEME: usize, const EXACT: bool>(rows: [[f64; 3]; 4], numbers: [f64; 4]) -> (f64, f64) {
    let ([_, p, q, r], flip) = smallest_first(rows, numbers);
    let columns = const { turned_columns(Scheme::ALL[SCHEME].terms(PredicateKind::Orient3d)) };
    let turn = |[x, y]: [usize; 2]| anywhere::orient2d([p, q, r].map(|point| [point[x], point[y]]));
    let first = turn(columns[0]);
    if !EXACT {
        return (flip * first.determinant, first.bound);
    }
    let [second, third] = [turn(columns[1]).determinant, turn(columns[2]).determinant];
    let later = if second == 0.0 { third } else { second };
    (flip * if first.determinant == 0.0 { later } else { first.determinant }, 0.0)
}

/// Breaks ties of `incircle`, and returns a bit mask of the ties that remain open.
#[inline]
pub(crate) fn incircle<const SCHEME: usize>(
    points: &[[f64; 2]],
    ties: &[[Vertex; 4]],
    out: &mut [Sign],
    is_exact: bool,
) -> u64 {
    if is_exact {
        signs_of(points, ties, out, first_of_incircle::<SCHEME, true>)
    } else {
        signs_of(points, ties, out, first_of_incircle::<SCHEME, false>)
    }
}

#[inline(always)]
fn first_of_incircle<const SCHEME: usize, const EXACT: bool>(rows: [[f64; 2]; 4], numbers: [f64; 4]) -> (f64, f64) {
    let (rows, flip) = smallest_first(rows, numbers);
    let (value, bound) = incircle_term::<SCHEME, EXACT>(rows);
    (flip * value, bound)
}

/// Breaks a single tie of `incircle` by the first term if doubles make no error.
///
/// `None` if the term is zero, a vertex is not an input vertex, or the smallest vertex occurs twice, here and below.
#[inline(always)]
pub(crate) fn first_incircle<const SCHEME: usize>(points: &[[f64; 2]], args: [Vertex; 4]) -> Option<Sign> {
    let [a, b, c, d] = leading::smallest_first(args)?;
    let at = |v: Vertex| points.get(v.index()).copied();
    sign_of(incircle_term::<SCHEME, true>([at(a)?, at(b)?, at(c)?, at(d)?]).0)
}

/// The first term of `incircle`, and the bound for its sign; the smallest vertex is the first row.
#[inline(always)]
fn incircle_term<const SCHEME: usize, const EXACT: bool>([first, p, q, r]: [[f64; 2]; 4]) -> (f64, f64) {
    let term = const { first_term::<SCHEME, INCIRCLE>() };
    let (value, bound) = match (term.columns, term.lift) {
        (&[_, _], None) => certain::<EXACT>(anywhere::orient2d([p, q, r])),
        (&[x], Some(lift)) => {
            let column = usize::from(x);
            let struck = struck(lift, 1 - column, first);
            filter::flat_value::<EXACT, 2>([&p, &q, &r], column, struck)
        }
        _ => (f64::NAN, f64::NAN),
    };
    (if matches!(term.sign, Sign::Negative) { -value } else { value }, bound)
}

/// Breaks ties of `insphere`, and returns a bit mask of the ties that remain open.
#[inline]
pub(crate) fn insphere<const SCHEME: usize>(
    points: &[[f64; 3]],
    ties: &[[Vertex; 5]],
    out: &mut [Sign],
    is_exact: bool,
) -> u64 {
    if is_exact {
        signs_of(points, ties, out, first_of_insphere::<SCHEME, true>)
    } else {
        signs_of(points, ties, out, first_of_insphere::<SCHEME, false>)
    }
}

#[inline(always)]
fn first_of_insphere<const SCHEME: usize, const EXACT: bool>(rows: [[f64; 3]; 5], numbers: [f64; 5]) -> (f64, f64) {
    let (rows, flip) = smallest_first(rows, numbers);
    let (value, bound) = insphere_term::<SCHEME, EXACT>(rows);
    (flip * value, bound)
}

/// Breaks a single tie of `insphere` by the first term if doubles make no error.
#[inline(always)]
pub(crate) fn first_insphere<const SCHEME: usize>(points: &[[f64; 3]], args: [Vertex; 5]) -> Option<Sign> {
    let [a, b, c, d, e] = leading::smallest_first(args)?;
    let at = |v: Vertex| points.get(v.index()).copied();
    sign_of(insphere_term::<SCHEME, true>([at(a)?, at(b)?, at(c)?, at(d)?, at(e)?]).0)
}

/// The first term of `insphere`, and the bound for its sign; the smallest vertex is the first row.
#[inline(always)]
fn insphere_term<const SCHEME: usize, const EXACT: bool>([first, p, q, r, s]: [[f64; 3]; 5]) -> (f64, f64) {
    let term = const { first_term::<SCHEME, INSPHERE>() };
    let (value, bound) = match (term.columns, term.lift) {
        (&[_, _, _], None) => certain::<EXACT>(anywhere::orient3d([p, q, r, s])),
        (&[x, y], Some(lift)) => {
            let columns = [x, y].map(usize::from);
            let struck = struck(lift, 3 - columns[0] - columns[1], first);
            filter::solid_value::<EXACT>([&p, &q, &r, &s], columns, struck)
        }
        _ => (f64::NAN, f64::NAN),
    };
    (if matches!(term.sign, Sign::Negative) { -value } else { value }, bound)
}

/// The first term of a list, a minor of all rows but the first.
const fn first_term<const SCHEME: usize, const KIND: usize>() -> Term {
    let Some(term) = leading::leading(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]), 0) else {
        panic!("only the first vertex moves in the first term");
    };
    // Doubles that make no error are those of differences, so of a lift about a vertex.
    assert!(match term.lift {
        None => true,
        Some(lift) => matches!(lift.about, [Some(0), None, None]),
    });
    term
}

/// The origin of a lift in the struck column: the first vertex, as in the first term.
#[inline(always)]
fn struck<const D: usize>(lift: Lift, column: usize, first: [f64; D]) -> Struck {
    assert!(lift.about[column].is_some());
    Struck { column, origin: first[column] }
}

#[inline(always)]
fn certain<const EXACT: bool>(Bounded { determinant, bound }: Bounded) -> (f64, f64) {
    (determinant, if EXACT { 0.0 } else { bound })
}

/// The point of the vertex with the smallest number first, and the parity of the exchanges, 1 or −1.
///
/// The parity is NaN if that vertex, or another one that was the smallest so far, occurs twice.
#[inline(always)]
fn smallest_first<const D: usize, const N: usize>(
    mut rows: [[f64; D]; N],
    mut numbers: [f64; N],
) -> ([[f64; D]; N], f64) {
    let mut flip = 1.0;
    for row in 1..N {
        let [a, b] = [numbers[0], numbers[row]];
        let is_less = b < a;
        numbers[0] = if is_less { b } else { a };
        flip = if is_less { -flip } else { flip };
        for axis in 0..D {
            let [x, y] = [rows[0][axis], rows[row][axis]];
            [rows[0][axis], rows[row][axis]] = if is_less { [y, x] } else { [x, y] };
        }
        // (Also if a smaller one comes later: that is rare, and remains open.)
        flip = if a == b { f64::NAN } else { flip };
    }
    (rows, flip)
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Dimension, Off, Plane, Scene};

    use super::*;
    use crate::leading::{self, EDELSBRUNNER_MUCKE, PER_COORDINATE, Points};

    /// Queries of any distinct vertices, in any order.
    fn queries<const N: usize>(points: usize) -> Vec<[Vertex; N]> {
        let mut state = 7_u64;
        let mut below = |bound: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).unwrap() % bound
        };
        let mut query = || {
            let mut all: Vec<usize> = (0..points).collect();
            std::array::from_fn(|_| Vertex::input(all.swap_remove(below(all.len()))))
        };
        (0..64).map(|_| query()).collect()
    }

    /// Points in general position, on a curve where coordinates, lifts and minors are distinct.
    ///
    /// They are integers, which make no error, or integers plus a fraction.
    fn points<const D: usize>(is_exact: bool) -> Vec<[f64; D]> {
        let fraction = if is_exact { 0.0 } else { 0.1 };
        let number = |at: u32, axis: usize| {
            let at = at * 7 % 11;
            f64::from([at * at * at % 101, at * at % 83 + 3 * at, (at * 17 + at * at * at * at) % 97][axis]) + fraction
        };
        (0..11).map(|at| std::array::from_fn(|axis| number(at, axis))).collect()
    }

    /// Checks that all ties in general position are decided, and that the signs equal the signs of single queries.
    fn check<const N: usize>(
        many: impl Fn(&[[Vertex; N]], &mut [Sign], bool) -> u64,
        one: impl Fn([Vertex; N]) -> Option<(Sign, usize)>,
        is_exact: bool,
    ) {
        let queries = queries::<N>(11);
        let mut out = [Sign::Zero; 64];
        assert_eq!(many(&queries, &mut out, is_exact), 0, "left open");
        for (query, sign) in queries.iter().zip(out) {
            assert_eq!(one(*query).map(|(sign, _)| sign), Some(sign), "{query:?}");
        }
    }

    fn check_all<const SCHEME: usize>(is_exact: bool) {
        let (flat, solid) = (points::<2>(is_exact), points::<3>(is_exact));
        let scene2 = Scene::new(Dimension::Two, flat.concat()).unwrap();
        let scene3 = Scene::new(Dimension::Three, solid.concat()).unwrap();
        let (exact2, exact3) = (Exact.prepare(&scene2, Off).unwrap(), Exact.prepare(&scene3, Off).unwrap());
        assert_eq!(exact3.is_double(PredicateKind::Insphere), is_exact);
        let (points2, points3) = (Points::of(&scene2), Points::of(&scene3));
        check(
            |ties, out, _| orient2d::<SCHEME>(&flat, ties, out),
            |args| leading::orient2d::<SCHEME>(points2, Plane::Xy, args),
            is_exact,
        );
        check(
            |ties, out, is_exact| orient3d::<SCHEME>(&solid, ties, out, is_exact),
            |args| leading::orient3d::<SCHEME>(&exact3, points3, args),
            is_exact,
        );
        check(
            |ties, out, is_exact| incircle::<SCHEME>(&flat, ties, out, is_exact),
            |args| leading::incircle::<SCHEME>(&exact2, points2, args),
            is_exact,
        );
        check(
            |ties, out, is_exact| insphere::<SCHEME>(&solid, ties, out, is_exact),
            |args| leading::insphere::<SCHEME>(&exact3, points3, args),
            is_exact,
        );
    }

    #[test]
    fn ties_of_general_position_are_all_broken() {
        for is_exact in [true, false] {
            check_all::<PER_COORDINATE>(is_exact);
            check_all::<EDELSBRUNNER_MUCKE>(is_exact);
        }
    }
}
