//! Tests of the ways in which edges of a small grid meet, by definition.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off};

use super::*;

/// Twice the area of a triangle.
fn area([a, b, c]: [[i32; 2]; 3]) -> i32 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// True if the edges have a whole small segment in common: a sixtieth of one of them.
fn overlap([a, b]: [[i32; 2]; 2], [c, d]: [[i32; 2]; 2]) -> bool {
    let scaled = |p: [i32; 2]| p.map(|x| 60 * x);
    let at = |i: i32| [0, 1].map(|axis| a[axis] * (60 - i) + b[axis] * i);
    let is_on = |p: [i32; 2]| {
        let [c, d] = [c, d].map(scaled);
        area([c, d, p]) == 0 && (0..2).all(|axis| (c[axis].min(d[axis])..=c[axis].max(d[axis])).contains(&p[axis]))
    };
    (0..60).any(|i| is_on(at(i)) && is_on(at(i + 1)))
}

#[test]
fn edges_of_a_grid_meet_as_defined() {
    let grid: Vec<[i32; 2]> = (0..9).map(|i| [i % 3, i / 3]).collect();
    let points: Vec<[f64; 2]> = grid.iter().map(|p| p.map(f64::from)).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let edges: Vec<[usize; 2]> = (0..9).flat_map(|i| (0..i).map(move |j| [j, i])).collect();
    let [mut crossings, mut overlaps] = [0, 0];
    for (e, f) in edges.iter().flat_map(|e| edges.iter().map(move |f| (e, f))) {
        let found = meeting(&session, [e.map(Vertex::input), f.map(Vertex::input)]);
        let ([a, b], [c, d]) = (e.map(|i| grid[i]), f.map(|i| grid[i]));
        let sides = |p, q, [r, s]: [[i32; 2]; 2]| area([p, q, r]).signum() * area([p, q, s]).signum();
        let crosses = sides(a, b, [c, d]) < 0 && sides(c, d, [a, b]) < 0;
        let overlaps_it = overlap([a, b], [c, d]);
        assert_eq!(matches!(found, Some(Meeting::Crossing)), crosses, "{e:?} {f:?}");
        assert_eq!(matches!(found, Some(Meeting::Overlap)), overlaps_it, "{e:?} {f:?}");
        crossings += usize::from(crosses);
        overlaps += usize::from(overlaps_it);
    }
    // Every edge overlaps itself. On each of eight lines the long edge overlaps either half, in both orders.
    assert_eq!(overlaps, 36 + 8 * 4);
    assert!(crossings > 50, "{crossings}");
}
