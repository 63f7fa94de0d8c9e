//! The vertices of one object that are inside the other.

use std::collections::BTreeMap;

use predicament_grid::Bounds;
use predicament_mesh_rays::algorithm::crossings;
use predicament_mesh_rays::answer::Extent;
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::Indexed;
use super::near::point;
use crate::answer::Object;

/// One vertex of each connected part of an object, ascending.
pub(super) fn one_of_each(object: &Object) -> Vec<Vertex> {
    let mut parent: BTreeMap<Vertex, Vertex> = object.vertices().into_iter().map(|v| (v, v)).collect();
    for part in object.parts() {
        let roots: Vec<Vertex> = part.iter().map(|&v| root(&mut parent, v)).collect();
        let least = roots.iter().copied().min();
        for (root, least) in roots.into_iter().zip(least.into_iter().cycle()) {
            parent.insert(root, least);
        }
    }
    parent.into_iter().filter(|(v, up)| v == up).map(|(v, _)| v).collect()
}

/// The smallest vertex of a vertex' part, as far as it is known; the path to it becomes shorter.
fn root(parent: &mut BTreeMap<Vertex, Vertex>, mut v: Vertex) -> Vertex {
    while parent[&v] != v {
        let up = parent[&parent[&v]];
        parent.insert(v, up);
        v = up;
    }
    v
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
