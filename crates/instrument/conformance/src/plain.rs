//! Predicates in plain floating point, for the ranking: what a predicate has to beat.
//!
//! The determinants are those of textbooks, with the last point subtracted first. Constructed points are computed in
//! the same floating point and then treated as input points, as in most programs.

use std::ops::{Add, Div, Mul, Neg, Sub};

use predicament_predicates::Sign;

use crate::query::{Query, Subject};
use crate::{Answer, Number, Shape};

/// A floating-point type.
trait Float:
    Copy
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn of(x: f64) -> Self;
}

impl Float for f64 {
    fn of(x: f64) -> f64 {
        x
    }
}

impl Float for f32 {
    #[allow(clippy::cast_possible_truncation)] // rounding is the purpose
    fn of(x: f64) -> f32 {
        x as f32
    }
}

/// A predicate of the ranking.
pub(crate) struct Reference<T> {
    pub name: &'static str,
    pub answer: fn(&Query<T>, Subject) -> Answer,
}

/// The predicates with which those on coordinates of this type are compared.
pub(crate) fn references<T: Number>() -> Vec<Reference<T>> {
    let mut all: Vec<Reference<T>> = vec![
        Reference { name: "plain f64", answer: |query, subject| sign(determinant::<f64, T>(query, subject), 0.0) },
        Reference {
            name: "plain f64, zero below 1e-10",
            answer: |query, subject| sign(determinant::<f64, T>(query, subject), 1e-10),
        },
    ];
    if T::IS_FLOAT {
        let answer = |query: &Query<T>, subject| sign(determinant::<f32, T>(query, subject), 0.0);
        all.push(Reference { name: "plain f32", answer });
    }
    all
}

/// The sign of a determinant; zero below `epsilon` if that is positive.
fn sign<F: Float>(determinant: F, epsilon: f64) -> Answer {
    let (zero, epsilon) = (F::default(), F::of(epsilon));
    if epsilon > zero && determinant < epsilon && -determinant < epsilon {
        return Sign::Zero.into();
    }
    match determinant.partial_cmp(&zero) {
        Some(order) => order.into(),
        None => Answer::NotANumber,
    }
}

fn determinant<F: Float, T: Number>(query: &Query<T>, subject: Subject) -> F {
    let inputs: Vec<F> = query.coordinates.iter().map(|x| F::of(x.nearest_double())).collect();
    let mut rest = inputs.as_slice();
    let (_, axes) = subject.ways[query.way];
    let points: Vec<[F; 3]> = query
        .shapes
        .iter()
        .map(|shape| {
            let (own, others) = rest.split_at(shape.size() * subject.dimension);
            rest = others;
            let point = construct(*shape, own, subject.dimension);
            std::array::from_fn(|at| axes.get(at).map_or(F::default(), |&axis| point[axis]))
        })
        .collect();
    let (size, last) = (points.len() - 1, points[points.len() - 1]);
    let mut rows = [[F::default(); 4]; 4];
    for (row, point) in rows.iter_mut().zip(&points[..size]) {
        for at in 0..axes.len() {
            row[at] = point[at] - last[at];
        }
        if subject.kind.is_lifted() {
            row[axes.len()] = row[..axes.len()].iter().fold(F::default(), |sum, &x| sum + x * x);
        }
    }
    minor(&rows, size, 0, 0)
}

/// The determinant of the columns from `column` on and the rows that are not in the set `used`.
fn minor<F: Float>(rows: &[[F; 4]; 4], size: usize, column: usize, used: usize) -> F {
    let mut sum = F::default();
    let mut is_first = true;
    for (place, row) in (0..size).filter(|row| used >> row & 1 == 0).enumerate() {
        let entry = if place.is_multiple_of(2) { rows[row][column] } else { -rows[row][column] };
        let term = if column + 1 == size { entry } else { entry * minor(rows, size, column + 1, used | 1 << row) };
        sum = if is_first { term } else { sum + term };
        is_first = false;
    }
    sum
}

/// The coordinates of a point from those of the points that define it.
fn construct<F: Float>(shape: Shape, inputs: &[F], dimension: usize) -> [F; 3] {
    let point = |at: usize| -> [F; 3] {
        std::array::from_fn(|axis| if axis < dimension { inputs[at * dimension + axis] } else { F::default() })
    };
    let normal = |first: usize| {
        let [a, b, c] = [first, first + 1, first + 2].map(point);
        cross(minus(b, a), minus(c, a))
    };
    match shape {
        Shape::Input => point(0),
        Shape::Ssi => {
            let [a, b, c, d] = [0, 1, 2, 3].map(point);
            let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
            let t = (way[0] * v[1] - way[1] * v[0]) / (u[0] * v[1] - u[1] * v[0]);
            std::array::from_fn(|axis| a[axis] + t * u[axis])
        }
        Shape::Lpi => {
            let (p, normal) = (point(0), normal(2));
            let u = minus(point(1), p);
            let t = dot(normal, minus(point(2), p)) / dot(normal, u);
            std::array::from_fn(|axis| p[axis] + t * u[axis])
        }
        Shape::Tpi => {
            let [l, m, n] = [0, 3, 6].map(normal);
            let [on_l, on_m, on_n] = [dot(l, point(0)), dot(m, point(3)), dot(n, point(6))];
            let [mn, nl, lm] = [cross(m, n), cross(n, l), cross(l, m)];
            let weight = dot(l, mn);
            std::array::from_fn(|axis| (on_l * mn[axis] + on_m * nl[axis] + on_n * lm[axis]) / weight)
        }
    }
}

fn minus<F: Float>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    std::array::from_fn(|axis| p[axis] - q[axis])
}

fn cross<F: Float>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot<F: Float>(p: [F; 3], q: [F; 3]) -> F {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
