//! The vertices of one object that are inside the other.

use predicament_grid::Bounds;
use predicament_mesh_rays::algorithm::crossings;
use predicament_mesh_rays::answer::Extent;
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::Indexed;
use super::near::point;
use crate::answer::Object;

/// One vertex of each connected part of an object, ascending.
pub(super) fn one_of_each(object: &Object) -> Vec<Vertex> {
    let vertices = object.vertices();
    let place = |v: &Vertex| vertices.binary_search(v).unwrap_or(0);
    let mut parent: Vec<usize> = (0..vertices.len()).collect();
    for part in object.parts() {
        let mut first = root(&mut parent, place(&part[0]));
        for v in &part[1..] {
            let other = root(&mut parent, place(v));
            parent[other.max(first)] = other.min(first);
            first = first.min(other);
        }
    }
    vertices.iter().zip(0..).filter(|&(_, at)| parent[at] == at).map(|(&v, _)| v).collect()
}

/// The place of the smallest vertex of a part, as far as it is known; the path to it becomes shorter.
fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}

/// True if one of these vertices is inside the object, and not on its boundary. An open object has no inside.
pub(super) fn has_inside<P: Predicates + ?Sized>(session: &P, of: &Indexed, vertices: &[Vertex]) -> bool {
    let scene = session.scene();
    let bounds = of.parts.bounds();
    let is_near = |v: &&Vertex| bounds.is_near(&Bounds::of([point(scene, **v)]), session.reach());
    let mut near = vertices.iter().filter(is_near).copied().peekable();
    if !of.is_closed || near.peek().is_none() {
        return false;
    }
    if scene.dimension().count() == 2 {
        return near.any(|v| winding(session, &of.object, v).is_some_and(|winding| winding != 0));
    }
    let ends = of.object.part(0);
    let away = |v: Vertex| ends.iter().copied().find(|&end| scene.point(end) != scene.point(v)).map(|end| [v, end]);
    let rays: Vec<[Vertex; 2]> = near.filter_map(away).collect();
    crossings(session, of.mesh(scene), Extent::Ray, &rays).into_iter().any(|sum| sum.is_some_and(|sum| sum != 0))
}

/// The winding number of a polygon around a vertex, by the edges across the ray to larger x; `None` on the boundary.
fn winding<P: Predicates + ?Sized>(session: &P, polygon: &Object, v: Vertex) -> Option<i64> {
    let mut winding = 0;
    for edge in polygon.parts() {
        let &[a, b] = edge else { continue };
        let [from, to] = [a, b].map(|end| session.compare(Axis::Y, end, v));
        if from == to && from != Sign::Zero {
            continue;
        }
        let side = session.orient2d(Plane::Xy, a, b, v);
        if side == Sign::Zero {
            let along = [a, b].map(|end| session.compare(Axis::X, end, v));
            let is_between = |[one, other]: [Sign; 2]| one == Sign::Zero || other == Sign::Zero || one != other;
            if is_between(along) && is_between([from, to]) {
                return None;
            }
        }
        let is_above = |sign: Sign| sign == Sign::Positive;
        match (is_above(from), is_above(to)) {
            (false, true) if side == Sign::Positive => winding += 1,
            (true, false) if side == Sign::Negative => winding -= 1,
            _ => {}
        }
    }
    Some(winding)
}
