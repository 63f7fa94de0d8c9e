//! The vertices of convex hulls by definition: every pair, every triple.
//!
//! A vertex is extreme if some line or plane through it has all other vertices on one side, and the vertex is extreme
//! among the vertices on that line or plane. Nothing is sorted or wrapped. Time grows with the third power (plane) or
//! the fourth power (space) of the number of vertices.

use predicament_predicates::{Axis, Dimension, Plane, Predicates, Sign, Vertex};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// The largest number of vertices of a scene that is judged in this way.
#[must_use]
pub fn most(dimension: Dimension) -> usize {
    match dimension {
        Dimension::Two => 40,
        Dimension::Three => 24,
    }
}

/// The extreme vertices by a session's signs, ascending; of coincident vertices only the smallest.
#[must_use]
pub fn extreme(session: &dyn Predicates) -> Vec<Vertex> {
    let scene = session.scene();
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let mut all: Vec<Vertex> = Vec::new();
    for v in scene.vertices() {
        if all.iter().all(|&w| order(session, axes, v, w) != Sign::Zero) {
            all.push(v);
        }
    }
    let mut found = match scene.dimension() {
        Dimension::Two => in_plane(session, Plane::Xy, &all),
        Dimension::Three => in_space(session, &all),
    };
    if found.is_empty() {
        // All vertices are in one place or on one line.
        found = ends(session, axes, &all);
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn order(session: &dyn Predicates, axes: &[Axis], v: Vertex, w: Vertex) -> Sign {
    let signs = axes.iter().map(|&axis| session.compare(axis, v, w));
    signs.into_iter().find(|sign| *sign != Sign::Zero).unwrap_or(Sign::Zero)
}

/// The first and the last vertex in the order of their coordinates.
fn ends(session: &dyn Predicates, axes: &[Axis], all: &[Vertex]) -> Vec<Vertex> {
    let is_end = |wanted: Sign, v: Vertex| all.iter().all(|&w| v == w || order(session, axes, v, w) == wanted);
    let is_one = |v: &Vertex| is_end(Sign::Negative, *v) || is_end(Sign::Positive, *v);
    all.iter().copied().filter(is_one).collect()
}

/// The extreme vertices as projected onto a coordinate plane; empty if the projections are collinear.
fn in_plane(session: &dyn Predicates, plane: Plane, all: &[Vertex]) -> Vec<Vertex> {
    let mut found = Vec::new();
    let (Some(&a), Some(&b)) = (all.first(), all.get(1)) else { return found };
    if all[2..].iter().all(|&c| session.orient2d(plane, a, b, c) == Sign::Zero) {
        return found;
    }
    for (a, b) in all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))).filter(|(a, b)| a != b) {
        let turn = |c: Vertex| session.orient2d(plane, a, b, c);
        let mut others = all.iter().copied().filter(|&c| c != a && c != b);
        if others.clone().all(|c| turn(c) != Sign::Negative) && others.any(|c| turn(c) == Sign::Positive) {
            let line: Vec<Vertex> =
                all.iter().copied().filter(|&c| c == a || c == b || turn(c) == Sign::Zero).collect();
            found.extend(ends(session, &plane.axes(), &line));
        }
    }
    found
}

/// The extreme vertices of points of space; empty if the points are coplanar.
fn in_space(session: &dyn Predicates, all: &[Vertex]) -> Vec<Vertex> {
    let mut found = Vec::new();
    for (i, &a) in all.iter().enumerate() {
        for (j, &b) in all.iter().enumerate().skip(i + 1) {
            for &c in &all[j + 1..] {
                let side = |d: Vertex| session.orient3d(a, b, c, d);
                // Three collinear vertices span no plane.
                let seen = PLANES.into_iter().find(|&plane| session.orient2d(plane, a, b, c) != Sign::Zero);
                let Some(plane) = seen else { continue };
                let others = || all.iter().copied().filter(|d| ![a, b, c].contains(d));
                let is_beside = |wrong: Sign| others().all(|d| side(d) != wrong);
                if !is_beside(Sign::Negative) && !is_beside(Sign::Positive) {
                    continue;
                }
                let mut flat: Vec<Vertex> = others().filter(|&d| side(d) == Sign::Zero).collect();
                // Each plane is visited once: from its first three vertices that are not collinear.
                let is_earlier = |d: Vertex| d < b || d < c && session.orient2d(plane, a, b, d) != Sign::Zero;
                if flat.iter().any(|&d| is_earlier(d)) {
                    continue;
                }
                flat.extend([a, b, c]);
                found.extend(in_plane(session, plane, &flat));
            }
        }
    }
    found
}
