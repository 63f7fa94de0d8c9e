//! The vertices of one object that are inside the other: winding numbers by the judge, or in rationals in the plane.

use predicament_judge::rational;
use predicament_judge::solids::{Materials, Place};
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

use crate::answer::Object;

/// True if one of these vertices is inside the object, and not on its boundary.
pub(super) fn has_inside(scene: &Scene, object: &Object, mut vertices: impl Iterator<Item = Vertex>) -> bool {
    if !object.is_closed() {
        return false;
    }
    if scene.dimension().count() == 2 {
        return vertices.any(|v| winding(scene, object, v).is_some_and(|winding| winding != 0));
    }
    let triangles = object.triangles();
    let sides = vec![[0, 1]; triangles.len()];
    let judge = Materials::new(scene, &triangles, &sides);
    vertices.any(|v| match judge.locate(v) {
        Place::On(_) => false,
        Place::In(region) => region == 1,
        Place::Windings(all) => all.iter().any(|(region, winding)| *region == 1 && *winding != 0),
    })
}

/// The winding number of a polygon around a vertex, by the ray to larger y; `None` on the boundary.
fn winding(scene: &Scene, polygon: &Object, v: Vertex) -> Option<i64> {
    let at = |v: Vertex| -> [Rational; 2] { [0, 1].map(|axis: usize| rational(scene.point(v)[axis])) };
    let [x, y] = at(v);
    let mut winding = 0;
    for part in polygon.parts() {
        let [[ax, ay], [bx, by]] = [at(part[0]), at(part[1])];
        let (low, high) = (ax.clone().min(bx.clone()), ax.clone().max(bx.clone()));
        if x < low || x > high {
            continue;
        }
        if ax == bx {
            if y >= ay.clone().min(by.clone()) && y <= ay.max(by) {
                return None;
            }
            continue;
        }
        // The height of the edge above the vertex.
        let above =
            Rational::from(&ay - &y) + Rational::from(&by - &ay) * Rational::from(&x - &ax) / (&bx - ax.clone());
        if above == 0 {
            return None;
        }
        // A vertex counts as left of the ray, so that each crossing of a corner counts once.
        if above > 0 && x != high {
            winding += if ax < bx { -1 } else { 1 };
        }
    }
    Some(winding)
}
