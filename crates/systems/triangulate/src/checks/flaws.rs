//! Checks of triangles against the polygon that they must cover.

use std::cmp::Ordering;

use predicament_predicates::Vertex;
use rug::Integer;

use super::Polygon;
use super::cover::unequal_passages;

/// The maximum number of triangles for which all pairs are compared.
const MOST_PAIRED: usize = 150;

/// The triangles that may be flat.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Flat {
    /// Only where loops touch.
    WhereLoopsTouch,
    /// Anywhere: a flat triangle has area once it is perturbed.
    Anywhere,
}

/// A flaw of a triangulation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The name of the check.
    pub check: &'static str,
    /// The vertices at the flaw; empty if there are many.
    pub vertices: Vec<Vertex>,
    /// The value found.
    pub got: String,
    /// The value expected.
    pub truth: String,
}

/// The flaws of the triangles, at most one for each check: the first wrong triangle or side in order.
#[must_use]
pub fn flaws(polygon: &Polygon, triangles: &[[Vertex; 3]], flat: Flat) -> Vec<Flaw> {
    let points = &polygon.points;
    let mut found = Vec::new();
    let mut places = Vec::with_capacity(triangles.len());
    for &triangle in triangles {
        match triangle.map(|v| points.place(v)) {
            [Some(a), Some(b), Some(c)] if a != b && b != c && a != c => places.push([a, b, c]),
            _ if found.is_empty() => found.push(Flaw {
                check: "vertices",
                vertices: triangle.to_vec(),
                got: words(&triangle),
                truth: "three vertices of the polygon".to_owned(),
            }),
            _ => {}
        }
    }
    if polygon.has_edge_without_length() {
        found.extend(areas(polygon, &places, flat));
        found.extend(unequal_passages(polygon, &places));
        return found;
    }
    if triangles.len() != polygon.triangles {
        let [got, truth] = [triangles.len(), polygon.triangles].map(|count| format!("{count} triangles"));
        found.push(Flaw { check: "count", vertices: Vec::new(), got, truth });
    }
    found.extend(areas(polygon, &places, flat));
    found.extend(sides(polygon, &places));
    found.extend(overlap(polygon, &places));
    found
}

pub(super) fn words(vertices: &[Vertex]) -> String {
    vertices.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn areas(polygon: &Polygon, places: &[[usize; 3]], flat: Flat) -> Vec<Flaw> {
    let points = &polygon.points;
    let mut sum = Integer::new();
    let mut wrong = None;
    for &triangle in places {
        let [a, b, c] = triangle;
        let area = points.turn(a, b, c);
        let is_right = match area.cmp0() {
            Ordering::Greater => true,
            Ordering::Equal => flat == Flat::Anywhere || is_at_touch(polygon, triangle),
            Ordering::Less => false,
        };
        if !is_right {
            wrong.get_or_insert((triangle, area.cmp0()));
        }
        sum += area;
    }
    let mut found = Vec::new();
    if let Some((triangle, sign)) = wrong {
        let vertices = triangle.map(|place| points.vertex(place)).to_vec();
        let is = if sign.is_eq() { "flat" } else { "clockwise" };
        let got = format!("the triangle {} is {is}", words(&vertices));
        let truth = match flat {
            Flat::WhereLoopsTouch => "counterclockwise, or flat if loops touch there".to_owned(),
            Flat::Anywhere => "not clockwise".to_owned(),
        };
        found.push(Flaw { check: "positive", vertices, got, truth });
    }
    if sum != polygon.area {
        let [got, truth] = [&sum, &polygon.area].map(|area| points.in_scene_units(area).to_string());
        found.push(Flaw { check: "area", vertices: Vec::new(), got, truth });
    }
    found
}

/// True if a flat triangle has no alternative: two corners at one position, or all three on one edge.
fn is_at_touch(polygon: &Polygon, [a, b, c]: [usize; 3]) -> bool {
    let points = &polygon.points;
    if points.is_same_place(a, b) || points.is_same_place(b, c) || points.is_same_place(a, c) {
        return true;
    }
    let corners = [a, b, c];
    let of_one = |&&(v, [p, q]): &&(usize, [usize; 2])| {
        corners.contains(&v) && corners.iter().all(|&corner| corner == p || corner == q || points.is_on(p, q, corner))
    };
    polygon.touches.on_edges.iter().any(|on_edge| of_one(&on_edge))
}

/// A side between two indices in order, and the number of times that it occurs in that direction and back: in
/// triangles, then in loops.
struct Side {
    ends: [usize; 2],
    triangles: [usize; 2],
    loops: [usize; 2],
}

fn all_sides(polygon: &Polygon, places: &[[usize; 3]]) -> Vec<Side> {
    let of_triangles = places.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).map(|side| (side, false));
    let of_loops = polygon.loops.iter().flat_map(|one| super::nesting::edges(one)).map(|side| (side, true));
    let mut all: Vec<([usize; 2], bool, bool)> =
        of_triangles.chain(of_loops).map(|([a, b], of_loop)| ([a.min(b), a.max(b)], a > b, of_loop)).collect();
    all.sort_unstable();
    let count = |chunk: &[([usize; 2], bool, bool)], wanted: bool| {
        [false, true]
            .map(|back| chunk.iter().filter(|&&(_, is_back, of_loop)| (is_back, of_loop) == (back, wanted)).count())
    };
    all.chunk_by(|a, b| a.0 == b.0)
        .map(|chunk| Side { ends: chunk[0].0, triangles: count(chunk, false), loops: count(chunk, true) })
        .collect()
}

fn sides(polygon: &Polygon, places: &[[usize; 3]]) -> Vec<Flaw> {
    let points = &polygon.points;
    let sides = all_sides(polygon, places);
    let flaw = |check: &'static str, side: &Side, truth: [usize; 2]| {
        let vertices = side.ends.map(|place| points.vertex(place)).to_vec();
        let says = |[there, back]: [usize; 2]| {
            format!(
                "the side from {} to {} is in {there} triangles, the opposite side in {back}",
                vertices[0], vertices[1]
            )
        };
        Flaw { check, got: says(side.triangles), truth: says(truth), vertices: vertices.clone() }
    };
    let is_edge = |side: &&Side| side.loops != [0, 0];
    // An edge without length has two triangles, as any diagonal does.
    let boundary = sides.iter().filter(is_edge).find(|side| side.triangles != side.loops);
    let inner = sides.iter().filter(|side| !is_edge(side)).find(|side| side.triangles != [1, 1]);
    let boundary = boundary.map(|side| flaw("boundary", side, side.loops));
    boundary.into_iter().chain(inner.map(|side| flaw("diagonals", side, [1, 1]))).collect()
}

/// Finds two triangles with a common inner point: no line along a side of one separates them.
fn overlap(polygon: &Polygon, places: &[[usize; 3]]) -> Option<Flaw> {
    let points = &polygon.points;
    if places.len() > MOST_PAIRED {
        return None;
    }
    let solid: Vec<[usize; 3]> = places.iter().copied().filter(|&[a, b, c]| points.side(a, b, c).is_gt()).collect();
    let separates = |[a, b, c]: [usize; 3], other: [usize; 3]| {
        [[a, b], [b, c], [c, a]].into_iter().any(|[p, q]| other.iter().all(|&corner| points.side(p, q, corner).is_le()))
    };
    let pairs = solid.iter().enumerate().flat_map(|(at, &one)| solid[at + 1..].iter().map(move |&other| (one, other)));
    let mut overlapping = pairs.filter(|&(one, other)| !separates(one, other) && !separates(other, one));
    overlapping.next().map(|(one, other)| {
        let vertices: Vec<Vertex> = one.into_iter().chain(other).map(|place| points.vertex(place)).collect();
        let got = format!("the triangles {} and {} overlap", words(&vertices[..3]), words(&vertices[3..]));
        Flaw { check: "overlap", vertices, got, truth: "no inner point in common".to_owned() }
    })
}
