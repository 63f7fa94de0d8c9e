//! Minors with a lift column, by a filter or in integers.
//!
//! Coordinates over a common power of two are integers, the lift shrinks by that power squared, and the minor keeps its
//! sign. If the vertices of a query, including the origin, span 61 bits, machine integers suffice, and nothing is
//! allocated; otherwise the integers have any length. Only ties that the exact backend could not resolve by doubles get
//! here.

use std::cell::OnceCell;

use predicament_arithmetic::{Fixed, short_rows};
use predicament_predicates::{Axis, Scene, Sign, Vertex};

use crate::Lift;
use crate::filter::{self, Struck};
use crate::integer::Integer;
use crate::short::{self, sign};
use crate::whole;

/// The maximum number of vertices of a predicate, and of axes.
pub(crate) const PLACES: usize = 5;
const AXES: usize = 3;

/// The vertices of a query, read when a lifted minor is first needed.
pub(crate) struct Lifted<'a> {
    scene: &'a Scene,
    axes: &'a [Axis],
    sorted: &'a [Vertex],
    points: OnceCell<Points>,
    integers: OnceCell<Integers>,
}

/// The points, with one more than the maximum: the origin.
type Points = [[f64; AXES]; PLACES + 1];

enum Integers {
    /// Coordinates less than 2^61 in magnitude.
    Short([[Fixed<1>; AXES]; PLACES + 1]),
    Long(Box<[Integer; PLACES * AXES]>),
}

impl<'a> Lifted<'a> {
    pub fn new(scene: &'a Scene, axes: &'a [Axis], sorted: &'a [Vertex]) -> Lifted<'a> {
        Lifted { scene, axes, sorted, points: OnceCell::new(), integers: OnceCell::new() }
    }

    /// The sign of the determinant with one row for each of `rows`: the coordinates along `columns`, the lift, and 1.
    ///
    /// Rows are places among the sorted vertices, columns are places among the axes.
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

    /// The sign, if exactly one column was struck and the filter or short integers decide.
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
                filter::flat(points, column, struck).or_else(|| short::flat(points, column, struck))
            }
            (3, &[p, q, r, s], &[x, y]) => {
                let columns = [x, y].map(usize::from);
                let (points, struck) = ([at(p), at(q), at(r), at(s)], struck(3 - columns[0] - columns[1]));
                filter::solid(points, columns, struck).or_else(|| short::solid(points, columns, struck))
            }
            _ => None,
        }
    }
}

#[cold]
fn long(points: Points) -> Integers {
    let flat: [f64; PLACES * AXES] = std::array::from_fn(|i| points[i / AXES][i % AXES]);
    Integers::Long(Box::new(whole::integers(flat)))
}

/// The sign in integers of a fixed size, for coordinates less than M = 2^61.
///
/// Entries of differences are less than 2M = 2^62, those of the lift less than 3·(2M)² < 2^126, and determinants less
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

fn long_sign(points: &[Integer; PLACES * AXES], rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
    let coordinate = |row: u8, axis: usize| &points[usize::from(row) * AXES + axis];
    let entries = |&row: &u8| -> Vec<Integer> {
        let mut entries: Vec<Integer> = columns.iter().map(|&c| coordinate(row, usize::from(c)).clone()).collect();
        let mut lifted = Integer::ZERO;
        for (axis, origin) in lift.about.into_iter().enumerate() {
            let entry = coordinate(row, axis);
            let difference = origin.map_or_else(|| entry.clone(), |origin| entry - coordinate(origin, axis));
            lifted.add_product(&difference, &difference);
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

/// The determinant of `rows` restricted to `columns`, expanded along the first row.
fn determinant(rows: &[Vec<Integer>], columns: &mut Vec<usize>) -> Integer {
    let Some((first, rest)) = rows.split_first() else {
        return Integer::ONE;
    };
    let mut sum = Integer::ZERO;
    for place in 0..columns.len() {
        let column = columns.remove(place);
        if !first[column].is_zero() {
            let minor = determinant(rest, columns);
            sum.add_product(&if place.is_multiple_of(2) { minor } else { -minor }, &first[column]);
        }
        columns.insert(place, column);
    }
    sum
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Dimension;

    use super::*;
    use crate::{Term, definition};

    /// A pseudo-random integer below n, by the place in a sequence.
    fn digit(at: usize, n: i32) -> i32 {
        let mixed = u64::try_from(at).unwrap().wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        i32::try_from((mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 40 & 0xffff).unwrap() % n
    }

    /// The determinant of a square matrix, expanded along its first row.
    fn expanded(matrix: &[Vec<i128>]) -> i128 {
        let Some((first, rest)) = matrix.split_first() else { return 1 };
        let minor = |without: usize| {
            let rows = rest.iter().map(|row| [&row[..without], &row[without + 1..]].concat());
            expanded(&rows.collect::<Vec<_>>())
        };
        (0..first.len()).map(|at| first[at] * minor(at) * if at.is_multiple_of(2) { 1 } else { -1 }).sum()
    }

    /// The sign of the minor by definition: coordinates, the lift, and 1.
    fn defined(points: &[[i128; 3]], rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
        let row = |&row: &u8| -> Vec<i128> {
            let point = points[usize::from(row)];
            let origin = lift.about.map(|about| about.map(usize::from));
            let square = |axis: usize| (point[axis] - origin[axis].map_or(0, |about| points[about][axis])).pow(2);
            let coordinates = columns.iter().map(|&column| point[usize::from(column)]);
            coordinates.chain([(0..3).map(square).sum(), 1]).collect()
        };
        let value = expanded(&rows.iter().map(row).collect::<Vec<_>>());
        Sign::from(value.cmp(&0))
    }

    /// Compares the results of all methods, and counts how often doubles decide.
    fn ways(dimension: Dimension, size: i32, unit: f64) -> [usize; 4] {
        let axes: &[Axis] =
            if dimension == Dimension::Two { &[Axis::X, Axis::Y] } else { &[Axis::X, Axis::Y, Axis::Z] };
        let minors: &[(&[u8], &[u8])] = match dimension {
            Dimension::Two => {
                &[(&[0, 2], &[]), (&[1, 3], &[]), (&[0, 1, 3], &[0]), (&[1, 2, 3], &[1]), (&[0, 1, 2], &[0])]
            }
            Dimension::Three => &[
                (&[0, 4], &[]),
                (&[1, 2, 4], &[0]),
                (&[0, 3, 4], &[2]),
                (&[0, 1, 2, 3], &[0, 1]),
                (&[1, 2, 3, 4], &[0, 2]),
                (&[0, 2, 3, 4], &[1, 2]),
            ],
        };
        let mut seen = [0; 4];
        for round in 0..400 {
            let whole: Vec<[i128; 3]> = (0..5)
                .map(|point| {
                    let place = |axis: usize| digit(31 * round + 5 * point + axis, 2 * size + 1) - size;
                    [0, 1, 2].map(|axis| if axis < axes.len() { i128::from(place(axis)) } else { 0 })
                })
                .collect();
            let coordinates = whole.iter().flat_map(|point| &point[..axes.len()]);
            let coordinates = coordinates.map(|&x| f64::from(i32::try_from(x).unwrap()) * unit).collect();
            let scene = Scene::new(dimension, coordinates).unwrap();
            let sorted: Vec<Vertex> = (0..5).map(Vertex::input).collect();
            let lifted = Lifted::new(&scene, axes, &sorted);
            let points = lifted.read();
            for (at, &(rows, columns)) in minors.iter().enumerate() {
                let about = [0, 1, 2].map(|axis: usize| {
                    let row = u8::try_from(digit(7 * round + 3 * at + axis, 6)).unwrap();
                    (row < 5 && axis < axes.len()).then_some(row)
                });
                let lift = Lift { about };
                let truth = defined(&whole, rows, columns, lift);
                let what = format!("{rows:?} {columns:?} {lift:?} of {whole:?} by {unit:e}");
                assert_eq!(lifted.sign(rows, columns, lift), truth, "{what}");
                let Integers::Long(integers) = long(points) else { unreachable!("long ones are asked for") };
                assert_eq!(long_sign(&integers, rows, columns, lift), truth, "long: {what}");
                if let Some(points) = short_rows(points) {
                    assert_eq!(short_sign(&points, rows, columns, lift), truth, "short: {what}");
                    seen[0] += 1;
                }
                if let Some(sign) = lifted.quick(&points, rows, columns, lift) {
                    assert_eq!(sign, truth, "quick: {what}");
                    seen[1] += 1;
                }
                seen[2] += usize::from(truth.is_zero());
                seen[3] += 1;
            }
        }
        seen
    }

    #[test]
    fn minors_with_a_lift_are_what_they_are_defined_as() {
        for (dimension, quick) in [(Dimension::Two, 3), (Dimension::Three, 3)] {
            for (size, unit) in [(2, 1.0), (2, 0.25), (2000, 1.0), (2000, f64::from_bits((1023 + 300) << 52))] {
                let [short, quickly, zeros, all] = ways(dimension, size, unit);
                assert_eq!(short, all, "integers of a machine suffice");
                // Minors that lack one column are three of five, or of six; nearly all of these are quick.
                let quick = 390 * quick..=400 * quick;
                assert!(quick.contains(&quickly), "{quickly} of {all} in {dimension:?}, size {size}, by {unit:e}");
                assert!(size > 2 || zeros > 100, "{zeros} zeros");
            }
        }
    }

    /// Coordinates of all sizes, where nothing but integers of any length decides, against rationals of GMP.
    #[test]
    fn long_integers_are_rationals_over_one_denominator() {
        let mut seen = [0; 3];
        for round in 0..predicament_effort::scaled(2000) {
            let at = |place: usize, n: i32| digit(37 * round + place, n);
            let coordinate = |place: usize| {
                let exponent = [0, 0, 1, -1000, 900][usize::try_from(at(place, 5)).unwrap()];
                f64::from(at(place + 16, 5) - 2) * 1.1 * 2_f64.powi(exponent)
            };
            let points: [[f64; 3]; 5] =
                std::array::from_fn(|point| std::array::from_fn(|axis| coordinate(3 * point + axis)));
            let about = [0, 1, 2].map(|axis: usize| u8::try_from(at(32 + axis, 6)).ok().filter(|&row| row < 5));
            let (rows, columns): (&[u8], &[u8]) =
                [(&[0, 4][..], &[][..]), (&[1, 2, 4], &[0]), (&[0, 1, 2, 3], &[0, 1])][round % 3];
            let lift = Lift { about };
            let mut all = [[0.0; AXES]; PLACES + 1];
            all[..PLACES].copy_from_slice(&points);
            let Integers::Long(integers) = long(all) else { unreachable!("long ones are asked for") };
            let term = Term { sign: Sign::Positive, rows, columns, lift: Some(lift), gap: None };
            let truth = Sign::from(definition::minor(&points, &term).cmp0());
            assert_eq!(long_sign(&integers, rows, columns, lift), truth, "{rows:?} {lift:?} of {points:?}");
            seen[match truth {
                Sign::Negative => 0,
                Sign::Zero => 1,
                Sign::Positive => 2,
            }] += 1;
        }
        assert!(seen.iter().all(|&count| count > 0), "{seen:?}");
    }

    #[test]
    fn what_spans_too_much_for_a_machine_is_long() {
        let far = [1.0, 0.0, 3.0, 1e30, -2.0, 1.0, 5.0, 1e-30, 0.0, 0.0];
        let scene = Scene::new(Dimension::Two, far.to_vec()).unwrap();
        let sorted: Vec<Vertex> = (0..5).map(Vertex::input).collect();
        let lifted = Lifted::new(&scene, &[Axis::X, Axis::Y], &sorted);
        assert!(short_rows(lifted.read()).is_none());
        // 1 + 0 against 9 + 10^60, about the origin, and about the second.
        let sign = |rows: &[u8], about| lifted.sign(rows, &[], Lift { about });
        assert_eq!(sign(&[0, 1], [None; 3]), Sign::Negative);
        assert_eq!(sign(&[0, 1], [Some(1), Some(1), None]), Sign::Positive);
        // 25 + 10^-60 against 25, about the last and about the first.
        assert_eq!(sign(&[3, 4], [Some(4), Some(4), None]), Sign::Positive);
        assert_eq!(sign(&[3, 4], [Some(3), Some(3), None]), Sign::Negative);
    }
}
