//! Minors with a lift column, by a filter or in integers.
//!
//! Coordinates over a common power of two are integers, the lift shrinks by
//! that power squared, and the minor keeps its sign. Where the vertices of a
//! query span 61 bits, the origin among them, the integers are those of a
//! machine, and nothing is allocated; else they are as long as they have to be.
//! Only ties that the exact backend could not see through get here.

use std::cell::OnceCell;

use predicament_arithmetic::{Fixed, Scaled, short_rows};
use predicament_predicates::{Axis, Scene, Sign, Vertex};
use rug::Integer;

use crate::Lift;
use crate::filter::{self, Struck};
use crate::short::{self, sign};

/// The most vertices and axes that a predicate takes.
pub(crate) const PLACES: usize = 5;
const AXES: usize = 3;

/// The vertices of a query, read as soon as a lifted minor is asked for.
pub(crate) struct Lifted<'a> {
    scene: &'a Scene,
    axes: &'a [Axis],
    sorted: &'a [Vertex],
    points: OnceCell<Points>,
    integers: OnceCell<Integers>,
}

/// With one more than there can be: the origin.
type Points = [[f64; AXES]; PLACES + 1];

enum Integers {
    /// Coordinates less than 2^61 in magnitude.
    Short([[Fixed<1>; AXES]; PLACES + 1]),
    Long(Box<[[Integer; AXES]; PLACES]>),
}

impl<'a> Lifted<'a> {
    pub fn new(scene: &'a Scene, axes: &'a [Axis], sorted: &'a [Vertex]) -> Lifted<'a> {
        Lifted { scene, axes, sorted, points: OnceCell::new(), integers: OnceCell::new() }
    }

    /// The sign of the determinant with one row for each of `rows`: the
    /// coordinates along `columns`, the lift, and 1. Rows are places among the
    /// sorted vertices, columns are places among the axes.
    pub fn sign(&self, rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
        let points = self.points.get_or_init(|| self.read());
        if let Some(sign) = self.quick(points, rows, columns, lift) {
            return sign;
        }
        let integers = || short_rows(*points).map_or_else(|| long(*points), Integers::Short);
        match self.integers.get_or_init(integers) {
            Integers::Short(points) => short_sign(points, rows, columns, lift),
            Integers::Long(points) => long_sign(points, rows, columns, lift),
        }
    }

    fn read(&self) -> Points {
        let mut points = [[0.0; AXES]; PLACES + 1];
        for (point, &vertex) in points.iter_mut().zip(self.sorted) {
            for (value, &axis) in point.iter_mut().zip(self.axes) {
                *value = self.scene.coordinate(axis, vertex);
            }
        }
        points
    }

    /// The sign, if one column was struck and the query is an ordinary one.
    fn quick(&self, points: &Points, rows: &[u8], columns: &[u8], lift: Lift) -> Option<Sign> {
        let at = |row: u8| &points[usize::from(row)];
        let struck = |column: usize| {
            let origin = lift.about[column].map_or(0.0, |about| at(about)[column]);
            Struck { column, origin }
        };
        match (self.axes.len(), rows, columns) {
            (2, &[p, q, r], &[x]) => {
                let column = usize::from(x);
                let (points, struck) = ([at(p), at(q), at(r)], struck(1 - column));
                filter::flat::<false, _>(points, column, struck).or_else(|| short::flat(points, column, struck))
            }
            (3, &[p, q, r, s], &[x, y]) => {
                let columns = [x, y].map(usize::from);
                let (points, struck) = ([at(p), at(q), at(r), at(s)], struck(3 - columns[0] - columns[1]));
                filter::solid::<false>(points, columns, struck).or_else(|| short::solid(points, columns, struck))
            }
            _ => None,
        }
    }
}

#[cold]
fn long(points: Points) -> Integers {
    let points: [[f64; AXES]; PLACES] = std::array::from_fn(|i| points[i]);
    let scaled = Scaled::new(points).expect("a scene's coordinates are finite");
    Integers::Long(Box::new(scaled.integers))
}

/// With coordinates less than M = 2^61: entries of differences are less than
/// 2M = 2^62, those of the lift less than 3·(2M)² < 2^126, and determinants less
/// than 6 · 2^62 · 2^62 · 2^127 < 2^254.
fn short_sign(points: &[[Fixed<1>; AXES]; PLACES + 1], rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
    let last = rows[rows.len() - 1];
    // Subtracting the last row strikes it together with the column of ones.
    let entry = |row: u8, column: u8| {
        let axis = usize::from(column);
        points[usize::from(row)][axis].minus(points[usize::from(last)][axis])
    };
    let lifted = |row: u8| {
        let mut sum = Fixed::<2>::ZERO;
        for (axis, about) in lift.about.into_iter().enumerate() {
            let origin = about.map_or(Fixed::ZERO, |about| points[usize::from(about)][axis]);
            let [p, q] = [row, last].map(|row| points[usize::from(row)][axis].minus(origin));
            let (p, q): (Fixed<2>, Fixed<2>) = (p.times(p), q.times(q));
            sum = sum.plus(p.minus(q));
        }
        sum
    };
    match (rows, columns) {
        (&[p, _], &[]) => sign(lifted(p)),
        (&[p, q, _], &[x]) => {
            let left: Fixed<3> = lifted(q).times(entry(p, x));
            sign(left.minus(lifted(p).times(entry(q, x))))
        }
        (&[p, q, r, _], &[x, y]) => {
            let term = |a: u8, b: u8, c: u8| -> Fixed<4> {
                let minor: Fixed<2> = entry(a, x).times(entry(b, y));
                minor.minus(entry(a, y).times(entry(b, x))).times(lifted(c))
            };
            sign(term(q, r, p).plus(term(r, p, q)).plus(term(p, q, r)))
        }
        _ => panic!("{rows:?} and {columns:?} make no minor with a lift"),
    }
}

fn long_sign(points: &[[Integer; AXES]; PLACES], rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
    let coordinate = |row: u8, axis: usize| &points[usize::from(row)][axis];
    let entries = |&row: &u8| -> Vec<Integer> {
        let mut entries: Vec<Integer> = columns.iter().map(|&c| coordinate(row, usize::from(c)).clone()).collect();
        let mut lifted = Integer::new();
        for (axis, origin) in lift.about.into_iter().enumerate() {
            match origin {
                Some(origin) => lifted += Integer::from(coordinate(row, axis) - coordinate(origin, axis)).square(),
                None => lifted += coordinate(row, axis).square_ref(),
            }
        }
        entries.push(lifted);
        entries
    };
    let mut matrix: Vec<Vec<Integer>> = rows.iter().map(entries).collect();
    // As above.
    let last = matrix.pop().unwrap_or_default();
    for row in &mut matrix {
        for (entry, subtrahend) in row.iter_mut().zip(&last) {
            *entry -= subtrahend;
        }
    }
    Sign::from(determinant(&matrix, &mut Vec::from_iter(0..last.len())).cmp0())
}

/// The determinant of `rows` restricted to `columns`, along the first row.
fn determinant(rows: &[Vec<Integer>], columns: &mut Vec<usize>) -> Integer {
    let Some((first, rest)) = rows.split_first() else {
        return Integer::from(1);
    };
    let mut sum = Integer::new();
    for place in 0..columns.len() {
        let column = columns.remove(place);
        if !first[column].is_zero() {
            let product = determinant(rest, columns) * &first[column];
            if place.is_multiple_of(2) {
                sum += product;
            } else {
                sum -= product;
            }
        }
        columns.insert(place, column);
    }
    sum
}
