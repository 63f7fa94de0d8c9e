//! The first terms of each list, which break almost every tie, evaluated without sorting.
//!
//! A list begins with the terms in which only the vertex with the smallest index moves: minors of all other rows. They
//! are the same, up to sign, in every order of these rows, so the smallest vertex and the parity are enough. In general
//! position the first of them decides; all of them are zero only if the other vertices alone are degenerate.
//!
//! The lists are constants, and each term is compiled separately: here it costs a comparison of two coordinates, a
//! filter, or a predicate of one dimension less.

use std::ops::ControlFlow;

use predicament_predicates::{Axis, Dimension, Off, Plane, PredicateKind, Scene, Sign, Vertex};

use crate::filter::{self, Struck, order};
use crate::gradient::{self, INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D, first_nonzero, in_order};
use crate::ties::projection;
use crate::{Lift, Scheme, Term};
use crate::{deep, short};

type Exact<'s> = predicament_exact::Session<'s, Off>;

/// The index of a scheme in [`Scheme::ALL`].
pub(crate) const PER_COORDINATE: usize = Scheme::PerCoordinate as usize;
pub(crate) const EDELSBRUNNER_MUCKE: usize = Scheme::EdelsbrunnerMucke as usize;

/// The points of a scene, in the view of its dimension; the other view is empty.
#[derive(Clone, Copy)]
pub(crate) struct Points<'s> {
    pub flat: &'s [[f64; 2]],
    pub solid: &'s [[f64; 3]],
}

impl<'s> Points<'s> {
    pub fn of(scene: &'s Scene) -> Points<'s> {
        let (flat, solid): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        Points { flat, solid }
    }

    /// The vertex of a point of the plane, by its place among all.
    #[inline(always)]
    pub fn vertex2(self, point: &[f64; 2]) -> Vertex {
        Vertex::input(offset(self.flat, point))
    }

    /// The vertex of a point of space, by its place among all.
    #[inline(always)]
    pub fn vertex3(self, point: &[f64; 3]) -> Vertex {
        Vertex::input(offset(self.solid, point))
    }

    /// A coordinate; `None` if the vertex is not an input vertex, or has no such coordinate.
    #[inline(always)]
    pub fn coordinate(self, axis: Axis, v: Vertex) -> Option<f64> {
        if self.solid.is_empty() {
            self.flat.get(v.index())?.get(axis.index()).copied()
        } else {
            self.solid.get(v.index()).map(|point| point[axis.index()])
        }
    }
}

/// The index of an element of a slice, from the addresses of both.
#[inline(always)]
fn offset<T>(slice: &[T], element: &T) -> usize {
    (std::ptr::from_ref(element).addr() - slice.as_ptr().addr()) / size_of::<T>()
}

/// The sign of the first nonzero term, and its place in the list.
///
/// `None` if a vertex occurs twice, or is not an input vertex.
pub(crate) type Decided = Option<(Sign, usize)>;

/// Breaks a tie of `orient2d`.
///
/// `SCHEME` is an index in [`Scheme::ALL`], here and below.
#[inline(always)]
pub(crate) fn orient2d<const SCHEME: usize>(points: Points, plane: Plane, args: [Vertex; 3]) -> Decided {
    let [p, q] = after_smallest(args)?;
    let rows = if points.solid.is_empty() {
        [*points.flat.get(p.index())?, *points.flat.get(q.index())?]
    } else {
        // Columns ascend, so zx is xz, its mirror image: as if two vertices were exchanged.
        let ([x, y], is_mirrored) = match plane {
            Plane::Xy => ([0, 1], false),
            Plane::Yz => ([1, 2], false),
            Plane::Zx => ([0, 2], true),
        };
        let [p, q] = if is_mirrored { [q, p] } else { [p, q] };
        let [p, q] = [points.solid.get(p.index())?, points.solid.get(q.index())?];
        [[p[x], p[y]], [q[x], q[y]]]
    };
    match first_nonzero(in_order::<SCHEME, ORIENT2D, 2>(gradient::orient2d([[0.0; 2], rows[0], rows[1]]))) {
        None => rest_of_orient2d::<SCHEME>(points, plane, args),
        decided => decided,
    }
}

/// Breaks a tie of `orient2d` whose two vertices with larger indices coincide in the plane.
///
/// Two distinct vertices can have the same coordinates. The leading terms are differences of these two, so they are
/// zero.
#[cold]
#[inline(never)]
fn rest_of_orient2d<const SCHEME: usize>(points: Points, plane: Plane, args: [Vertex; 3]) -> Decided {
    let (vertices, odd) = by_index(args)?;
    // Columns ascend, so zx is xz, its mirror image.
    let axes = match plane {
        Plane::Xy => [Axis::X, Axis::Y],
        Plane::Yz => [Axis::Y, Axis::Z],
        Plane::Zx => [Axis::X, Axis::Z],
    };
    let minor = |term: Term| match (term.rows, term.columns) {
        (&[i, j], &[column]) => {
            let [p, q] = [i, j].map(|row| points.coordinate(axes[usize::from(column)], vertices[usize::from(row)]));
            Some(order(p?, q?) * term.sign)
        }
        (&[_], &[]) => Some(term.sign),
        _ => None,
    };
    // A difference of the first and the last vertex, and a constant.
    let [third, fourth] = const {
        let terms = Scheme::ALL[SCHEME].terms(PredicateKind::Orient2d);
        assert!(terms.len() == 4);
        [terms[2], terms[3]]
    };
    let (sign, place) = match minor(third)? {
        Sign::Zero => (minor(fourth)?, 3),
        sign => (sign, 2),
    };
    Some((if odd != (plane == Plane::Zx) { -sign } else { sign }, place))
}

/// The vertices by index, and true if sorting takes an odd number of exchanges; `None` if one occurs twice.
fn by_index<const N: usize>(mut vertices: [Vertex; N]) -> Option<([Vertex; N], bool)> {
    let mut odd = false;
    for end in (1..N).rev() {
        for i in 0..end {
            if vertices[i + 1] < vertices[i] {
                vertices.swap(i, i + 1);
                odd = !odd;
            }
        }
    }
    vertices.windows(2).all(|pair| pair[0] != pair[1]).then_some((vertices, odd))
}

/// Breaks a tie of `orient3d`.
#[inline(always)]
pub(crate) fn orient3d<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 4]) -> Decided {
    let vertices = smallest_first(args)?;
    let [a, b, c, d] = vertices;
    let at = |v: Vertex| points.solid.get(v.index());
    let points_of = [at(a)?, at(b)?, at(c)?, at(d)?];
    // (The tie has made the scene's plan.)
    let is_exact = exact.is_double(PredicateKind::Orient3d);
    let decided = if is_exact {
        gradient::decide::<SCHEME, ORIENT3D, _, _, _>(points_of, gradient::orient3d).ok_or(3)
    } else {
        first::<SCHEME, ORIENT3D>(Three::<3> { exact, vertices, points: points_of })
    };
    decided.map_or_else(|from| deep::<SCHEME, ORIENT3D, 3, 4>(exact, points.solid, args, (is_exact, from)), Some)
}

/// Breaks a tie of `incircle`.
#[inline(always)]
pub(crate) fn incircle<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 4]) -> Decided {
    let vertices = smallest_first(args)?;
    let [a, b, c, d] = vertices;
    let at = |v: Vertex| points.flat.get(v.index());
    let points_of = [at(a)?, at(b)?, at(c)?, at(d)?];
    // (The tie has made the scene's plan.)
    let is_exact = exact.is_double(PredicateKind::Incircle);
    let decided = if is_exact {
        gradient::decide::<SCHEME, INCIRCLE, _, _, _>(points_of, gradient::incircle).ok_or(3)
    } else {
        first::<SCHEME, INCIRCLE>(Three::<2> { exact, vertices, points: points_of })
    };
    decided.map_or_else(|from| deep::<SCHEME, INCIRCLE, 2, 4>(exact, points.flat, args, (is_exact, from)), Some)
}

/// Breaks a tie of `insphere`.
#[inline(always)]
pub(crate) fn insphere<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 5]) -> Decided {
    let vertices = smallest_first(args)?;
    let [a, b, c, d, e] = vertices;
    let at = |v: Vertex| points.solid.get(v.index());
    let points_of = [at(a)?, at(b)?, at(c)?, at(d)?, at(e)?];
    // (The tie has made the scene's plan.)
    let is_exact = exact.is_double(PredicateKind::Insphere);
    let decided = if is_exact {
        gradient::decide::<SCHEME, INSPHERE, _, _, _>(points_of, gradient::insphere).ok_or(4)
    } else {
        first::<SCHEME, INSPHERE>(Four { exact, vertices, points: points_of })
    };
    decided.map_or_else(|from| deep::<SCHEME, INSPHERE, 3, 5>(exact, points.solid, args, (is_exact, from)), Some)
}

/// Decides by the list from a place on.
#[inline(always)]
pub(crate) fn deep<const SCHEME: usize, const KIND: usize, const D: usize, const N: usize>(
    exact: &Exact,
    all: &[[f64; D]],
    args: [Vertex; N],
    (is_exact, from): (bool, usize),
) -> Decided {
    deep::decide(Scheme::ALL[SCHEME], PredicateKind::ALL[KIND], exact, all, args, is_exact, from)
}

/// The remaining rows after the first one is struck.
trait Rows: Copy {
    /// The sign of a term of these rows; `None` if it remains open.
    fn sign(self, term: Term) -> Option<Sign>;
}

/// Three of four points of the plane or of space.
#[derive(Clone, Copy)]
struct Three<'a, const D: usize> {
    exact: &'a Exact<'a>,
    vertices: [Vertex; 4],
    points: [&'a [f64; D]; 4],
}

impl<const D: usize> Rows for Three<'_, D> {
    #[inline(always)]
    fn sign(self, term: Term) -> Option<Sign> {
        let [first, p, q, r] = self.points;
        let is_negative = term.sign == Sign::Negative;
        match (term.columns, term.lift) {
            (&[x, y], None) => {
                let (plane, orientation) = projection(AXES[usize::from(x)], AXES[usize::from(y)])?;
                let [x, y] = plane.axes().map(Axis::index);
                // All leading terms of both schemes are; another list does not compile to a wrong sign.
                assert!(term.sign == orientation, "a leading term is the turn of its rows in their order");
                match filter::turn::<false>([[p[x], p[y]], [q[x], q[y]], [r[x], r[y]]]) {
                    None => Some(turn(self.exact, plane, self.vertices[1], self.vertices[2], self.vertices[3])),
                    certain => certain,
                }
            }
            (&[x], Some(lift)) => {
                let [p, q] = if is_negative { [q, p] } else { [p, q] };
                let column = usize::from(x);
                let struck = struck(lift, 1 - column, first);
                match filter::flat([p, q, r], column, struck) {
                    None => short::flat([p, q, r], column, struck),
                    certain => certain,
                }
            }
            _ => None,
        }
    }
}

/// The turn of three vertices; out of line because it is rarely needed.
#[cold]
#[inline(never)]
fn turn(exact: &Exact, plane: Plane, p: Vertex, q: Vertex, r: Vertex) -> Sign {
    exact.decide_orient2d(plane, p, q, r).0
}

/// Four of five points of space.
#[derive(Clone, Copy)]
struct Four<'a> {
    exact: &'a Exact<'a>,
    vertices: [Vertex; 5],
    points: [&'a [f64; 3]; 5],
}

impl Rows for Four<'_> {
    #[inline(always)]
    fn sign(self, term: Term) -> Option<Sign> {
        let [first, p, q, r, s] = self.points;
        let is_negative = term.sign == Sign::Negative;
        match (term.columns, term.lift) {
            (&[_, _, _], None) => {
                let [_, p, q, r, s] = self.vertices;
                let [p, q] = if is_negative { [q, p] } else { [p, q] };
                Some(self.exact.decide_orient3d(p, q, r, s).0)
            }
            (&[x, y], Some(lift)) => {
                let [p, q] = if is_negative { [q, p] } else { [p, q] };
                let columns = [x, y].map(usize::from);
                let struck = struck(lift, 3 - columns[0] - columns[1], first);
                match filter::solid([p, q, r, s], columns, struck) {
                    None => short::solid([p, q, r, s], columns, struck),
                    certain => certain,
                }
            }
            _ => None,
        }
    }
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The origin of the lift.
///
/// Only the first row can be an origin: no other vertex has moved. An origin that is not a vertex may be anywhere.
#[inline(always)]
fn struck<const D: usize>(lift: Lift, column: usize, first: &[f64; D]) -> Struck {
    Struck { column, origin: if lift.about[column].is_some() { first[column] } else { 0.0 } }
}

/// The two vertices that follow the smallest one in cyclic order; `None` if the smallest occurs twice.
#[inline(always)]
fn after_smallest([a, b, c]: [Vertex; 3]) -> Option<[Vertex; 2]> {
    let is_second = b < a;
    let smaller = if is_second { b } else { a };
    let is_third = c < smaller;
    let [p, q] = if is_second { [c, a] } else { [b, c] };
    let [p, q] = if is_third { [a, b] } else { [p, q] };
    let smallest = if is_third { c } else { smaller };
    ((smallest != p) & (smallest != q)).then_some([p, q])
}

/// The vertices with the smallest one first, by an even permutation; `None` if the smallest occurs twice.
#[inline(always)]
pub(crate) fn smallest_first<const N: usize>(mut vertices: [Vertex; N]) -> Option<[Vertex; N]> {
    let (mut odd, mut unique) = (false, true);
    for i in 1..N {
        let [a, b] = [vertices[0], vertices[i]];
        odd ^= b < a;
        unique &= a != b;
        vertices[0] = a.min(b);
        vertices[i] = a.max(b);
    }
    let [a, b] = [vertices[N - 2], vertices[N - 1]];
    [vertices[N - 2], vertices[N - 1]] = if odd { [b, a] } else { [a, b] };
    unique.then_some(vertices)
}

/// The result of a leading term.
///
/// It continues if the term is zero. Otherwise it breaks with the answer, or with the term's place if the term remains
/// open or is not a leading term.
type Said = ControlFlow<Result<(Sign, usize), usize>>;

/// The first nonzero leading term, or the place where the rest of the list must continue.
#[inline(always)]
fn first<const SCHEME: usize, const KIND: usize>(rows: impl Rows) -> Result<(Sign, usize), usize> {
    match step::<SCHEME, KIND, 0>(rows) {
        ControlFlow::Continue(()) => others::<SCHEME, KIND>(rows),
        ControlFlow::Break(said) => said,
    }
}

/// The result of the leading terms after the first; no predicate has more than four.
#[cold]
#[inline(never)]
fn others<const SCHEME: usize, const KIND: usize>(rows: impl Rows) -> Result<(Sign, usize), usize> {
    let steps = || -> Said {
        step::<SCHEME, KIND, 1>(rows)?;
        step::<SCHEME, KIND, 2>(rows)?;
        step::<SCHEME, KIND, 3>(rows)
    };
    steps().break_value().unwrap_or(Err(4))
}

#[inline(always)]
fn step<const SCHEME: usize, const KIND: usize, const PLACE: usize>(rows: impl Rows) -> Said {
    let Some(term) = (const { leading(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]), PLACE) }) else {
        return ControlFlow::Break(Err(PLACE));
    };
    match rows.sign(term) {
        Some(Sign::Zero) => ControlFlow::Continue(()),
        decided => ControlFlow::Break(decided.map(|sign| (sign, PLACE)).ok_or(PLACE)),
    }
}

/// The term at this place, if only the first vertex moves in it and its coefficient is a minor of all other rows.
pub(crate) const fn leading(terms: &'static [Term], place: usize) -> Option<Term> {
    if place >= terms.len() {
        return None;
    }
    let term = terms[place];
    let all = terms[0].rows.len();
    if term.rows.len() == all && term.rows[0] == 1 && term.gap.is_none() { Some(term) } else { None }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Backend;

    use super::*;
    use crate::definition::coefficient;

    /// Points in general position, so that their minors are clearly nonzero.
    const POINTS: [[f64; 3]; 5] = [[1.0, 7.0, 2.0], [9.0, 3.0, 5.0], [4.0, 2.0, 8.0], [6.0, 5.0, 1.0], [3.0, 8.0, 6.0]];

    /// Compares every leading term of a list, as its rows decide it, with its definition; returns their number.
    fn check<const D: usize>(kind: PredicateKind, rows: impl Rows, points: &[[f64; D]]) -> usize {
        let lists = Scheme::ALL.map(|scheme| scheme.terms(kind));
        let terms = lists.iter().flat_map(|&terms| (0..4).map_while(|place| leading(terms, place)));
        let check = |term: Term| assert_eq!(rows.sign(term), Some(coefficient(points, &term)), "{kind:?}, {term:?}");
        terms.map(check).count()
    }

    #[test]
    fn leading_terms_of_general_position_are_decided_where_they_are() {
        // With doubles that make no error, with doubles that do, and far away from 1.
        for unit in [1.0, 0.1, f64::from_bits((1023 + 60) << 52)] {
            let solid = POINTS.map(|point| point.map(|x| x * unit));
            let flat = solid.map(|[x, y, _]| [x, y]);
            let scene = Scene::new(Dimension::Three, solid.concat()).unwrap();
            let exact = predicament_exact::Exact.prepare(&scene, Off).unwrap();
            let vertices = [0, 1, 2, 3, 4].map(Vertex::input);
            let [a, b, c, d, _] = vertices;
            let (four, points) = ([a, b, c, d], [&solid[0], &solid[1], &solid[2], &solid[3]]);
            let rows = Three::<3> { exact: &exact, vertices: four, points };
            assert_eq!(check(PredicateKind::Orient3d, rows, &solid), 6);
            let rows = Four { exact: &exact, vertices, points: solid.each_ref() };
            assert!(check(PredicateKind::Insphere, rows, &solid) > 4);
            let scene = Scene::new(Dimension::Two, flat.concat()).unwrap();
            let exact = predicament_exact::Exact.prepare(&scene, Off).unwrap();
            let rows = Three::<2> { exact: &exact, vertices: four, points: [&flat[0], &flat[1], &flat[2], &flat[3]] };
            assert!(check(PredicateKind::Incircle, rows, &flat) > 3);
        }
    }
}
