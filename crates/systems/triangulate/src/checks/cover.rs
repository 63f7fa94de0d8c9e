//! Checks that triangles cover a polygon, however they use its vertices.
//!
//! A library may leave out a vertex in the middle of an edge, and may use any of several vertices at one place. So
//! triangles without area do not count, vertices at one place are one, and an edge counts as the pieces between the
//! vertices on it.
//!
//! # Why the checks are enough
//! All triangles that count are counterclockwise. Let the sides of triangles pass each piece as often as the loops do,
//! where a passage back undoes one there (`boundary`, `diagonals`). Then the triangles go around each point as often as
//! the loops do: once inside the polygon, and not at all outside. `area` follows; it says how much is missing.

use std::collections::BTreeMap;

use predicament_judge::boxes::{Boxes, extent};
use predicament_predicates::Vertex;
use rug::Integer;

use super::flaws::words;
use super::nesting::edges;
use super::{Flaw, Polygon};

/// A piece between two places in order, and how often it is passed in that direction, less the passages back: by
/// triangles, then by loops.
type Passages = BTreeMap<[usize; 2], [i64; 2]>;

/// The flaws of triangles that must cover the polygon once, at most one for each check. The triangles may be flat, but
/// not clockwise.
#[must_use]
pub fn uncovered(polygon: &Polygon, triangles: &[[Vertex; 3]]) -> Vec<Flaw> {
    let points = &polygon.points;
    if let Some((got, vertices)) = polygon.fault() {
        let truth = "loops that bound a polygon".to_owned();
        return vec![Flaw { check: "loops do not cross", vertices, got, truth }];
    }
    let first = first_at_each_place(polygon);
    let (mut found, mut sides, mut sum) = (Vec::new(), Passages::new(), Integer::new());
    for &triangle in triangles {
        let [Some(a), Some(b), Some(c)] = triangle.map(|v| points.place(v)) else {
            if found.is_empty() {
                let truth = "three vertices of the polygon".to_owned();
                found.push(Flaw { check: "vertices", vertices: triangle.to_vec(), got: words(&triangle), truth });
            }
            continue;
        };
        let area = points.turn(a, b, c);
        if area.cmp0().is_eq() {
            continue;
        }
        sum += area;
        [[a, b], [b, c], [c, a]].into_iter().for_each(|side| pass(&mut sides, side.map(|at| first[at]), 0, 1));
    }
    if sum != polygon.area {
        let [got, truth] = [&sum, &polygon.area].map(|area| points.in_scene_units(area).to_string());
        found.push(Flaw { check: "area", vertices: Vec::new(), got, truth });
    }
    for edge in polygon.loops.iter().flat_map(|one| edges(one)) {
        pass(&mut sides, edge.map(|at| first[at]), 1, 1);
    }
    found.extend(unequal(polygon, &pieces(polygon, &first, &sides)));
    found
}

/// Adds passages from one place to another, of triangles (0) or loops (1).
fn pass(all: &mut Passages, [a, b]: [usize; 2], of: usize, times: i64) {
    if a != b {
        all.entry([a.min(b), a.max(b)]).or_default()[of] += if a < b { times } else { -times };
    }
}

/// For each point, the first of those at its place.
fn first_at_each_place(polygon: &Polygon) -> Vec<usize> {
    let points = &polygon.points;
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points.order(a, b).then(a.cmp(&b)));
    let mut first = vec![0; points.len()];
    for same in order.chunk_by(|&a, &b| points.is_same_place(a, b)) {
        same.iter().for_each(|&at| first[at] = same[0]);
    }
    first
}

/// The passages of the pieces of all sides that triangles and loops do not pass equally often.
fn pieces(polygon: &Polygon, first: &[usize], sides: &Passages) -> Passages {
    let points = &polygon.points;
    let mut unequal = sides.iter().filter(|(_, [triangles, loops])| triangles != loops).peekable();
    let mut all = Passages::new();
    if unequal.peek().is_none() {
        return all;
    }
    let boxes = Boxes::new((0..points.len()).map(|at| extent([points.raw(at)])).collect());
    let mut near = Vec::new();
    for (&[a, b], &times) in unequal {
        boxes.near(&extent([points.raw(a), points.raw(b)]), 0.0, &mut near);
        let mut chain: Vec<usize> = near.iter().map(|&at| at as usize).collect();
        chain.retain(|&at| first[at] == at && points.is_on(a, b, at));
        // The order of coordinates is the order along a line.
        chain.sort_by(|&one, &other| points.order(one, other));
        if points.order(b, a).is_lt() {
            chain.reverse();
        }
        for pair in chain.windows(2) {
            [0, 1].into_iter().for_each(|of| pass(&mut all, [pair[0], pair[1]], of, times[of]));
        }
    }
    all
}

/// The first piece of a loop, and the first other piece, that is passed more or less often than it should be.
fn unequal(polygon: &Polygon, pieces: &Passages) -> Vec<Flaw> {
    let flaw = |check: &'static str, is_edge: bool| {
        let wrong = pieces.iter().find(|(_, [there, wanted])| there != wanted && (*wanted != 0) == is_edge);
        wrong.map(|(ends, [got, wanted])| {
            let vertices = ends.map(|at| polygon.points.vertex(at));
            let says = |times: &i64| {
                format!("from {} to {}, triangles pass {times} times more than back", vertices[0], vertices[1])
            };
            Flaw { check, vertices: vertices.to_vec(), got: says(got), truth: says(wanted) }
        })
    };
    flaw("boundary", true).into_iter().chain(flaw("diagonals", false)).collect()
}
