//! Checks of hulls in space.

use std::collections::HashSet;

use predicament_predicates::{Plane, Question, Sign, Vertex};

use super::closed::{Edges, closed, edges_of};
use super::plane::{are_vertices, polygon, ring, smallest_at_their_places};
use super::tally::{Flaw, Signs, Tally};
use super::wound::wound_once;

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// The failed checks of the hull of all vertices of a scene in space: vertices ascending, faces counterclockwise as
/// seen from outside. A flat hull has one polygon as two faces back to back.
#[must_use]
pub fn space_flaws(signs: Signs<'_>, vertices: &[Vertex], faces: &[Vec<Vertex>]) -> Vec<Flaw> {
    let mut tally = Tally::new(signs);
    if !are_vertices(&mut tally, vertices) {
        return tally.finish();
    }
    let all: Vec<Vertex> = tally.scene().vertices().collect();
    let exact = flat(&tally, &all);
    // True if the hull has a volume: exactly, or after the perturbation.
    let is_solid = if tally.has_ties() { matches!(exact, Flat::Not(_)) } else { all.len() > 3 };
    if is_solid {
        solid(&mut tally, &exact, vertices, faces);
    } else {
        flat_hull(&mut tally, &exact, vertices, faces);
    }
    smallest_at_their_places(&mut tally, vertices);
    tally.finish()
}

/// The exact span of the scene.
enum Flat {
    /// At most a plane: its projection to this coordinate plane has its full dimension. `None` if all points are in one
    /// place.
    In(Option<Plane>),
    /// Four vertices that are not coplanar.
    Not([Vertex; 4]),
}

fn flat(tally: &Tally<'_>, all: &[Vertex]) -> Flat {
    let (scene, exact) = (tally.scene(), tally.signs.exact);
    let Some((&a, others)) = all.split_first() else { return Flat::In(None) };
    let Some(&b) = others.iter().find(|&&b| scene.point(a) != scene.point(b)) else { return Flat::In(None) };
    let seen = |&c: &Vertex| {
        let plane = PLANES.into_iter().find(|&plane| c != b && !exact.orient2d(plane, a, b, c).is_zero());
        plane.map(|plane| (c, plane))
    };
    let Some((c, plane)) = others.iter().find_map(seen) else {
        // The line's projection to this plane is not a point.
        return Flat::In(PLANES.into_iter().find(|&plane| scene.point2(plane, a) != scene.point2(plane, b)));
    };
    let is_off = |&&d: &&Vertex| d != b && d != c && !exact.orient3d(a, b, c, d).is_zero();
    others.iter().find(is_off).map_or(Flat::In(Some(plane)), |&d| Flat::Not([a, b, c, d]))
}

/// Checks a hull without volume: `two faces`, back to back, and each of them as a polygon.
fn flat_hull(tally: &mut Tally<'_>, exact: &Flat, vertices: &[Vertex], faces: &[Vec<Vertex>]) {
    let all: Vec<Vertex> = tally.scene().vertices().collect();
    let plane = match exact {
        Flat::In(plane) => plane.unwrap_or(Plane::Xy),
        // Three perturbed points do not contain four points.
        Flat::Not(_) => Plane::Xy,
    };
    if vertices.len() < 3 {
        if !faces.is_empty() {
            tally.flaw("two faces", &[], || format!("{} faces of {} vertices", faces.len(), vertices.len()));
        }
        let mut ends = vertices.to_vec();
        let scene = tally.scene();
        if tally.has_ties() {
            ends.sort_by(|&v, &w| scene.point2(plane, v).partial_cmp(&scene.point2(plane, w)).expect("finite"));
        }
        return match tally.signs.perturbed {
            None => polygon(tally, plane, &ends, &all),
            Some(_) if vertices.len() != all.len() => {
                tally.flaw("span", &[], || format!("{} vertices of {} perturbed points", vertices.len(), all.len()));
            }
            Some(_) => {}
        };
    }
    closed(tally, vertices, faces);
    if faces.len() != 2 {
        return tally.flaw("two faces", &[], || format!("{} faces of a flat hull", faces.len()));
    }
    if !tally.is_clean() || !tally.has_ties() {
        return;
    }
    // One of the two faces is counterclockwise in the plane; either may be.
    let scene = tally.scene();
    let mut face = faces[0].clone();
    let turn = tally.signs.exact.orient2d(plane, face[0], face[1], face[2]);
    if turn == Sign::Negative {
        face.reverse();
    }
    let first = (0..face.len())
        .min_by(|&i, &j| scene.point2(plane, face[i]).partial_cmp(&scene.point2(plane, face[j])).expect("finite"));
    face.rotate_left(first.unwrap_or(0));
    polygon(tally, plane, &face, &all);
}

/// Checks a hull with a volume.
fn solid(tally: &mut Tally<'_>, exact: &Flat, vertices: &[Vertex], faces: &[Vec<Vertex>]) {
    if faces.len() < 4 {
        return tally.flaw("span", &[], || format!("{} faces of a hull with a volume", faces.len()));
    }
    let edges = closed(tally, vertices, faces);
    if !tally.is_clean() {
        return;
    }
    faces.iter().for_each(|face| planar(tally, face));
    if tally.is_clean() {
        convex(tally, faces, &edges);
    }
    if !tally.is_clean() {
        return;
    }
    if let Flat::Not(_) = exact
        && let Flat::Not(inner) = flat(tally, vertices)
    {
        // Faces that have area only by the perturbation do not count for a ray.
        let exact = tally.signs.exact;
        let has_area = |face: &[Vertex]| {
            PLANES.into_iter().any(|plane| !exact.orient2d(plane, face[0], face[1], face[2]).is_zero())
        };
        let faces: Vec<&[Vertex]> = faces.iter().map(Vec::as_slice).filter(|face| has_area(face)).collect();
        wound_once(tally, inner, &faces);
    }
    inside(tally, vertices, faces);
}

/// Checks one face by `planar`, `face convex` and `extreme`.
///
/// `planar`: all vertices of the face are in its plane. `face convex`: it turns to one side only. `extreme`: it turns
/// at each vertex. A triangle of zero area is legal if ties are broken.
fn planar(tally: &mut Tally<'_>, face: &[Vertex]) {
    let exact = tally.signs.exact;
    let [a, b, c] = [face[0], face[1], face[2]];
    for &d in &face[3..] {
        if !exact.orient3d(a, b, c, d).is_zero() {
            tally
                .flaw("planar", &[a, b, c, d], || format!("vertex {d} of a face is not in the plane of {a}, {b}, {c}"));
        }
    }
    if !tally.has_ties() {
        return;
    }
    let turned = PLANES.into_iter().map(|plane| (plane, exact.orient2d(plane, a, b, c)));
    match turned.into_iter().find(|(_, sign)| *sign != Sign::Zero) {
        None => tally.flaw("extreme", &[a, b, c], || format!("{a}, {b} and {c} are on one line")),
        Some((plane, Sign::Positive)) => ring(tally, plane, face, "face convex", Some("extreme")),
        Some((plane, _)) => {
            let back: Vec<Vertex> = face.iter().rev().copied().collect();
            ring(tally, plane, &back, "face convex", Some("extreme"));
        }
    }
}

/// Checks `convex`: at each edge, the next vertex of the one face is not outside of the other; and `coplanar faces`: it
/// is not in the other's plane either.
fn convex(tally: &mut Tally<'_>, faces: &[Vec<Vertex>], edges: &Edges) {
    for face in faces {
        let [a, b, c] = [face[0], face[1], face[2]];
        for [u, v] in edges_of(face).filter(|[u, v]| u < v) {
            let other = &faces[edges[&[v, u]]];
            // Any vertex of the other face that is not in this one.
            if let Some(&w) = other.iter().find(|w| !face.contains(w)) {
                tally.positive("convex", Some("coplanar faces"), Question::Orient3d, &[a, b, c, w]);
            }
        }
    }
}

/// Checks `inside`: no point is outside of a face. All pairs of a point and a face, or those of an even sample of the
/// points.
fn inside(tally: &mut Tally<'_>, vertices: &[Vertex], faces: &[Vec<Vertex>]) {
    let corners: HashSet<Vertex> = vertices.iter().copied().collect();
    let others: Vec<Vertex> = tally.scene().vertices().filter(|v| !corners.contains(v)).collect();
    let afforded = (tally.signs.pairs / faces.len().max(1)).max(1);
    let step = others.len().div_ceil(afforded).max(1);
    for &v in others.iter().step_by(step) {
        for face in faces {
            tally.positive("inside", None, Question::Orient3d, &[face[0], face[1], face[2], v]);
        }
    }
}
