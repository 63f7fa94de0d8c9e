//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use crate::algorithm::Contradiction;
use std::collections::{BTreeMap, BTreeSet};

use predicament_judge::sign;
use predicament_predicates::{Plane, Question, Scene, Vertex};

use super::answer::{Hull2d, Hull3d, Polygon, Surface};
use predicament_tasks::{Class, Spoiled};

pub(super) fn in_plane() -> Vec<Spoiled<Hull2d>> {
    vec![
        Spoiled::new(
            "hull-repeats-a-vertex",
            "the first vertex of the polygon is repeated as its last",
            "exact",
            &[(Class::Topology, "vertices")],
            |_, _, answer: &mut Polygon| answer.0.vertices.extend(answer.0.vertices.first().copied()),
        ),
        Spoiled::new(
            "hull-is-a-point",
            "the polygon has only its first vertex",
            "exact",
            &[(Class::Topology, "span")],
            |_, _, answer: &mut Polygon| answer.0.vertices.truncate(1),
        ),
        Spoiled::new(
            "hull-begins-elsewhere",
            "the polygon begins at its second vertex",
            "exact",
            &[(Class::Topology, "start")],
            |_, _, answer: &mut Polygon| {
                let count = answer.0.vertices.len();
                answer.0.vertices.rotate_left(1 % count.max(1));
            },
        ),
        Spoiled::new(
            "hull-is-a-star",
            "the polygon goes twice around, by every second vertex",
            "exact",
            &[(Class::Topology, "wound once")],
            |_, _, answer: &mut Polygon| answer.0.vertices = star(&answer.0.vertices),
        ),
        Spoiled::new(
            "hull-loses-a-vertex",
            "a vertex from the middle of the list is lost",
            "exact",
            &[(Class::Topology, "inside")],
            |_, _, answer: &mut Polygon| {
                let vertices = &mut answer.0.vertices;
                if vertices.len() > 3 {
                    vertices.remove(vertices.len() / 2);
                }
            },
        ),
        Spoiled::new(
            "hull-takes-the-later-copy",
            "the second of two points at one place is the vertex",
            "exact",
            &[(Class::Topology, "smallest index")],
            |scene: &Scene, _, answer: &mut Polygon| {
                let later = |v: &Vertex| scene.vertices().find(|w| w > v && scene.point(*w) == scene.point(*v));
                for v in &mut answer.0.vertices {
                    *v = later(v).unwrap_or(*v);
                }
            },
        ),
        Spoiled::new(
            "hull-turns-right",
            "the second and the third vertex of the polygon are exchanged",
            "exact",
            &[(Class::Topology, "convex")],
            |_, _, answer: &mut Polygon| {
                if let [_, second, third, _, ..] = &mut answer.0.vertices[..] {
                    std::mem::swap(second, third);
                }
            },
        ),
        Spoiled::new(
            "hull-keeps-a-point-of-an-edge",
            "a point in the middle of an edge is a vertex",
            "exact",
            &[(Class::Topology, "extreme"), (Class::Topology, "extreme vertices")],
            |scene: &Scene, _, answer: &mut Polygon| {
                let ring = &mut answer.0.vertices;
                let found = (0..ring.len()).find_map(|at| {
                    let [a, b] = [ring[at], ring[(at + 1) % ring.len()]];
                    let is_between = |v: &Vertex| {
                        let apart = [a, b].iter().all(|&end| scene.point(*v) != scene.point(end));
                        apart && sign(scene, Question::Orient2d(Plane::Xy), &[a, b, *v]).is_zero()
                    };
                    Some((at, scene.vertices().find(is_between)?))
                });
                if let Some((at, v)) = found.filter(|_| ring.len() > 2) {
                    ring.insert(at + 1, v);
                }
            },
        ),
        Spoiled::new(
            "hull-gives-up",
            "the chains are reported to meet not only in their ends",
            "exact",
            &[(Class::Topology, "the lower and the upper chain meet in their ends only")],
            |_, _, answer: &mut Polygon| answer.0.broken = Some(Contradiction::Chains),
        ),
    ]
}

/// A star: every second vertex of an odd number, twice around; an even number of vertices stays as it is.
fn star(ring: &[Vertex]) -> Vec<Vertex> {
    let count = ring.len();
    if count < 5 || count.is_multiple_of(2) {
        return ring.to_vec();
    }
    (0..count).map(|at| ring[2 * at % count]).collect()
}

/// Two triangles with a common side: their indices, the side's ends in the order of the first, and their other corners.
struct Pair {
    places: [usize; 2],
    side: [Vertex; 2],
    tips: [Vertex; 2],
}

/// The first two triangular faces with a common side whose corners are not coplanar.
fn pair(scene: &Scene, faces: &[Vec<Vertex>]) -> Option<Pair> {
    let triangles: Vec<(usize, [Vertex; 3])> = faces
        .iter()
        .enumerate()
        .filter_map(|(at, face)| Some((at, <[Vertex; 3]>::try_from(&face[..]).ok()?)))
        .collect();
    let turns = |[a, b, c]: [Vertex; 3]| [[a, b, c], [b, c, a], [c, a, b]];
    for &(i, one) in &triangles {
        for [a, b, c] in turns(one) {
            for &(j, other) in &triangles {
                let across = turns(other).into_iter().find(|&[p, q, _]| p == b && q == a);
                if let Some([.., d]) = across
                    && !sign(scene, Question::Orient3d, &[a, b, c, d]).is_zero()
                {
                    return Some(Pair { places: [i, j], side: [a, b], tips: [c, d] });
                }
            }
        }
    }
    None
}

/// The side of a triangle opposite to this corner, in the triangle's direction.
fn turned(face: &[Vertex], tip: Vertex) -> Option<[Vertex; 2]> {
    let at = face.iter().position(|&v| v == tip)?;
    Some([face[(at + 1) % 3], face[(at + 2) % 3]])
}

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

fn is_in_line(scene: &Scene, args: [Vertex; 3]) -> bool {
    PLANES.iter().all(|&plane| sign(scene, Question::Orient2d(plane), &args).is_zero())
}

/// The corners of all faces, ascending.
fn corners(faces: &[Vec<Vertex>]) -> Vec<Vertex> {
    faces.iter().flatten().copied().collect::<BTreeSet<_>>().into_iter().collect()
}

pub(super) fn in_space() -> Vec<Spoiled<Hull3d>> {
    vec![
        Spoiled::new(
            "hull-loses-a-corner",
            "the last vertex of the surface is not listed",
            "exact",
            &[(Class::Topology, "vertices")],
            |_, _, answer: &mut Surface| {
                answer.0.vertices.pop();
            },
        ),
        Spoiled::new(
            "hull-of-three-faces",
            "the surface has only three faces",
            "exact",
            &[(Class::Topology, "span")],
            |_, _, answer: &mut Surface| answer.0.faces.truncate(3),
        ),
        Spoiled::new(
            "hull-loses-a-side",
            "a flat hull has one face",
            "exact",
            &[(Class::Topology, "two faces")],
            |_, _, answer: &mut Surface| {
                if answer.0.faces.len() == 2 {
                    answer.0.faces.pop();
                }
            },
        ),
        Spoiled::new(
            "hull-repeats-a-corner",
            "the first face has its first corner twice",
            "exact",
            &[(Class::Topology, "faces")],
            |_, _, answer: &mut Surface| {
                if let Some(face) = answer.0.faces.first_mut() {
                    face.extend(face.first().copied());
                }
            },
        ),
        Spoiled::new(
            "hull-loses-a-face",
            "the last face of the surface is lost",
            "exact",
            &[(Class::Topology, "closed")],
            |_, _, answer: &mut Surface| {
                if answer.0.faces.len() > 4 {
                    answer.0.faces.pop();
                }
            },
        ),
        Spoiled::new(
            "hull-pinched",
            "two vertices of the surface without a common face are merged",
            "exact",
            &[(Class::Topology, "manifold")],
            |_, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let are_apart = |v: Vertex, w: Vertex| {
                    let around = |v| hull.faces.iter().filter(move |face| face.contains(&v)).flatten();
                    let near: BTreeSet<&Vertex> = around(v).collect();
                    around(w).all(|u| !near.contains(u))
                };
                let all = hull.vertices.iter().flat_map(|&v| hull.vertices.iter().map(move |&w| [v, w]));
                let Some([v, w]) = all.into_iter().find(|&[v, w]| v < w && are_apart(v, w)) else { return };
                hull.faces.iter_mut().flatten().filter(|u| **u == w).for_each(|u| *u = v);
                hull.vertices.retain(|u| *u != w);
            },
        ),
        Spoiled::new(
            "hull-with-a-leaf",
            "three inner points make a separate surface of two faces",
            "exact",
            &[(Class::Topology, "connected"), (Class::Topology, "euler")],
            |scene: &Scene, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let inside: Vec<Vertex> = scene.vertices().filter(|v| !hull.vertices.contains(v)).take(3).collect();
                if let ([a, b, c], true) = (&inside[..], hull.faces.len() > 3) {
                    hull.faces.extend([vec![*a, *b, *c], vec![*a, *c, *b]]);
                    hull.vertices = corners(&hull.faces);
                }
            },
        ),
        Spoiled::new(
            "hull-bent-face",
            "two triangles that are not coplanar are merged into one face",
            "exact",
            &[(Class::Topology, "planar")],
            |scene: &Scene, _, answer: &mut Surface| {
                let Some(Pair { places: [i, j], side: [a, b], tips: [c, d] }) = pair(scene, &answer.0.faces) else {
                    return;
                };
                answer.0.faces[i] = vec![a, d, b, c];
                answer.0.faces.remove(j);
            },
        ),
        Spoiled::new(
            "hull-flips-an-edge",
            "two triangles that are not coplanar have the other diagonal as their edge",
            "exact",
            &[(Class::Topology, "convex")],
            |scene: &Scene, _, answer: &mut Surface| {
                let Some(Pair { places: [i, j], side: [a, b], tips: [c, d] }) = pair(scene, &answer.0.faces) else {
                    return;
                };
                answer.0.faces[i] = vec![a, d, c];
                answer.0.faces[j] = vec![d, b, c];
            },
        ),
        Spoiled::new(
            "hull-notched-face",
            "a face is divided at an inner point into two faces, one of which is not convex",
            "exact",
            &[(Class::Topology, "face convex")],
            |scene: &Scene, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let is_within = |face: &[Vertex], p: Vertex| {
                    let [a, b, c] = [face[0], face[1], face[2]];
                    let n = face.len();
                    sign(scene, Question::Orient3d, &[a, b, c, p]).is_zero()
                        && (0..n).all(|at| !is_in_line(scene, [face[at], face[(at + 1) % n], p]))
                        && !is_in_line(scene, [a, c, p])
                };
                let inner: Vec<Vertex> = scene.vertices().filter(|v| !hull.vertices.contains(v)).collect();
                let found = hull
                    .faces
                    .iter()
                    .enumerate()
                    .filter(|(_, face)| face.len() > 3)
                    .find_map(|(at, face)| inner.iter().copied().find(|&p| is_within(face, p)).map(|p| (at, p)));
                let Some((at, p)) = found else { return };
                let face = hull.faces[at].clone();
                let rest = face[2..].iter().chain(&face[..1]).copied();
                hull.faces[at] = rest.chain([p]).collect();
                hull.faces.push(vec![face[0], face[1], face[2], p]);
                hull.vertices = corners(&hull.faces);
            },
        ),
        Spoiled::new(
            "hull-with-a-point-of-an-edge",
            "a point in the middle of an edge is a vertex of both faces there",
            "exact",
            &[(Class::Topology, "extreme")],
            |scene: &Scene, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let inner: Vec<Vertex> = scene.vertices().filter(|v| !hull.vertices.contains(v)).collect();
                let is_on = |a: Vertex, b: Vertex, p: Vertex| {
                    let apart = scene.point(p) != scene.point(a) && scene.point(p) != scene.point(b);
                    apart && is_in_line(scene, [a, b, p])
                };
                let edges = hull.faces.iter().flat_map(|face| {
                    let n = face.len();
                    (0..n).map(move |at| [face[at], face[(at + 1) % n]])
                });
                let found = edges
                    .into_iter()
                    .find_map(|[a, b]| Some(([a, b], inner.iter().copied().find(|&p| is_on(a, b, p))?)));
                let Some(([a, b], p)) = found else { return };
                for face in &mut hull.faces {
                    let n = face.len();
                    let at = (0..n).find(|&at| {
                        let edge = [face[at], face[(at + 1) % n]];
                        edge == [a, b] || edge == [b, a]
                    });
                    at.into_iter().for_each(|at| face.insert(at + 1, p));
                }
                hull.vertices = corners(&hull.faces);
            },
        ),
        Spoiled::new(
            "hull-over-a-pentagram",
            "the faces of two pyramids over a ring go twice around, by every second vertex of the ring",
            "exact",
            &[(Class::Topology, "wound once")],
            |_, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let ring = |tip: Vertex| -> Vec<[Vertex; 2]> {
                    let around = hull.faces.iter().filter(|face| face.len() == 3 && face.contains(&tip));
                    around.filter_map(|face| turned(face, tip)).collect()
                };
                let count = hull.vertices.len().saturating_sub(2);
                let tips: Vec<Vertex> = hull.vertices.iter().copied().filter(|&v| ring(v).len() == count).collect();
                if let ([top, bottom], true) = (&tips[..], count >= 5 && !count.is_multiple_of(2)) {
                    let mut faces = Vec::new();
                    for tip in [*top, *bottom] {
                        let next: BTreeMap<Vertex, Vertex> = ring(tip).into_iter().map(|[a, b]| (a, b)).collect();
                        let two_on = |v: &Vertex| next.get(next.get(v)?).copied();
                        faces.extend(next.keys().filter_map(|&v| Some(vec![v, two_on(&v)?, tip])));
                    }
                    hull.faces = faces;
                }
            },
        ),
        Spoiled::new(
            "hull-cuts-a-face",
            "a face with more than three corners is cut into two",
            "exact",
            &[(Class::Topology, "coplanar faces")],
            |_, _, answer: &mut Surface| {
                let faces = &mut answer.0.faces;
                if let Some(at) = faces.iter().position(|face| face.len() > 3) {
                    let other = faces[at][..3].to_vec();
                    faces[at].remove(1);
                    faces.push(other);
                }
            },
        ),
        Spoiled::new(
            "hull-cut-off",
            "the triangle of its neighbours cuts off a vertex that has three triangles",
            "exact",
            &[(Class::Topology, "inside")],
            |_, _, answer: &mut Surface| {
                let hull = &mut answer.0;
                let around = |v: Vertex| hull.faces.iter().filter(move |face| face.contains(&v));
                let is_tip = |v: &Vertex| around(*v).count() == 3 && around(*v).all(|face| face.len() == 3);
                let Some(tip) = hull.vertices.iter().copied().find(is_tip).filter(|_| hull.faces.len() > 4) else {
                    return;
                };
                let next: BTreeMap<Vertex, Vertex> =
                    around(tip).filter_map(|face| turned(face, tip)).map(|[a, b]| (a, b)).collect();
                let ring = |a: Vertex| Some(vec![a, *next.get(&a)?, *next.get(next.get(&a)?)?]);
                let Some(face) = next.keys().next().and_then(|&a| ring(a)) else { return };
                hull.faces.retain(|face| !face.contains(&tip));
                hull.faces.push(face);
                hull.vertices = corners(&hull.faces);
            },
        ),
        Spoiled::new(
            "hull-stops-stitching",
            "the faces between two hulls are reported not to make a band",
            "exact",
            &[(Class::Topology, "the stitching faces close to a band")],
            |_, _, answer: &mut Surface| answer.0.broken = Some(Contradiction::Band),
        ),
    ]
}
