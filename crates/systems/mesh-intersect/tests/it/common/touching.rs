//! Tests that triangles meet in common corners and edges only, by clipping in rationals, pair by pair.

use std::cmp::Ordering;

use rug::Rational;

use super::volumes::{Point, area, cross, dot, minus};

/// The part of a polygon, which may be a segment or a point, in a closed half-space: where the value is not negative.
fn clipped(polygon: &[Point], value: &dyn Fn(&Point) -> Rational) -> Vec<Point> {
    let values: Vec<Rational> = polygon.iter().map(value).collect();
    let mut all: Vec<Point> = Vec::new();
    for at in 0..polygon.len() {
        let next = (at + 1) % polygon.len();
        if values[at].cmp0() != Ordering::Less {
            all.push(polygon[at].clone());
        }
        if values[at].cmp0() as i32 * values[next].cmp0() as i32 == -1 {
            let part = &values[at] / Rational::from(&values[at] - &values[next]);
            let way = minus(&polygon[next], &polygon[at]);
            all.push([0, 1, 2].map(|i: usize| Rational::from(&way[i] * &part) + &polygon[at][i]));
        }
    }
    all.dedup();
    all
}

/// The corners of the intersection of two triangles.
pub fn common(first: &[Point; 3], second: &[Point; 3]) -> Vec<Point> {
    let normal = area(second);
    let height = |p: &Point| dot(&normal, &minus(p, &second[0]));
    let mut polygon = clipped(first, &height);
    polygon = clipped(&polygon, &|p| -height(p));
    for at in 0..3 {
        let [a, b] = [&second[at], &second[(at + 1) % 3]];
        let inward = cross(&normal, &minus(b, a));
        polygon = clipped(&polygon, &|p| dot(&inward, &minus(p, a)));
    }
    polygon
}

/// True if two triangles have nothing in common except corners of both, and the edge between two of them.
pub fn is_proper(first: &[Point; 3], second: &[Point; 3]) -> bool {
    let corners = first.iter().filter(|corner| second.contains(corner)).count();
    corners < 3 && common(first, second).iter().all(|p| first.contains(p) && second.contains(p))
}

/// The pairs of triangles of a surface that meet improperly.
pub fn improper(surface: &[[Point; 3]]) -> Vec<[usize; 2]> {
    // Conversion rounds toward zero, by less than a step.
    let around = |triangle: &[Point; 3]| {
        [0, 1, 2].map(|axis: usize| {
            let along = triangle.each_ref().map(|p| p[axis].to_f64());
            let low = along.iter().fold(f64::INFINITY, |low, &x| low.min(x)).next_down();
            [low, along.iter().fold(f64::NEG_INFINITY, |high, &x| high.max(x)).next_up()]
        })
    };
    let boxes: Vec<[[f64; 2]; 3]> = surface.iter().map(around).collect();
    let is_apart = |at: usize, other: usize| {
        boxes[at]
            .iter()
            .zip(&boxes[other])
            .any(|([low, high], [other_low, other_high])| high < other_low || other_high < low)
    };
    let mut all = Vec::new();
    for (at, first) in surface.iter().enumerate() {
        for (other, second) in surface.iter().enumerate().skip(at + 1) {
            if !is_apart(at, other) && !is_proper(first, second) {
                all.push([at, other]);
            }
        }
    }
    all
}
