//! Convex hulls of small integers by definition: every pair, every triple.

use std::collections::BTreeSet;

use predicament_predicates::Vertex;

/// The indices of the points; of several at one place, the first.
fn places<const D: usize>(points: &[[i64; D]]) -> Vec<usize> {
    (0..points.len()).filter(|&at| !points[..at].contains(&points[at])).collect()
}

fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// True if b is on the segment between a and c; the three are collinear.
fn is_between(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> bool {
    (0..2).all(|axis| a[axis].min(c[axis]) <= b[axis] && b[axis] <= a[axis].max(c[axis]))
}

/// The extreme points counterclockwise, from the lexicographically smallest on.
pub fn plane(points: &[[i64; 2]]) -> Vec<usize> {
    let places = places(points);
    let Some(&first) = places.iter().min_by_key(|&&at| points[at]) else { return Vec::new() };
    let next = |at: usize| {
        let is_edge = |&to: &usize| {
            to != at
                && places.iter().all(|&other| {
                    let turn = turn(points[at], points[to], points[other]);
                    turn > 0 || turn == 0 && is_between(points[at], points[other], points[to])
                })
        };
        places.iter().copied().find(is_edge)
    };
    let mut ring = vec![first];
    while let Some(at) = next(ring[ring.len() - 1]).filter(|&at| at != first) {
        ring.push(at);
    }
    ring
}

/// The extreme points and the faces, each from its smallest vertex on; a flat hull has two.
pub fn space(points: &[[i64; 3]]) -> (Vec<Vertex>, Vec<Vec<Vertex>>) {
    let places = places(points);
    let mut faces: BTreeSet<Vec<Vertex>> = BTreeSet::new();
    let minus = |a: usize, b: usize| [0, 1, 2].map(|axis: usize| points[a][axis] - points[b][axis]);
    for &i in &places {
        for &j in places.iter().filter(|&&j| j > i) {
            for &k in places.iter().filter(|&&k| k > i && k != j) {
                let (u, v) = (minus(j, i), minus(k, i));
                let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
                if normal == [0; 3] {
                    continue;
                }
                let height = |at: usize| {
                    let to = minus(at, i);
                    normal[0] * to[0] + normal[1] * to[1] + normal[2] * to[2]
                };
                if places.iter().any(|&at| height(at) > 0) {
                    continue;
                }
                let on: Vec<usize> = places.iter().copied().filter(|&at| height(at) == 0).collect();
                // Projected along an axis in which the normal has a component: with the other two axes in cyclic order,
                // or reversed.
                let axis = (0..3).find(|&axis| normal[axis] != 0).expect("a normal");
                let flat: Vec<[i64; 2]> =
                    on.iter().map(|&at| [1, 2].map(|step| points[at][(axis + step) % 3])).collect();
                let mut ring: Vec<Vertex> = plane(&flat).into_iter().map(|at| Vertex::input(on[at])).collect();
                if normal[axis] < 0 {
                    ring.reverse();
                }
                let smallest = (0..ring.len()).min_by_key(|&at| ring[at]).expect("a ring");
                ring.rotate_left(smallest);
                faces.insert(ring);
            }
        }
    }
    let mut corners: BTreeSet<Vertex> = faces.iter().flatten().copied().collect();
    if faces.is_empty() {
        // A point or a segment: its ends.
        let ends = [places.iter().min_by_key(|&&at| points[at]), places.iter().max_by_key(|&&at| points[at])];
        corners = ends.into_iter().flatten().map(|&at| Vertex::input(at)).collect();
    }
    (corners.into_iter().collect(), faces.into_iter().collect())
}
