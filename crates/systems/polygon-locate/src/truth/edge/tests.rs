//! Positions of all points of a small grid as seen from all its edges, by definition.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Scene};

use super::*;

/// The position by products and differences: the edge's point above x, if there is one, is compared with the point.
fn defined([u, v]: [[i32; 2]; 2], p: [i32; 2]) -> Place {
    let [left, right] = if u[0] <= v[0] { [u, v] } else { [v, u] };
    match (p == u, p == v) {
        (true, true) => return Place::AtBoth,
        (true, false) => return Place::AtFirst,
        (false, true) => return Place::AtSecond,
        (false, false) => {}
    }
    let width = right[0] - left[0];
    // The height of the edge above the point, times the width.
    let above = (left[1] - p[1]) * width + (right[1] - left[1]) * (p[0] - left[0]);
    let is_on_line = if width == 0 { p[0] == u[0] } else { above == 0 };
    let within = |axis: usize| (u[axis].min(v[axis])..=u[axis].max(v[axis])).contains(&p[axis]);
    if is_on_line && within(0) && within(1) {
        Place::Between
    } else if above > 0 && (left[0]..right[0]).contains(&p[0]) {
        Place::Below
    } else {
        Place::Elsewhere
    }
}

#[test]
fn places_on_a_grid_are_as_defined() {
    let grid: Vec<[i32; 2]> = (0..9).map(|i| [i % 3, i / 3]).collect();
    let points: Vec<[f64; 2]> = grid.iter().map(|p| p.map(f64::from)).collect();
    // Each point three times, so that ends and point are three vertices.
    let scene = Scene::from_points2(&points.repeat(3)).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let mut seen = [0; 6];
    for code in 0..729 {
        let [u, v, p] = [code % 9, code / 9 % 9, code / 81];
        let found = place(&session, [u, 9 + v].map(Vertex::input), Vertex::input(18 + p));
        assert_eq!(found, defined([grid[u], grid[v]], grid[p]), "{:?} from {:?} to {:?}", grid[p], grid[u], grid[v]);
        seen[found as usize] += 1;
    }
    assert_eq!(seen.iter().sum::<i32>(), 729);
    assert_eq!(seen[Place::AtBoth as usize], 9);
    assert_eq!([Place::AtFirst, Place::AtSecond].map(|place| seen[place as usize]), [72; 2]);
    // Three rows, three columns and two diagonals, in both directions.
    assert_eq!(seen[Place::Between as usize], 16);
}
