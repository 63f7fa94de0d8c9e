//! Minors with a lift column, in integers.
//!
//! Only ties get here, so this is plain exact arithmetic without a filter. All
//! coordinates are multiples of one power of two, 2^s. Divided by it they are
//! integers, the lift shrinks by 2^2s, and the minor keeps its sign.

use predicament_arithmetic::Scaled;
use predicament_predicates::{Axis, Scene, Sign, Vertex};
use rug::Integer;

use crate::Lift;

/// The most vertices and axes that a predicate takes.
const PLACES: usize = 5;
const AXES: usize = 3;

/// The sign of the determinant with one row for each of `rows`: the
/// coordinates along `columns`, the lift, and 1. Rows are places in `sorted`,
/// columns are places in `axes`.
pub(crate) fn sign(scene: &Scene, axes: &[Axis], sorted: &[Vertex], rows: &[u8], columns: &[u8], lift: Lift) -> Sign {
    let mut points = [[0.0; AXES]; PLACES];
    for (point, &vertex) in points.iter_mut().zip(sorted) {
        for (value, &axis) in point.iter_mut().zip(axes) {
            *value = scene.coordinate(axis, vertex);
        }
    }
    let Scaled { integers, .. } = Scaled::new(points).expect("a scene's coordinates are finite");
    let coordinate = |row: u8, axis: usize| &integers[usize::from(row)][axis];

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
    // Subtracting the last row strikes it together with the column of ones.
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
