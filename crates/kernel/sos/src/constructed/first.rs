//! Tie breaking by the first vertices of constructed vertices.
//!
//! The determinant of a question is linear in each of its rows. If rows have no vertex in common, a monomial is a
//! product of one monomial of each row, and its coefficient is the determinant of their coefficients. Largest first,
//! the monomials of a row begin with
//!
//! * one, with the unperturbed row;
//! * the coordinates of its first vertex, with the derivatives that [`Row`] holds (the first coordinate only, if that
//!   vertex occurs twice);
//! * a *rest* of which only the start is known: all other monomials have the second vertex, or, if the first one occurs
//!   twice, another coordinate of it or two of its factors.
//!
//! The larger of two products has the lower degree in the smallest infinitesimal in which they differ. So sort all
//! *steps* of all rows from the largest on. Products, with no row twice, are then ordered by their smallest step, then
//! by their next one. The code tries them in that order, and the first one whose determinant is not zero decides. The
//! determinant of a product with a rest is unknown, with one exception: it is zero if two of the remaining rows are of
//! one point, both unperturbed. Most ties of more than two points at one place come about that way. Any other product
//! with a rest ends the search here, and [`Search`](super::search::Search) finds the answer.
//!
//! # A vertex in common
//! All of the above holds for products of infinitesimals that are larger than those of the first vertex that two rows
//! share. If that vertex is the first vertex of all rows that have it, the coefficient of its first coordinate is a
//! sum: one row's derivative in its row's place, row by row. If no other row has a first vertex before, only its
//! coordinates remain, and for one monomial after the other the coefficient is a sum over all ways to share the
//! monomial's factors among the rows.

use std::ops::ControlFlow;

use predicament_arithmetic::dyadic::{
    Number, Space,
    Take::{self, Minus, Plus},
};
use predicament_predicates::{Axis, Dimension, Question, Scene, Sign, Vertex};
use smallvec::{SmallVec, smallvec};

use super::place::{Place, depend};
use super::row::{Row, Rows, point};

/// The maximum number of determinants that are tried.
const MOST: usize = 40;

/// The result for a tie.
pub(super) enum Known {
    /// The sign, and the degree of the deciding monomial.
    Broken(Sign, usize),
    /// The determinant is zero wherever the input vertices are.
    Identity,
    /// The tie remains open.
    Open,
}

/// The columns of a question's determinant, by axis; the last one is the weight.
///
/// # Panics
/// If the question is about circles or spheres.
pub(super) fn columns<const N: usize>(dimension: usize, question: Question) -> [usize; N] {
    let mut columns = [dimension; N];
    match question {
        Question::Compare(axis) => columns[0] = axis.index(),
        Question::Orient2d(plane) => columns[..2].copy_from_slice(&plane.axes().map(Axis::index)),
        Question::Orient3d => columns[..3].copy_from_slice(&[0, 1, 2]),
        Question::Incircle | Question::Insphere | Question::Derived(_) => {
            panic!("{} is about input vertices", question.kind())
        }
    }
    columns
}

/// A point of a question.
#[derive(Clone, Copy)]
pub(super) enum Point<'a, const N: usize> {
    /// An input vertex: its coordinates and a weight of one, and the axes.
    Input([Number<'a>; N], [usize; N]),
    Meet(&'a Row, [usize; N]),
}

impl<'a, const N: usize> Point<'a, N> {
    /// The point of a place, with the row of its vertex if it is constructed; `None` if that is missing.
    pub(super) fn new(
        held: &'a mut [u64; 2 * 3],
        scene: &Scene,
        place: &Place,
        row: Option<&'a Row>,
        shift: i32,
        columns: [usize; N],
    ) -> Option<Point<'a, N>> {
        let Place::Input(v) = place else { return row.map(|row| Point::Meet(row, columns)) };
        let space = &mut Space::new(held);
        let coordinates: [Number; 3] = match scene.dimension() {
            Dimension::Two => {
                let [x, y] = point::<2>(space, scene, *v, shift);
                [x, y, Number::ONE]
            }
            Dimension::Three => point::<3>(space, scene, *v, shift),
        };
        let mut row = [Number::ONE; N];
        for (entry, &column) in row.iter_mut().zip(&columns[..N - 1]) {
            *entry = coordinates[column];
        }
        Some(Point::Input(row, columns))
    }

    /// The unperturbed row for 0, or its derivative for 1, 2….
    ///
    /// The derivatives are by coordinates 0, 1… of the row's first vertex.
    pub(super) fn vector(&self, which: usize) -> [Number<'a>; N] {
        match (self, which) {
            (Point::Input(row, _), 0) => *row,
            (Point::Input(_, columns), axis) => {
                columns.map(|column| if column + 1 == axis { Number::ONE } else { Number::ZERO })
            }
            (Point::Meet(row, columns), which) => row.vector(which, *columns),
        }
    }

    /// The exponents [l, t]: entries of all vectors are multiples of 2^(64·l) and below 2^(64·t).
    pub(super) fn span(&self) -> [i32; 2] {
        match self {
            Point::Input(row, _) => {
                let whole = [0, 1];
                row.iter().filter(|x| !x.is_zero()).fold(whole, |[low, top], x| [low.min(x.low), top.max(x.top())])
            }
            Point::Meet(row, _) => row.span,
        }
    }
}

/// Tries to find the sign of a determinant of which all monomials below the degree `least` are zero.
///
/// # Panics
/// If the scene lacks a vertex, or the question is about circles or spheres.
pub(super) fn decide<const N: usize>(
    scene: &Scene,
    rows: &Rows,
    question: Question,
    args: [Vertex; N],
    least: usize,
) -> Known {
    let dimension = scene.dimension().count();
    let columns = columns(dimension, question);
    let meets = args.map(|v| v.construction().map(|index| rows.of(scene, index)));
    // A constructed vertex whose simplest definition is an input vertex is that input vertex.
    let places: [Place; N] = std::array::from_fn(|at| meets[at].map_or(Place::Input(args[at]), |row| row.place));
    if depend(question, &places) {
        return Known::Identity;
    }
    let mut held = [[0; 2 * 3]; N];
    let mut points: SmallVec<[Point<N>; 4]> = SmallVec::new();
    let mut inputs: SmallVec<[&[Vertex]; 4]> = SmallVec::new();
    let shift = rows.shift(scene);
    for ((place, held), row) in places.iter().zip(&mut held).zip(&meets) {
        let Some(point) = Point::new(held, scene, place, *row, shift, columns) else { return Known::Open };
        points.push(point);
        inputs.push(match (place, row) {
            (Place::Meet(_), Some(row)) => &row.inputs,
            (Place::Input(v), _) => std::slice::from_ref(v),
            (Place::Meet(_), None) => return Known::Open,
        });
    }
    let shared = first_shared(&inputs);
    let steps = steps(dimension, &points, &inputs, shared);
    let mut search = Search::new(points, steps, least);
    match search.products(search.steps.len(), &mut [None; N], 0) {
        ControlFlow::Break(known) => return known,
        ControlFlow::Continue(()) => {}
    }
    match shared {
        Some(shared) => search.sums(dimension, &inputs, shared),
        None => Known::Open,
    }
}

/// The smallest vertex that two rows share.
fn first_shared(inputs: &[&[Vertex]]) -> Option<Vertex> {
    let mut first: Option<Vertex> = None;
    for (at, these) in inputs.iter().enumerate() {
        for those in &inputs[at + 1..] {
            let (mut i, mut j) = (0, 0);
            while let (Some(&u), Some(&v)) = (these.get(i), those.get(j)) {
                if u == v {
                    first = Some(first.map_or(u, |first| first.min(u)));
                    break;
                }
                if u < v { i += 1 } else { j += 1 }
            }
        }
    }
    first
}

/// A monomial of one row that is larger than those of any vertex that it shares.
#[derive(Clone, Copy)]
struct Step {
    /// The sort key; larger for a smaller monomial.
    order: usize,
    row: usize,
    /// The derivative; `None` for the rest.
    vector: Option<usize>,
}

/// All steps above those of the first vertex that rows share, the largest first.
fn steps<const N: usize>(
    dimension: usize,
    points: &[Point<N>],
    inputs: &[&[Vertex]],
    shared: Option<Vertex>,
) -> SmallVec<[Step; 16]> {
    // A rest comes just before the next vertex' first coordinate, or just after the first one's.
    let order = |v: Vertex, axis: usize| 2 * (dimension * v.index() + axis) + 1;
    let end = shared.map_or(usize::MAX, |v| order(v, 0) - 1);
    let mut steps: SmallVec<[Step; 16]> = SmallVec::new();
    for (row, (point, inputs)) in points.iter().zip(inputs).enumerate() {
        let is_linear = match point {
            Point::Input(..) => true,
            Point::Meet(row, _) => row.is_linear,
        };
        let axes = if is_linear { dimension } else { 1 };
        steps.extend((0..axes).map(|axis| Step { order: order(inputs[0], axis), row, vector: Some(axis + 1) }));
        if !is_linear {
            steps.push(Step { order: order(inputs[0], 0) + 1, row, vector: None });
        } else if let Some(&second) = inputs.get(1) {
            steps.push(Step { order: order(second, 0) - 1, row, vector: None });
        }
    }
    steps.retain(|step| step.order < end);
    steps.sort_unstable_by_key(|step| step.order);
    steps
}

/// The factor of a row in a product.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factor {
    /// A derivative.
    Vector(usize),
    Rest,
}

struct Search<'a, const N: usize> {
    points: SmallVec<[Point<'a, N>; 4]>,
    steps: SmallVec<[Step; 16]>,
    /// The lowest degree to try.
    least: usize,
    /// The number of limbs that all rows span together.
    span: usize,
    /// True if two unperturbed points are equal; `None` until a pair has been compared.
    same: [[Option<bool>; N]; N],
    tried: usize,
}

impl<'a, const N: usize> Search<'a, N> {
    fn new(points: SmallVec<[Point<'a, N>; 4]>, steps: SmallVec<[Step; 16]>, least: usize) -> Search<'a, N> {
        let spans = points.iter().map(|point| {
            let [low, top] = point.span();
            usize::try_from(top - low).unwrap_or(0)
        });
        let span = spans.sum();
        Search { points, steps, least, span, same: [[None; N]; N], tried: 0 }
    }

    /// Tries the products of the steps before `before` with the factors that rows have already; the largest first.
    fn products(&mut self, before: usize, factors: &mut [Option<Factor>; N], degree: usize) -> ControlFlow<Known> {
        if degree >= self.least {
            self.attempt(factors, degree)?;
        }
        for at in 0..before {
            let Step { row, vector, .. } = self.steps[at];
            if factors[row].is_none() {
                factors[row] = Some(vector.map_or(Factor::Rest, Factor::Vector));
                self.products(at, factors, degree + 1)?;
                factors[row] = None;
            }
        }
        ControlFlow::Continue(())
    }

    /// Breaks with an answer unless this product's coefficient is known to be zero.
    fn attempt(&mut self, factors: &[Option<Factor>; N], degree: usize) -> ControlFlow<Known> {
        let still = |at: &usize| factors[*at].is_none();
        let pairs = || (0..N).filter(still).flat_map(move |i| (i + 1..N).filter(still).map(move |j| (i, j)));
        if pairs().any(|(i, j)| self.same[i][j] == Some(true)) {
            return ControlFlow::Continue(());
        }
        let has_rest = factors.contains(&Some(Factor::Rest));
        if !has_rest {
            if self.tried == MOST {
                return ControlFlow::Break(Known::Open);
            }
            self.tried += 1;
            let rows = std::array::from_fn(|at| {
                let which = match factors[at] {
                    Some(Factor::Vector(which)) => which,
                    _ => 0,
                };
                self.points[at].vector(which)
            });
            let sign = sign_of_sum(&[rows], self.span);
            if !sign.is_zero() {
                return ControlFlow::Break(Known::Broken(sign, degree));
            }
        }
        // The next ones may be zero for the same reason. Two points of a comparison are always at one place.
        let mut is_zero = !has_rest;
        for (i, j) in pairs() {
            if self.same[i][j].is_none() {
                let same = N > 2 && self.are_same(i, j);
                self.same[i][j] = Some(same);
                is_zero |= same;
            }
        }
        if is_zero { ControlFlow::Continue(()) } else { ControlFlow::Break(Known::Open) }
    }

    /// The result from the first vertex that rows share, if all steps above it have been tried.
    fn sums(&mut self, dimension: usize, inputs: &[&[Vertex]], shared: Vertex) -> Known {
        let sharing: SmallVec<[usize; 4]> = (0..N).filter(|&at| inputs[at].contains(&shared)).collect();
        if sharing.iter().any(|&at| inputs[at][0] != shared) {
            return Known::Open;
        }
        let is_linear = |at: &usize| match &self.points[*at] {
            Point::Input(..) => true,
            Point::Meet(row, _) => row.is_linear,
        };
        // Monomials after its first coordinate also have factors of other rows' first vertices, or powers of it that
        // rows don't store.
        let only_first = !self.steps.is_empty() || !sharing.iter().all(is_linear);
        let most = if only_first { 1 } else { sharing.len() };
        // Degrees in its coordinates: the last one is the smallest infinitesimal.
        for last in 0..=if dimension == 3 { most } else { 0 } {
            for middle in 0..=most - last {
                for first in 0..=most - last - middle {
                    let degrees = [first, middle, last];
                    let degree = first + middle + last;
                    if degree == 0 {
                        continue;
                    }
                    let mut terms: SmallVec<[[[Number<'a>; N]; N]; 4]> = SmallVec::new();
                    self.share(&sharing, degrees, &mut std::array::from_fn(|at| self.points[at].vector(0)), &mut terms);
                    if terms.len() > MOST {
                        return Known::Open;
                    }
                    let sign = sign_of_sum(&terms, self.span);
                    if !sign.is_zero() {
                        return Known::Broken(sign, degree);
                    }
                    if only_first {
                        return Known::Open;
                    }
                }
            }
        }
        Known::Open
    }

    /// Enumerates all ways to give the rows the derivatives by each coordinate.
    fn share(
        &self,
        sharing: &[usize],
        degrees: [usize; 3],
        rows: &mut [[Number<'a>; N]; N],
        terms: &mut SmallVec<[[[Number<'a>; N]; N]; 4]>,
    ) {
        let left: usize = degrees.iter().sum();
        if left == 0 {
            terms.push(*rows);
            return;
        }
        let Some((&row, others)) = sharing.split_first() else { return };
        if left <= others.len() {
            self.share(others, degrees, rows, terms);
        }
        for axis in 0..3 {
            if degrees[axis] > 0 {
                let mut degrees = degrees;
                degrees[axis] -= 1;
                let still = rows[row];
                rows[row] = self.points[row].vector(axis + 1);
                self.share(others, degrees, rows, terms);
                rows[row] = still;
            }
        }
    }

    /// Returns true if two points are equal without perturbation.
    fn are_same(&self, i: usize, j: usize) -> bool {
        let [p, q] = [i, j].map(|at| self.points[at].vector(0));
        // A product spans at most as much as both rows; two bits more are for the sum and its sign.
        let mut limbs: SmallVec<[u64; 64]> = smallvec![0; (N - 1) * (self.span + 1)];
        let space = &mut Space::new(&mut limbs);
        (0..N - 1).all(|at| Number::sum(space, [(p[at], q[N - 1], Plus), (p[N - 1], q[at], Minus)]).is_zero())
    }
}

/// The sign of a sum of determinants, whose rows span this many limbs together.
///
/// Let the entries of row i be multiples of 2^(64·l_i) and less than 2^(64·t_i). A determinant sums products of one
/// entry of each row, at most 24, in two steps; up to 2^6 of them are added, enough for 40. 5 + 6 bits and those
/// for rounding up the number of terms and for signs, three in each step, fit one limb more than all rows span.
pub(super) fn sign_of_sum<const N: usize>(terms: &[[[Number; N]; N]], span: usize) -> Sign {
    let each = match N {
        2 => 1,
        3 => 4,
        _ => 13,
    };
    let all = if terms.len() == 1 { each } else { (each + 1) * terms.len() };
    let mut limbs: SmallVec<[u64; 256]> = smallvec![0; all * (span + 1)];
    let space = &mut Space::new(&mut limbs);
    let mut terms = terms.iter();
    let mut sum = terms.next().map_or(Number::ZERO, |rows| determinant(space, rows));
    for rows in terms {
        let next = determinant(space, rows);
        sum = Number::sum(space, [(sum, Number::ONE, Plus), (next, Number::ONE, Plus)]);
    }
    Sign::from(sum.cmp0())
}

/// The determinant: one sum for two rows, four for three, 13 for four.
fn determinant<'a, const N: usize>(space: &mut Space<'a>, rows: &[[Number<'a>; N]; N]) -> Number<'a> {
    let mut minor = |i: usize, j: usize, [a, b]: [usize; 2]| {
        Number::sum(space, [(rows[i][a], rows[j][b], Plus), (rows[i][b], rows[j][a], Minus)])
    };
    match N {
        2 => minor(0, 1, [0, 1]),
        3 => {
            let minors = [[1, 2], [2, 0], [0, 1]].map(|columns| minor(1, 2, columns));
            Number::sum(space, [0, 1, 2].map(|at| (rows[0][at], minors[at], Plus)))
        }
        _ => {
            // Laplace: the complement of the k-th pair is the k-th from the end.
            const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
            const TAKES: [Take; 6] = [Plus, Minus, Plus, Plus, Minus, Plus];
            let mut terms = [(Number::ZERO, Number::ZERO, Plus); 6];
            for (at, columns) in PAIRS.into_iter().enumerate() {
                terms[at].0 = minor(0, 1, columns);
                terms[5 - at].1 = minor(2, 3, columns);
                terms[at].2 = TAKES[at];
            }
            Number::sum(space, terms)
        }
    }
}

#[cfg(test)]
mod tests;
