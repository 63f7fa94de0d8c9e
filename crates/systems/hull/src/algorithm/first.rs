//! Up to four vertices with the same affine dimension as the scene.

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

use super::order::lexicographic;

pub(super) const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
/// The number of vertices in a batch of queries.
const CHUNK: usize = 1024;

/// The affine span of vertices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Span {
    /// Empty: there is no vertex.
    Nothing,
    /// All vertices are in the place of this one.
    Point(Vertex),
    /// All vertices are on one line; these are its ends.
    Line([Vertex; 2]),
    /// All vertices are in one plane, whose projection to this coordinate plane has area.
    Flat(Plane),
    /// Not coplanar: these four vertices span space, and the last one is below the plane of the others.
    Space([Vertex; 4]),
}

/// The affine span of these vertices.
///
/// Distant vertices by rounded coordinates are tried first. If their signs show no larger span, all the other vertices
/// are tried.
pub(super) fn span(session: &dyn Predicates, vertices: &[Vertex]) -> Span {
    let scene = session.scene();
    let Some(&any) = vertices.first() else { return Span::Nothing };
    let before =
        |&v: &Vertex, &w: &Vertex| scene.point(v).partial_cmp(scene.point(w)).unwrap_or(std::cmp::Ordering::Equal);
    let a = vertices.iter().copied().min_by(before).unwrap_or(any);
    let differs = |&b: &Vertex| b != a && lexicographic(session, &AXES, a, b) != Sign::Zero;
    let far = vertices.iter().copied().max_by(before).filter(differs);
    let Some(b) = far.or_else(|| vertices.iter().copied().find(differs)) else {
        return Span::Point(vertices.iter().copied().min().unwrap_or(a));
    };
    let Some((c, plane)) = off_line(session, [a, b], vertices) else { return Span::Line(ends(session, vertices)) };
    let Some((d, side)) = off_plane(session, [a, b, c], vertices) else { return Span::Flat(plane) };
    Span::Space(if side == Sign::Positive { [a, b, c, d] } else { [b, a, c, d] })
}

/// A vertex off the line, and a coordinate plane in which it is off the projected line.
fn off_line(session: &dyn Predicates, [a, b]: [Vertex; 2], vertices: &[Vertex]) -> Option<(Vertex, Plane)> {
    let scene = session.scene();
    let others = || vertices.iter().copied().filter(|&v| v != a && v != b);
    let seen = |c: Vertex| PLANES.into_iter().find(|&plane| session.orient2d(plane, a, b, c) != Sign::Zero);
    let far =
        others().max_by(|&v, &w| distance_from_line(scene, [a, b], v).total_cmp(&distance_from_line(scene, [a, b], w)));
    let found = far.and_then(|c| Some((c, seen(c)?)));
    found.or_else(|| others().find_map(|c| Some((c, seen(c)?))))
}

/// A vertex off the plane, and its side.
fn off_plane(session: &dyn Predicates, abc: [Vertex; 3], vertices: &[Vertex]) -> Option<(Vertex, Sign)> {
    let scene = session.scene();
    let [a, b, c] = abc;
    let others: Vec<Vertex> = vertices.iter().copied().filter(|v| !abc.contains(v)).collect();
    let far = others
        .iter()
        .copied()
        .max_by(|&v, &w| distance_from_plane(scene, abc, v).total_cmp(&distance_from_plane(scene, abc, w)));
    if let Some(d) = far {
        let side = session.orient3d(a, b, c, d);
        if side != Sign::Zero {
            return Some((d, side));
        }
    }
    let mut signs = [Sign::Zero; CHUNK];
    for chunk in others.chunks(CHUNK) {
        let signs = &mut signs[..chunk.len()];
        session.orient3d_plane(abc, chunk, signs);
        if let Some(at) = signs.iter().position(|&sign| sign != Sign::Zero) {
            return Some((chunk[at], signs[at]));
        }
    }
    None
}

/// The first and the last vertex in lexicographic order; of several at one place, the one with the smallest index.
fn ends(session: &dyn Predicates, vertices: &[Vertex]) -> [Vertex; 2] {
    [Sign::Negative, Sign::Positive].map(|wanted| {
        let further = |best: Vertex, v: Vertex| match lexicographic(session, &AXES, v, best) {
            Sign::Zero => best.min(v),
            sign if sign == wanted => v,
            _ => best,
        };
        vertices.iter().copied().reduce(further).unwrap_or(vertices[0])
    })
}

fn difference(scene: &Scene, v: Vertex, w: Vertex) -> [f64; 3] {
    let (v, w) = (scene.point3(v), scene.point3(w));
    [v[0] - w[0], v[1] - w[1], v[2] - w[2]]
}

fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// A rounded measure of the distance from a line, for comparison only.
fn distance_from_line(scene: &Scene, [a, b]: [Vertex; 2], v: Vertex) -> f64 {
    let normal = cross(difference(scene, b, a), difference(scene, v, a));
    normal.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// A rounded measure of the distance from a plane, for comparison only.
fn distance_from_plane(scene: &Scene, [a, b, c]: [Vertex; 3], v: Vertex) -> f64 {
    let normal = cross(difference(scene, b, a), difference(scene, c, a));
    let to = difference(scene, v, a);
    (normal[0] * to[0] + normal[1] * to[1] + normal[2] * to[2]).abs()
}
