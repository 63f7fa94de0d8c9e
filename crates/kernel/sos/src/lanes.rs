//! The first terms of many ties at once, on whole registers.
//!
//! A batch evaluates the terms of its ties as it evaluates determinants: each lane of a register has a query. A lane
//! finds the vertex with the smallest index, and the first term of the list, a minor of the other points. Terms that
//! are zero or not certain are left to [`leading`](crate::leading). Where doubles make no error, a lane evaluates all
//! leading terms ([`gradient`](crate::gradient)), on the points that the exact backend has fetched. A query with a
//! vertex twice is left open as well: a minor with two equal rows is zero, and the lane checks the vertex that moves.

// Loops over indices stay in registers.
#![allow(clippy::needless_range_loop)]

use predicament_exact::Ties;
use predicament_exact::anywhere::{self, Bounded};
use predicament_lanes::signs_of;
use predicament_predicates::{PredicateKind, Sign, Vertex};

use crate::filter::{self, Struck};
use crate::gradient::{self, INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D, in_order};
use crate::leading;
use crate::{Lift, Scheme, Term};

/// Breaks ties of `orient3d`, and returns a bit mask of the ties that remain open.
///
/// `SCHEME` is an index in [`Scheme::ALL`].
#[inline]
pub(crate) fn orient3d<const SCHEME: usize>(points: &[[f64; 3]], ties: &[[Vertex; 4]], out: &mut [Sign]) -> u64 {
    signs_of(points, ties, out, |rows, numbers| {
        let ([_, p, q, r], flip) = smallest_first(rows, numbers);
        let [x, y] = const { first_turn(Scheme::ALL[SCHEME].terms(PredicateKind::Orient3d)) };
        let Bounded { determinant, bound } = anywhere::orient2d([p, q, r].map(|point| [point[x], point[y]]));
        (flip * determinant, bound)
    })
}

/// The columns of `orient3d`'s first term, exchanged if the sign is negative.
const fn first_turn(terms: &'static [Term]) -> [usize; 2] {
    let term = terms[0];
    assert!(term.rows.len() == 3 && term.rows[0] == 1 && term.columns.len() == 2 && term.lift.is_none());
    let [x, y] = [term.columns[0] as usize, term.columns[1] as usize];
    if matches!(term.sign, Sign::Negative) { [y, x] } else { [x, y] }
}

/// Breaks ties of `orient2d` in the plane, and returns a bit mask of the ties that remain open.
#[inline]
pub(crate) fn orient2d<const SCHEME: usize>(points: &[[f64; 2]], ties: &[[Vertex; 3]], out: &mut [Sign]) -> u64 {
    if points.is_empty() {
        return u64::MAX;
    }
    // (A difference of doubles has the right sign.)
    signs_of(points, ties, out, |rows, numbers| (turn::<SCHEME>(rows, numbers), 0.0))
}

/// Breaks ties of `incircle`, and returns a bit mask of the ties that remain open.
#[inline]
pub(crate) fn incircle<const SCHEME: usize>(points: &[[f64; 2]], ties: &[[Vertex; 4]], out: &mut [Sign]) -> u64 {
    signs_of(points, ties, out, |rows, numbers| {
        let ([first, p, q, r], flip) = smallest_first(rows, numbers);
        let term = const { first_term::<SCHEME, INCIRCLE>() };
        let (value, bound) = match (term.columns, term.lift) {
            (&[_, _], None) => pair(anywhere::orient2d([p, q, r])),
            (&[x], Some(lift)) => {
                let column = usize::from(x);
                filter::flat_value([&p, &q, &r], column, struck(lift, 1 - column, first))
            }
            _ => (f64::NAN, f64::NAN),
        };
        (if matches!(term.sign, Sign::Negative) { -flip * value } else { flip * value }, bound)
    })
}

/// Breaks ties of `insphere`, and returns a bit mask of the ties that remain open.
#[inline]
pub(crate) fn insphere<const SCHEME: usize>(points: &[[f64; 3]], ties: &[[Vertex; 5]], out: &mut [Sign]) -> u64 {
    signs_of(points, ties, out, |rows, numbers| {
        let ([first, p, q, r, s], flip) = smallest_first(rows, numbers);
        let term = const { first_term::<SCHEME, INSPHERE>() };
        let (value, bound) = match (term.columns, term.lift) {
            (&[_, _, _], None) => pair(anywhere::orient3d([p, q, r, s])),
            (&[x, y], Some(lift)) => {
                let columns = [x, y].map(usize::from);
                filter::solid_value([&p, &q, &r, &s], columns, struck(lift, 3 - columns[0] - columns[1], first))
            }
            _ => (f64::NAN, f64::NAN),
        };
        (if matches!(term.sign, Sign::Negative) { -flip * value } else { flip * value }, bound)
    })
}

/// The first term of a list, a minor of all rows but the first.
const fn first_term<const SCHEME: usize, const KIND: usize>() -> Term {
    let Some(term) = leading::leading(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]), 0) else {
        panic!("only the first vertex moves in the first term");
    };
    term
}

/// The origin of a lift in the struck column: the first vertex, as in the first term.
#[inline(always)]
fn struck<const D: usize>(lift: Lift, column: usize, first: [f64; D]) -> Struck {
    assert!(lift.about[column].is_some());
    Struck { column, origin: first[column] }
}

#[inline(always)]
fn pair(Bounded { determinant, bound }: Bounded) -> (f64, f64) {
    (determinant, bound)
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

// Ties where doubles make no error, in the block of the exact backend's filter.

/// The first of the terms that are known for a tie: a number of its sign, zero or NaN if it remains open.
///
/// If two points coincide, that is the term of [`gradient::next`].
#[inline(always)]
pub(crate) fn turn<const SCHEME: usize>(rows: [[f64; 2]; 3], numbers: [f64; 3]) -> f64 {
    let Moved { rows, flip, is_first } = moved_first(rows, numbers);
    flip * chosen(in_order::<SCHEME, ORIENT2D, 2>(gradient::orient2d(rows)), is_first)
}

/// The same as [`turn`], for `orient3d`.
#[inline(always)]
pub(crate) fn side<const SCHEME: usize>(rows: [[f64; 3]; 4], numbers: [f64; 4]) -> f64 {
    let Moved { rows, flip, is_first } = moved_first(rows, numbers);
    flip * chosen(in_order::<SCHEME, ORIENT3D, 3>(gradient::orient3d(rows)), is_first)
}

/// The same as [`turn`], for `incircle`.
#[inline(always)]
pub(crate) fn circle<const SCHEME: usize>(rows: [[f64; 2]; 4], numbers: [f64; 4]) -> f64 {
    let Moved { rows, flip, is_first } = moved_first(rows, numbers);
    flip * chosen(in_order::<SCHEME, INCIRCLE, 3>(gradient::incircle(rows)), is_first)
}

/// The same as [`turn`], for `insphere`.
#[inline(always)]
pub(crate) fn sphere<const SCHEME: usize>(rows: [[f64; 3]; 5], numbers: [f64; 5]) -> f64 {
    let Moved { rows, flip, is_first } = moved_first(rows, numbers);
    flip * chosen(in_order::<SCHEME, INSPHERE, 4>(gradient::insphere(rows)), is_first)
}

/// The known terms of ties, for the exact backend's batches: [`turn`], [`side`], [`circle`] or [`sphere`] in each lane.
///
/// `SCHEME` is an index in [`Scheme::ALL`].
pub(crate) struct Lanes<const SCHEME: usize>;

macro_rules! lanes {
    ($dimension:literal, $points:literal, $known:ident) => {
        impl<const SCHEME: usize> Ties<$dimension, $points> for Lanes<SCHEME> {
            const BREAKS: bool = true;

            #[inline(always)]
            fn sign(&self, points: [[f64; $dimension]; $points], numbers: [f64; $points]) -> f64 {
                $known::<SCHEME>(points, numbers)
            }
        }
    };
}
lanes!(2, 3, turn);
lanes!(3, 4, side);
lanes!(2, 4, circle);
lanes!(3, 5, sphere);

/// The first term of a row that is not the first, or the first nonzero one of the first row; zero if all are.
#[inline(always)]
fn chosen<const K: usize>(terms: [f64; K], is_first: bool) -> f64 {
    let mut chosen = terms[K - 1];
    for place in (0..K - 1).rev() {
        chosen = if terms[place] == 0.0 { chosen } else { terms[place] };
    }
    if is_first { chosen } else { terms[0] }
}

/// Rows with the one first whose vertex moves in the terms in question.
struct Moved<const D: usize, const N: usize> {
    rows: [[f64; D]; N],
    /// The parity of the exchanges, 1 or −1; NaN if the vertex occurs twice.
    flip: f64,
    /// True if its vertex is the smallest one.
    is_first: bool,
}

/// The row of the smallest vertex first; if points coincide, of the smaller vertex of the pair where that is largest.
#[inline(always)]
fn moved_first<const D: usize, const N: usize>(mut rows: [[f64; D]; N], mut numbers: [f64; N]) -> Moved<D, N> {
    let less = |a: f64, b: f64| if a < b { a } else { b };
    let mut smallest = numbers[0];
    for row in 1..N {
        smallest = less(smallest, numbers[row]);
    }
    let mut moved = smallest;
    for j in 1..N {
        for i in 0..j {
            let mut coincide = true;
            for axis in 0..D {
                coincide &= rows[i][axis] == rows[j][axis];
            }
            let smaller = less(numbers[i], numbers[j]);
            moved = if coincide & (smaller > moved) { smaller } else { moved };
        }
    }
    let mut flip = 1.0;
    for row in 1..N {
        // (Behind the first row nothing has moved yet.)
        let is_here = numbers[row] == moved;
        flip = if is_here & (numbers[0] == moved) { f64::NAN } else { flip };
        flip = if is_here { -flip } else { flip };
        numbers[0] = if is_here { moved } else { numbers[0] };
        for axis in 0..D {
            let [x, y] = [rows[0][axis], rows[row][axis]];
            [rows[0][axis], rows[row][axis]] = if is_here { [y, x] } else { [x, y] };
        }
    }
    Moved { rows, flip, is_first: moved == smallest }
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
        many: impl Fn(&[[Vertex; N]], &mut [Sign]) -> u64,
        one: impl Fn([Vertex; N]) -> Option<(Sign, usize)>,
    ) {
        let queries = queries::<N>(11);
        let mut out = [Sign::Zero; 64];
        assert_eq!(many(&queries, &mut out), 0, "left open");
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
            |ties, out| orient2d::<SCHEME>(&flat, ties, out),
            |args| leading::orient2d::<SCHEME>(points2, Plane::Xy, args),
        );
        check(
            |ties, out| orient3d::<SCHEME>(&solid, ties, out),
            |args| leading::orient3d::<SCHEME>(&exact3, points3, args),
        );
        check(
            |ties, out| incircle::<SCHEME>(&flat, ties, out),
            |args| leading::incircle::<SCHEME>(&exact2, points2, args),
        );
        check(
            |ties, out| insphere::<SCHEME>(&solid, ties, out),
            |args| leading::insphere::<SCHEME>(&exact3, points3, args),
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
