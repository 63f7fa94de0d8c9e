//! Triangles through which an edge of the same surface passes.

use crate::boxes::{Boxes, extent};
use crate::rational;
use rug::Rational;

use super::{Corners, distance};

type Point = [Rational; 3];

/// The first triangle through which an edge passes, in words: both ends of the edge are farther than a distance from
/// the triangle, and so are the triangle's sides from the point where the edge passes. An even sample of triangles is
/// compared with all near them.
pub(super) fn first(triangles: &[Corners], index: &Boxes<3>, least: f64, most: usize) -> Option<String> {
    let step = triangles.len().div_ceil(most.max(1)).max(1);
    let mut near = Vec::new();
    for at in (0..triangles.len()).step_by(step) {
        let [a, b, c] = triangles[at];
        for [p, q] in [[a, b], [b, c], [c, a]] {
            index.near(&extent([p, q]), 0.0, &mut near);
            for other in near.iter().map(|&other| other as usize).filter(|&other| other != at) {
                if passes([p, q], &triangles[other], least) {
                    return Some(format!("the edge from {p:?} to {q:?} passes through triangle {other}"));
                }
            }
        }
    }
    None
}

/// True if a segment passes through a triangle with a distance to spare on all sides.
fn passes(ends: [[f64; 3]; 2], triangle: &Corners, least: f64) -> bool {
    if ends.iter().any(|end| triangle.contains(end)) {
        return false;
    }
    let [p, q] = ends.map(|end| end.map(rational));
    let corners = triangle.map(|corner| corner.map(rational));
    let [a, b, c] = &corners;
    let less = |p: &Point, q: &Point| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
    let cross = |p: &Point, q: &Point| {
        [0, 1, 2].map(|i: usize| {
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            Rational::from(&p[j] * &q[k]) - Rational::from(&p[k] * &q[j])
        })
    };
    let dot = |p: &Point, q: &Point| -> Rational { (0..3).map(|i| Rational::from(&p[i] * &q[i])).sum() };
    let normal = cross(&less(b, a), &less(c, a));
    let [from, to] = [dot(&normal, &less(&p, a)), dot(&normal, &less(&q, a))];
    if from.cmp0() == to.cmp0() || from.is_zero() || to.is_zero() {
        return false;
    }
    let part = &from / Rational::from(&from - &to);
    let along = less(&q, &p);
    let at = [0, 1, 2].map(|i: usize| Rational::from(&part * &along[i]) + &p[i]);
    let is_left = |from: &Point, to: &Point| dot(&cross(&less(to, from), &less(&at, from)), &normal).cmp0().is_gt();
    if !(is_left(a, b) && is_left(b, c) && is_left(c, a)) {
        return false;
    }
    let [a, b, c] = *triangle;
    let is_apart = [[a, b], [b, c], [c, a]].into_iter().all(|side| distance::of_segment(side, &at) > least);
    is_apart && ends.iter().all(|&end| distance::of_triangle(triangle, end) > least)
}
