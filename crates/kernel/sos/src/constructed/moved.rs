//! Determinants of a scene whose vertices are moved by infinitesimals.
//!
//! This module does not depend on the kind of move: coordinates are [`Series`], and everything is a polynomial of them.
//! A constructed vertex is a homogeneous row, its coordinates times its weight and the weight; an input vertex has
//! weight one.

use predicament_predicates::{Axis, Construction, Dimension, Question, Vertex};

use smallvec::{SmallVec, smallvec};

use super::place::Place;
use super::series::{Coefficient, Cut, Number};

/// The input vertices that define places, each once, in ascending order.
pub(super) fn inputs(places: &[Place]) -> Vec<Vertex> {
    let mut inputs: Vec<Vertex> = places.iter().flat_map(Place::vertices).collect();
    inputs.sort_unstable();
    inputs.dedup();
    inputs
}

/// Input vertices in their moved positions.
pub(super) struct Moved<'q, S> {
    pub(super) dimension: Dimension,
    pub(super) cut: &'q Cut,
    /// The input vertices, ascending.
    pub(super) inputs: &'q [Vertex],
    /// The coordinates, vertex after vertex.
    pub(super) coordinates: &'q [S],
}

/// Coordinates times the weight, then the weight.
type Row<S> = SmallVec<[S; 4]>;

impl<S: Number> Moved<'_, S> {
    /// The determinant behind a question, times the weights of all vertices.
    pub(super) fn determinant(&self, question: Question, args: &[Place]) -> S {
        let rows = |axes: &[Axis]| -> SmallVec<[Row<S>; 4]> {
            let row = |place: &Place| {
                let all = self.row(place);
                let weight = all.last().cloned().expect("a row has a weight");
                axes.iter().map(|axis| all[axis.index()].clone()).chain([weight]).collect()
            };
            args.iter().map(row).collect()
        };
        match question {
            Question::Compare(axis) => self.minor(&rows(&[axis]), [0, 1], [0, 1]),
            Question::Orient2d(plane) => self.turn(&rows(&plane.axes())),
            Question::Orient3d => self.side(&rows(&[Axis::X, Axis::Y, Axis::Z])),
            Question::Incircle | Question::Insphere | Question::Derived(_) => {
                let input = |place: &Place| match place {
                    Place::Input(v) => *v,
                    Place::Meet(construction) => panic!("no circle goes through {construction}"),
                };
                let (last, others) = args.split_last().expect("circles take vertices");
                let row = |place: &Place| {
                    let mut row = self.minus(input(place), input(last));
                    row.push(self.dot(&row, &row));
                    row
                };
                self.laplace(&others.iter().map(row).collect::<Vec<_>>(), 0)
            }
        }
    }

    /// The weight of a place.
    pub(super) fn weight(&self, place: &Place) -> S {
        self.row(place).pop().expect("a row has a weight")
    }

    /// The homogeneous row.
    pub(super) fn row(&self, place: &Place) -> Row<S> {
        let construction = match place {
            Place::Input(v) => {
                let one = self.whole(1);
                return self.point(*v).iter().cloned().chain([one]).collect();
            }
            Place::Meet(construction) => *construction,
        };
        match construction {
            Construction::Ssi([[p, q], [a, b]]) => {
                let from = |p| self.perp(&self.minus(b, a), &self.minus(p, a));
                self.between([p, q], [from(p), from(q)])
            }
            Construction::Lpi { line: [p, q], plane } => {
                let normal = self.normal(plane);
                let from = |p| self.dot(&normal, &self.minus(p, plane[0]));
                self.between([p, q], [from(p), from(q)])
            }
            Construction::Tpi(planes) => {
                let [n, o, p] = planes.map(|plane| self.normal(plane));
                let offsets = [(planes[0], &n), (planes[1], &o), (planes[2], &p)];
                let [d, e, f] = offsets.map(|(plane, normal)| self.dot(normal, self.point(plane[0])));
                let [op, pn, no] = [self.cross(&o, &p), self.cross(&p, &n), self.cross(&n, &o)];
                let along = |axis: usize| {
                    let [x, y, z] = [(&d, &op), (&e, &pn), (&f, &no)].map(|(d, n)| self.times(d, &n[axis]));
                    S::sum(S::sum(x, &y), &z)
                };
                smallvec![along(0), along(1), along(2), self.dot(&n, &op)]
            }
            Construction::Ratio { ends: [a, c], share } => {
                let ([p, q], [rest, _]) = (share.fraction(), share.rest().fraction());
                let [p, q, rest] = [p, q, rest].map(|x| self.whole(x));
                let along = self.point(a).iter().zip(self.point(c));
                along.map(|(a, c)| S::sum(self.times(a, &p), &self.times(c, &rest))).chain([q]).collect()
            }
        }
    }

    /// The numerator and denominator of a weight of a constructed vertex.
    ///
    /// The weights are in the order of [`Limit::weights`](super::Limit::weights).
    pub(super) fn fraction(&self, place: &Place, at: usize) -> [S; 2] {
        let zero = || self.whole(0);
        // The fraction of the way from f(p) to f(q) at which f = 0.
        let way = |at_p: S, at_q: S| [S::difference(zero(), &at_p), S::difference(at_q, &at_p)];
        match (*place, at) {
            (Place::Meet(Construction::Ssi([[p, q], [a, b]])), 0)
            | (Place::Meet(Construction::Ssi([[a, b], [p, q]])), 1) => {
                let from = |p| self.perp(&self.minus(b, a), &self.minus(p, a));
                way(from(p), from(q))
            }
            (Place::Meet(Construction::Lpi { line: [p, q], plane }), 0) => {
                let normal = self.normal(plane);
                let from = |p| self.dot(&normal, &self.minus(p, plane[0]));
                way(from(p), from(q))
            }
            (Place::Meet(Construction::Lpi { line: [p, q], plane: [a, b, c] }), 1..=3) => {
                let along = self.minus(q, p);
                let part = |b, c| self.dot(&self.cross(&along, &self.minus(b, p)), &self.minus(c, p));
                let parts = [part(b, c), part(c, a), part(a, b)];
                let whole = parts.iter().fold(zero(), S::sum);
                [parts[at - 1].clone(), whole]
            }
            _ => panic!("no weight {at} of {place:?}"),
        }
    }

    /// The row of the point of line p, q at distance zero from a line or plane.
    ///
    /// The point is (p·f(q) − q·f(p)) / (f(q) − f(p)).
    fn between(&self, [p, q]: [Vertex; 2], [at_p, at_q]: [S; 2]) -> Row<S> {
        let along = self.point(p).iter().zip(self.point(q));
        let coordinates = along.map(|(p, q)| S::difference(self.times(p, &at_q), &self.times(q, &at_p)));
        let mut row: Row<S> = coordinates.collect();
        row.push(S::difference(at_q, &at_p));
        row
    }

    fn point(&self, v: Vertex) -> &[S] {
        let place = self.inputs.binary_search(&v).expect("a vertex of the question");
        let stride = match self.dimension {
            Dimension::Two => 2,
            Dimension::Three => 3,
        };
        &self.coordinates[place * stride..][..stride]
    }

    fn minus(&self, a: Vertex, b: Vertex) -> Row<S> {
        self.point(a).iter().zip(self.point(b)).map(|(a, b)| S::difference(a.clone(), b)).collect()
    }

    fn whole(&self, n: i64) -> S {
        S::constant(self.cut, S::Coefficient::whole(n))
    }

    fn times(&self, a: &S, b: &S) -> S {
        a.times(b, self.cut)
    }

    /// The product x₁y₂ − y₁x₂.
    fn perp(&self, a: &[S], b: &[S]) -> S {
        S::difference(self.times(&a[0], &b[1]), &self.times(&a[1], &b[0]))
    }

    fn cross(&self, a: &[S], b: &[S]) -> [S; 3] {
        [[1, 2], [2, 0], [0, 1]].map(|[i, j]| S::difference(self.times(&a[i], &b[j]), &self.times(&a[j], &b[i])))
    }

    fn dot(&self, a: &[S], b: &[S]) -> S {
        let zero = self.whole(0);
        a.iter().zip(b).fold(zero, |total, (a, b)| S::sum(total, &self.times(a, b)))
    }

    fn normal(&self, [a, b, c]: [Vertex; 3]) -> [S; 3] {
        self.cross(&self.minus(b, a), &self.minus(c, a))
    }

    /// The determinant of the columns from `column` on.
    fn laplace(&self, rows: &[Row<S>], column: usize) -> S {
        if let [row] = rows {
            return row[column].clone();
        }
        let mut total = self.whole(0);
        for at in 0..rows.len() {
            let rest = [&rows[..at], &rows[at + 1..]].concat();
            let product = self.times(&rows[at][column], &self.laplace(&rest, column + 1));
            total = if at % 2 == 0 { S::sum(total, &product) } else { S::difference(total, &product) };
        }
        total
    }

    /// The minor of two rows and two columns.
    fn minor(&self, rows: &[Row<S>], [r, s]: [usize; 2], [i, j]: [usize; 2]) -> S {
        S::difference(self.times(&rows[r][i], &rows[s][j]), &self.times(&rows[r][j], &rows[s][i]))
    }

    /// The determinant of three rows, expanded along the last row.
    fn turn(&self, rows: &[Row<S>]) -> S {
        let term = |at: usize, columns| self.times(&rows[2][at], &self.minor(rows, [0, 1], columns));
        S::sum(S::difference(term(0, [1, 2]), &term(1, [0, 2])), &term(2, [0, 1]))
    }

    /// The determinant of four rows: minors of the first two rows times minors of the other two.
    fn side(&self, rows: &[Row<S>]) -> S {
        // The complement of a pair is as far from the end; its sign is that of the sum of its places.
        const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
        let zero = self.whole(0);
        PAIRS.iter().zip(PAIRS.iter().rev()).fold(zero, |total, (&pair, &other)| {
            let product = self.times(&self.minor(rows, [0, 1], pair), &self.minor(rows, [2, 3], other));
            if (pair[0] + pair[1]) % 2 == 1 { S::sum(total, &product) } else { S::difference(total, &product) }
        })
    }
}
