//! Checks of hulls in the plane, and of polygons that are faces of hulls in space.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

use predicament_predicates::{Axis, Plane, Question, Scene, Sign, Vertex};

use super::tally::{Flaw, Signs, Tally};

/// The maximum number of edges over a point: a vertical edge and its neighbours.
const EDGES_AT: usize = 4;

/// The failed checks of the hull of all vertices of a plane scene, counterclockwise.
#[must_use]
pub fn plane_flaws(signs: Signs<'_>, hull: &[Vertex]) -> Vec<Flaw> {
    let mut tally = Tally::new(signs);
    if are_vertices(&mut tally, hull) {
        let all: Vec<Vertex> = tally.scene().vertices().collect();
        polygon(&mut tally, Plane::Xy, hull, &all);
        smallest_at_their_places(&mut tally, hull);
    }
    tally.finish()
}

/// Checks `vertices`: each is a vertex of the scene, and none comes twice.
pub(super) fn are_vertices(tally: &mut Tally<'_>, hull: &[Vertex]) -> bool {
    let mut seen = HashSet::new();
    for &v in hull {
        if !tally.scene().has(v) || v.is_constructed() || !seen.insert(v) {
            tally.flaw("vertices", &[], || format!("vertex {v} is listed twice or is not a vertex of the scene"));
        }
    }
    tally.is_clean()
}

/// The place of a vertex as a key; zeros of either sign are equal.
fn place(scene: &Scene, v: Vertex) -> Vec<u64> {
    scene.point(v).iter().map(|x| (x + 0.0).to_bits()).collect()
}

/// Checks `smallest index`: a vertex of the hull is the smallest index at its place.
pub(super) fn smallest_at_their_places(tally: &mut Tally<'_>, hull: &[Vertex]) {
    let scene = tally.scene();
    if !tally.has_ties() {
        return;
    }
    let here: HashMap<Vec<u64>, Vertex> = hull.iter().map(|&v| (place(scene, v), v)).collect();
    if here.len() < hull.len() {
        tally.flaw("smallest index", &[], || format!("{} vertices in {} places", hull.len(), here.len()));
    }
    for v in scene.vertices() {
        if let Some(&other) = here.get(&place(scene, v)).filter(|&&other| v < other) {
            tally.flaw("smallest index", &[v, other], || {
                format!("{other} stands for {v}, which has the same place and a smaller index")
            });
        }
    }
}

/// The dimension that a scene or a hull must span: 0 for a point, 1 for a segment, 2 for more.
fn span(tally: &Tally<'_>, plane: Plane, all: &[Vertex]) -> usize {
    if !tally.has_ties() {
        return all.len().saturating_sub(1).min(2);
    }
    let scene = tally.scene();
    let Some((&a, others)) = all.split_first() else { return 0 };
    let other = others.iter().copied().find(|&b| scene.point2(plane, a) != scene.point2(plane, b));
    let Some(b) = other else { return 0 };
    let is_off = |&c: &Vertex| c != b && !tally.signs.exact.orient2d(plane, a, b, c).is_zero();
    if others.iter().any(is_off) { 2 } else { 1 }
}

/// The order of two vertices from left to right, and on one vertical line from below: in the scene or, with broken
/// ties, in the perturbed scene.
fn order(tally: &Tally<'_>, plane: Plane, v: Vertex, w: Vertex) -> Ordering {
    let scene = tally.scene();
    let as_it_is = scene.point2(plane, v).partial_cmp(&scene.point2(plane, w)).unwrap_or(Ordering::Equal);
    let Some(perturbed) = tally.signs.perturbed else { return as_it_is };
    let by = |axis: Axis| {
        let exact = scene.coordinate(axis, v).partial_cmp(&scene.coordinate(axis, w)).unwrap_or(Ordering::Equal);
        exact.then_with(|| if v == w { Ordering::Equal } else { as_ordering(perturbed.compare(axis, v, w)) })
    };
    let [first, second] = plane.axes();
    by(first).then_with(|| by(second))
}

fn as_ordering(sign: Sign) -> Ordering {
    sign.as_i8().cmp(&0)
}

/// Checks a polygon, counterclockwise in a coordinate plane, as the hull of `all`; its vertices exist and differ.
///
/// `span`: the polygon has as many vertices as its dimension needs. `start`: the first vertex is the smallest from left
/// to right. `convex`: no turn to the right. `extreme`: no vertex in the middle of an edge. `wound once`: the polygon
/// goes around once. `inside`: all points are inside or on it.
pub(super) fn polygon(tally: &mut Tally<'_>, plane: Plane, hull: &[Vertex], all: &[Vertex]) {
    let span = span(tally, plane, all);
    let wanted = match (span, all.is_empty()) {
        (_, true) => hull.is_empty(),
        (2, _) => hull.len() >= 3,
        (span, _) => hull.len() == span + 1,
    };
    if !wanted {
        return tally.flaw("span", &[], || format!("{} vertices of a hull of {span} dimensions", hull.len()));
    }
    if span < 2 {
        return segment(tally, plane, hull, all);
    }
    if hull.iter().any(|&v| order(tally, plane, v, hull[0]) == Ordering::Less) {
        tally.flaw("start", &hull[..1], || format!("{} is not the leftmost vertex", hull[0]));
    }
    ring(tally, plane, hull, "convex", Some("extreme"));
    if tally.is_clean() {
        inside(tally, plane, hull, all);
    }
}

/// Checks that a closed polygon turns only to the left, and goes around once.
pub fn ring(tally: &mut Tally<'_>, plane: Plane, ring: &[Vertex], convex: &'static str, extreme: Option<&'static str>) {
    let n = ring.len();
    for at in 0..n {
        tally.positive(convex, extreme, Question::Orient2d(plane), &[ring[at], ring[(at + 1) % n], ring[(at + 2) % n]]);
    }
    let is_lowest = |at: &usize| {
        let [before, here, after] = [ring[(at + n - 1) % n], ring[*at], ring[(at + 1) % n]];
        order(tally, plane, here, before) == Ordering::Less && order(tally, plane, here, after) == Ordering::Less
    };
    let rounds = (0..n).filter(is_lowest).count();
    if rounds != 1 {
        tally.flaw("wound once", &[], || format!("the polygon goes around {rounds} times"));
    }
}

/// Checks that all points are between the two ends, or at the one place.
fn segment(tally: &mut Tally<'_>, plane: Plane, hull: &[Vertex], all: &[Vertex]) {
    let (Some(&first), Some(&last)) = (hull.first(), hull.last()) else { return };
    for &v in all {
        if order(tally, plane, v, first) == Ordering::Less || order(tally, plane, v, last) == Ordering::Greater {
            tally.flaw("inside", &[v], || format!("{v} is not between {first} and {last}"));
        }
    }
}

/// Checks every point against the edges below and above it; the polygon is convex.
fn inside(tally: &mut Tally<'_>, plane: Plane, hull: &[Vertex], all: &[Vertex]) {
    let scene = tally.scene();
    let x = |v: Vertex| scene.point2(plane, v)[0];
    let last = (0..hull.len()).max_by(|&i, &j| order(tally, plane, hull[i], hull[j])).unwrap_or(0);
    let mut back: Vec<Vertex> = hull[last..].iter().chain(&hull[..1]).copied().collect();
    back.reverse();
    let corners: HashSet<Vertex> = hull.iter().copied().collect();
    let others: Vec<Vertex> = all.iter().copied().filter(|v| !corners.contains(v)).collect();
    // A point is checked against two edges, or a few more beside vertical ones.
    let step = (2 * others.len()).div_ceil(tally.signs.pairs.max(1)).max(1);
    for &v in others.iter().step_by(step) {
        for (chain, is_below) in [(&hull[..=last], true), (&back[..], false)] {
            let at = chain.partition_point(|&w| x(w) < x(v));
            if x(v) < x(chain[0]) || at == chain.len() {
                tally.flaw("inside", &[v], || format!("{v} is left or right of all vertices"));
                continue;
            }
            for edge in chain[at.saturating_sub(1)..].windows(2).take(EDGES_AT).take_while(|edge| x(edge[0]) <= x(v)) {
                let [a, b] = if is_below { [edge[0], edge[1]] } else { [edge[1], edge[0]] };
                tally.positive("inside", None, Question::Orient2d(plane), &[a, b, v]);
            }
        }
    }
}
