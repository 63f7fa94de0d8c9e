//! The first terms of each list, which break almost every tie, evaluated without sorting.
//!
//! A list begins with the terms in which nothing but the vertex with the
//! smallest index moves: minors of all other rows. They are the same, up to
//! sign, in whatever order these rows are, so it is enough to find the smallest
//! vertex and to know the parity. In general position the first of them
//! decides; for all of them to be zero the other vertices alone have to be
//! degenerate.
//!
//! The lists are constants, and each term is compiled for itself: here it costs
//! a comparison of two coordinates, a filter, or a predicate of one dimension less.

use std::ops::ControlFlow;

use predicament_predicates::{Axis, Dimension, Off, Plane, PredicateKind, Scene, Sign, Vertex};

use crate::filter::{self, Struck};
use crate::short;
use crate::ties::projection;
use crate::{Lift, Scheme, Term};

type Exact<'s> = predicament_exact::Session<'s, Off>;

/// The place of a predicate in [`PredicateKind::ALL`].
const ORIENT2D: usize = PredicateKind::Orient2d.index();
const ORIENT3D: usize = PredicateKind::Orient3d.index();
const INCIRCLE: usize = PredicateKind::Incircle.index();
const INSPHERE: usize = PredicateKind::Insphere.index();

/// The place of a scheme in [`Scheme::ALL`].
pub(crate) const PER_COORDINATE: usize = Scheme::PerCoordinate as usize;
pub(crate) const EDELSBRUNNER_MUCKE: usize = Scheme::EdelsbrunnerMucke as usize;

/// The points of a scene, in the view of its dimension; the other one is empty.
#[derive(Clone, Copy)]
pub(crate) struct Points<'s> {
    pub flat: &'s [[f64; 2]],
    pub solid: &'s [[f64; 3]],
}

impl<'s> Points<'s> {
    pub fn of(scene: &'s Scene) -> Points<'s> {
        match scene.dimension() {
            Dimension::Two => Points { flat: scene.coordinates().as_chunks().0, solid: &[] },
            Dimension::Three => Points { flat: &[], solid: scene.coordinates().as_chunks().0 },
        }
    }

    /// None if the vertex is not an input vertex, or has no such coordinate.
    #[inline(always)]
    pub fn coordinate(self, axis: Axis, v: Vertex) -> Option<f64> {
        if self.solid.is_empty() {
            self.flat.get(v.index())?.get(axis.index()).copied()
        } else {
            self.solid.get(v.index()).map(|point| point[axis.index()])
        }
    }
}

/// The sign of the first leading term that is not zero, and its place in the
/// list. None if that takes the rest of the list, or a lift in more than one
/// limb; or if a vertex comes twice, or is not an input vertex.
pub(crate) type Decided = Option<(Sign, usize)>;

/// Breaks a tie of `orient2d`. `SCHEME` is a place in [`Scheme::ALL`], here and below.
#[inline(always)]
pub(crate) fn orient2d<const SCHEME: usize>(points: Points, plane: Plane, args: [Vertex; 3]) -> Decided {
    let [_, p, q] = smallest_first(args)?;
    // Columns ascend, so zx is xz, its mirror image: as if p and q were exchanged.
    let [p, q] = if plane == Plane::Zx { [q, p] } else { [p, q] };
    let rows = if points.solid.is_empty() {
        [*points.flat.get(p.index())?, *points.flat.get(q.index())?]
    } else {
        let [x, y] = match plane {
            Plane::Xy => [0, 1],
            Plane::Yz => [1, 2],
            Plane::Zx => [0, 2],
        };
        let [p, q] = [points.solid.get(p.index())?, points.solid.get(q.index())?];
        [[p[x], p[y]], [q[x], q[y]]]
    };
    first::<SCHEME, ORIENT2D>(Two(rows)).or_else(|| rest_of_orient2d::<SCHEME>(points, plane, args))
}

/// Breaks a tie of `orient2d` of vertices of which the two with larger indices are at one place in the plane: that of a vertex with another
/// vertex' coordinates. The leading terms are differences of these two, so they are zero.
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

/// Breaks a tie of `orient3d` of vertices of which those but the first by index are degenerate in all projections: on a vertical line, or two
/// at one place.
#[cold]
#[inline(never)]
fn rest_of_orient3d<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 4]) -> Decided {
    let (vertices, odd) = by_index(args)?;
    let vertex = |row: u8| vertices[usize::from(row)];
    let (sign, place) =
        rest(Scheme::ALL[SCHEME].terms(PredicateKind::Orient3d), |rows, columns| match (rows, columns) {
            (&[i, j, k], &[x, y]) => {
                let (plane, orientation) = projection(AXES[usize::from(x)], AXES[usize::from(y)])?;
                Some(exact.decide_orient2d(plane, vertex(i), vertex(j), vertex(k)).0 * orientation)
            }
            (&[i, j], &[column]) => {
                let [p, q] = [i, j].map(|row| points.coordinate(AXES[usize::from(column)], vertex(row)));
                Some(order(p?, q?))
            }
            (&[_], &[]) => Some(Sign::Positive),
            _ => None,
        })?;
    Some((if odd { -sign } else { sign }, place))
}

/// The first term behind the leading ones that is not zero, by the signs of minors.
fn rest(terms: &[Term], minor: impl Fn(&[u8], &[u8]) -> Option<Sign>) -> Decided {
    let all = terms[0].rows.len();
    for (place, term) in terms.iter().enumerate().skip_while(|(_, term)| term.rows.len() == all && term.rows[0] == 1) {
        if term.lift.is_some() || term.gap.is_some() {
            return None;
        }
        let sign = minor(term.rows, term.columns)? * term.sign;
        if sign != Sign::Zero {
            return Some((sign, place));
        }
    }
    None
}

/// The vertices by index, and whether that takes an odd number of exchanges; none if one comes twice.
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
    first::<SCHEME, ORIENT3D>(Three { exact, vertices, points: [at(a)?, at(b)?, at(c)?, at(d)?] })
        .or_else(|| rest_of_orient3d::<SCHEME>(exact, points, args))
}

/// Breaks a tie of `incircle`.
#[inline(always)]
pub(crate) fn incircle<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 4]) -> Decided {
    let vertices = smallest_first(args)?;
    let [a, b, c, d] = vertices;
    let at = |v: Vertex| points.flat.get(v.index());
    first::<SCHEME, INCIRCLE>(Three { exact, vertices, points: [at(a)?, at(b)?, at(c)?, at(d)?] })
}

/// Breaks a tie of `insphere`.
#[inline(always)]
pub(crate) fn insphere<const SCHEME: usize>(exact: &Exact, points: Points, args: [Vertex; 5]) -> Decided {
    let vertices = smallest_first(args)?;
    let [a, b, c, d, e] = vertices;
    let at = |v: Vertex| points.solid.get(v.index());
    first::<SCHEME, INSPHERE>(Four { exact, vertices, points: [at(a)?, at(b)?, at(c)?, at(d)?, at(e)?] })
}

/// The rows that are left when the first one is struck.
trait Rows: Copy {
    /// The sign of a term of these rows, or none if it is left open.
    fn sign(self, term: Term) -> Option<Sign>;
}

/// Two points of the plane.
#[derive(Clone, Copy)]
struct Two([[f64; 2]; 2]);

impl Rows for Two {
    #[inline(always)]
    fn sign(self, term: Term) -> Option<Sign> {
        let &[column] = term.columns else { return None };
        let [p, q] = self.0.map(|point| point[usize::from(column)]);
        Some(if term.sign == Sign::Negative { order(q, p) } else { order(p, q) })
    }
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
                let is_mirrored = term.sign != orientation;
                let [p, q] = if is_mirrored { [q, p] } else { [p, q] };
                match filter::turn([[p[x], p[y]], [q[x], q[y]], [r[x], r[y]]]) {
                    None if is_mirrored => {
                        Some(turn(self.exact, plane, self.vertices[2], self.vertices[1], self.vertices[3]))
                    }
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

/// Out of line, and not through memory: it is seldom needed.
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

/// The sign of p − q.
#[inline(always)]
fn order(p: f64, q: f64) -> Sign {
    // A table: a branch on what is as good as random costs more than all the rest.
    const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
    SIGNS[usize::from(p >= q) + usize::from(p > q)]
}

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// Only the first row can be an origin: no other vertex has moved.
#[inline(always)]
fn struck<const D: usize>(lift: Lift, column: usize, first: &[f64; D]) -> Struck {
    Struck { column, origin: if lift.about[column].is_some() { first[column] } else { 0.0 } }
}

/// The vertices with the smallest one first, by an even permutation; none if it
/// comes twice.
#[inline(always)]
fn smallest_first<const N: usize>(mut vertices: [Vertex; N]) -> Option<[Vertex; N]> {
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

/// The first of the leading terms that is not zero, unless one is left open.
#[inline(always)]
fn first<const SCHEME: usize, const KIND: usize>(rows: impl Rows) -> Decided {
    match step::<SCHEME, KIND, 0>(rows) {
        ControlFlow::Continue(()) => others::<SCHEME, KIND>(rows),
        ControlFlow::Break(decided) => decided,
    }
}

/// No predicate has more than four.
#[cold]
#[inline(never)]
fn others<const SCHEME: usize, const KIND: usize>(rows: impl Rows) -> Decided {
    let steps = || -> ControlFlow<Decided> {
        step::<SCHEME, KIND, 1>(rows)?;
        step::<SCHEME, KIND, 2>(rows)?;
        step::<SCHEME, KIND, 3>(rows)
    };
    steps().break_value().flatten()
}

/// Breaks with a sign that is not zero, or with none where the term is left
/// open or there is no leading term at this place.
#[inline(always)]
fn step<const SCHEME: usize, const KIND: usize, const PLACE: usize>(rows: impl Rows) -> ControlFlow<Decided> {
    let Some(term) = (const { leading(Scheme::ALL[SCHEME].terms(PredicateKind::ALL[KIND]), PLACE) }) else {
        return ControlFlow::Break(None);
    };
    match rows.sign(term) {
        Some(Sign::Zero) => ControlFlow::Continue(()),
        decided => ControlFlow::Break(decided.map(|sign| (sign, PLACE))),
    }
}

/// The term at this place, if only the first vertex moves in it and its
/// coefficient is a minor of all other rows.
const fn leading(terms: &'static [Term], place: usize) -> Option<Term> {
    if place >= terms.len() {
        return None;
    }
    let term = terms[place];
    let all = terms[0].rows.len();
    if term.rows.len() == all && term.rows[0] == 1 && term.gap.is_none() { Some(term) } else { None }
}
