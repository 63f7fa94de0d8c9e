//! Triangles by their corners, each with the number of times that a surface passes it.

use std::collections::BTreeMap;

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

/// An oriented triangle with an area.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Face {
    pub corners: [Vertex; 3],
    /// The number of times that the surface passes it in its orientation, less the times in the other: at least one.
    pub times: i32,
}

/// The faces in the sum of triangles, in the order of their first occurrence, without pairs of opposite triangles,
/// triangles with a vertex twice, and triangles without area.
pub(super) fn summed(session: &dyn Predicates, triangles: impl Iterator<Item = [Vertex; 3]>) -> Vec<Face> {
    let mut places = BTreeMap::new();
    let mut all: Vec<Face> = Vec::new();
    for corners in triangles {
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            continue;
        }
        let mut sorted = corners;
        sorted.sort_unstable();
        let at = *places.entry(sorted).or_insert(all.len());
        if at == all.len() {
            all.push(Face { corners, times: 0 });
        }
        let known = all[at].corners;
        let is_same = [[a, b, c], [b, c, a], [c, a, b]].contains(&known);
        all[at].times += if is_same { 1 } else { -1 };
    }
    all.retain(|face| face.times != 0 && !is_flat(session, face.corners));
    all.iter_mut().filter(|face| face.times < 0).for_each(|face| {
        face.corners.swap(1, 2);
        face.times = -face.times;
    });
    all
}

fn is_flat(session: &dyn Predicates, [a, b, c]: [Vertex; 3]) -> bool {
    [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().all(|plane| session.orient2d(plane, a, b, c).is_zero())
}

/// The turn of three vertices in a coordinate plane; zero if two of them are one vertex.
pub(crate) fn turn(session: &dyn Predicates, plane: Plane, [a, b, c]: [Vertex; 3]) -> Sign {
    if a == b || b == c || c == a { Sign::Zero } else { session.orient2d(plane, a, b, c) }
}

/// The side of a triangle's plane on which a vertex is: positive behind it; zero for a corner.
pub(crate) fn side(session: &dyn Predicates, corners: [Vertex; 3], v: Vertex) -> Sign {
    let [a, b, c] = corners;
    if corners.contains(&v) { Sign::Zero } else { session.orient3d(a, b, c, v) }
}
