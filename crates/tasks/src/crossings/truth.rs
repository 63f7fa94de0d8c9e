//! The crossings by linear equations in rationals, segment by segment.
//!
//! Every pair of segments is solved for the two fractions at which they meet,
//! and the crossings of a segment are sorted by these fractions: no predicate,
//! no constructed vertex, no broad phase.

use predicament_judge::rational;
use predicament_predicates::{Plane, Scene, Vertex};
use rayon::prelude::*;
use rug::Rational;

use super::Segments;
use crate::{Stop, Watch};

/// The crossings of each segment: groups of segments that cross it in one point.
pub(super) fn truth(scene: &Scene, content: &Segments, watch: &Watch) -> Result<Vec<Vec<Vec<u32>>>, Stop> {
    let ends: Vec<[[Rational; 2]; 2]> =
        content.0.iter().map(|ends| ends.map(|v| scene.point2(Plane::Xy, v).map(rational))).collect();
    let boxes: Vec<[[f64; 2]; 2]> = content.0.iter().map(|&ends| extent(scene, ends)).collect();
    let of = |at: usize| -> Result<Vec<Vec<u32>>, Stop> {
        let others = (0..ends.len()).filter(|&other| other != at && overlap(boxes[at], boxes[other]));
        let mut found: Vec<(Rational, u32)> = others
            .filter_map(|other| {
                let number = u32::try_from(other).expect("fewer than 2^32 segments");
                Some((crossing(&ends[at], &ends[other])?, number))
            })
            .collect();
        found.sort();
        let mut along: Vec<Vec<u32>> = Vec::new();
        for (place, (fraction, other)) in found.iter().enumerate() {
            match along.last_mut() {
                Some(group) if found[place - 1].0 == *fraction => group.push(*other),
                _ => along.push(vec![*other]),
            }
        }
        watch.done(1).map(|()| along)
    };
    (0..ends.len()).into_par_iter().map(of).collect()
}

fn extent(scene: &Scene, [a, b]: [Vertex; 2]) -> [[f64; 2]; 2] {
    let (a, b) = (scene.point2(Plane::Xy, a), scene.point2(Plane::Xy, b));
    [0, 1].map(|axis: usize| [a[axis].min(b[axis]), a[axis].max(b[axis])])
}

/// Whether two boxes have a common point: comparing doubles is exact.
fn overlap(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

/// The fraction along the first segment at which the inner points of both meet in one point.
fn crossing([a, b]: &[[Rational; 2]; 2], [p, q]: &[[Rational; 2]; 2]) -> Option<Rational> {
    let minus = |u: &[Rational; 2], v: &[Rational; 2]| [0, 1].map(|i: usize| Rational::from(&u[i] - &v[i]));
    let cross = |[ux, uy]: &[Rational; 2], [vx, vy]: &[Rational; 2]| Rational::from(ux * vy) - Rational::from(uy * vx);
    let (along, other, between) = (minus(b, a), minus(q, p), minus(p, a));
    let determinant = cross(&along, &other);
    if determinant.cmp0().is_eq() {
        return None;
    }
    // a + t·along = p + s·other.
    let t = cross(&between, &other) / &determinant;
    let s = cross(&between, &along) / &determinant;
    let inside = |x: &Rational| x.cmp0().is_gt() && *x < 1;
    (inside(&t) && inside(&s)).then_some(t)
}
