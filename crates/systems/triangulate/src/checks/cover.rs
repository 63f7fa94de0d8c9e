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
    let (mut found, mut places) = (Vec::new(), Vec::with_capacity(triangles.len()));
    for &triangle in triangles {
        match triangle.map(|v| points.place(v)) {
            [Some(a), Some(b), Some(c)] => places.push([a, b, c]),
            _ if found.is_empty() => {
                let truth = "three vertices of the polygon".to_owned();
                found.push(Flaw { check: "vertices", vertices: triangle.to_vec(), got: words(&triangle), truth });
            }
            _ => {}
        }
    }
    found.extend(unequal_area(polygon, &places, "area"));
    found.extend(unequal_passages(polygon, &places));
    found
}

/// The flaws of triangles in the limit, at most one for each check. A triangle covers the same points in either
/// direction, and a triangle without area covers nothing.
///
/// Turned counterclockwise, the triangles must go around each point as often as the loops do, as the module says. So a
/// point off the border is in one triangle or on the side of two if it is inside, and in none if it is outside.
#[must_use]
pub fn limit_flaws(polygon: &Polygon, triangles: &[[Vertex; 3]]) -> Vec<Flaw> {
    let points = &polygon.points;
    let turned = |[a, b, c]: [usize; 3]| if points.side(a, b, c).is_lt() { [a, c, b] } else { [a, b, c] };
    let places: Vec<[usize; 3]> = triangles
        .iter()
        .filter_map(|triangle| match triangle.map(|v| points.place(v)) {
            [Some(a), Some(b), Some(c)] => Some(turned([a, b, c])),
            _ => None,
        })
        .collect();
    let mut found: Vec<Flaw> = unequal_area(polygon, &places, "area of the limit").into_iter().collect();
    let wrong = unequal_passages(polygon, &places).into_iter().next();
    found.extend(wrong.map(|flaw| Flaw { check: "inside of the limit", ..flaw }));
    found
}

/// The area of triangles, if it is not the area of the polygon.
fn unequal_area(polygon: &Polygon, places: &[[usize; 3]], check: &'static str) -> Option<Flaw> {
    let points = &polygon.points;
    let mut sum = Integer::new();
    places.iter().for_each(|&[a, b, c]| sum += points.turn(a, b, c));
    let [got, truth] = [&sum, &polygon.area].map(|area| points.in_scene_units(area).to_string());
    (sum != polygon.area).then(|| Flaw { check, vertices: Vec::new(), got, truth })
}

/// The first pieces that counterclockwise triangles do not pass as often as the loops do.
pub(super) fn unequal_passages(polygon: &Polygon, places: &[[usize; 3]]) -> Vec<Flaw> {
    let points = &polygon.points;
    let first = points.first_at_each_place();
    let mut sides = Passages::new();
    for &[a, b, c] in places.iter().filter(|&&[a, b, c]| points.side(a, b, c).is_ne()) {
        [[a, b], [b, c], [c, a]].into_iter().for_each(|side| pass(&mut sides, side.map(|at| first[at]), 0, 1));
    }
    for edge in polygon.loops.iter().flat_map(|one| edges(one)) {
        pass(&mut sides, edge.map(|at| first[at]), 1, 1);
    }
    unequal(polygon, &pieces(polygon, &first, &sides))
}

/// Adds passages from one place to another, of triangles (0) or loops (1).
fn pass(all: &mut Passages, [a, b]: [usize; 2], of: usize, times: i64) {
    if a != b {
        all.entry([a.min(b), a.max(b)]).or_default()[of] += if a < b { times } else { -times };
    }
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
