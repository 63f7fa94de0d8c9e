//! Vertices on edges: triangles at an open edge are divided at the vertices of other open edges inside it.
//!
//! The surface is closed along each line, but not edge by edge: one side of a line may have a vertex that the other
//! side lacks. Between consecutive vertices, both directions are passed equally often.

use std::collections::HashMap;

use predicament_grid::{Bounds, BoxIndex};
use predicament_predicates::{Axis, Plane, Predicates, Vertex};

use super::places::Places;
use predicament_grid::sort::sort_by_sign;

/// The vertices inside edges.
pub(crate) struct Joints {
    /// For each edge, from the smaller vertex to the larger, the vertices inside it in order.
    inside: HashMap<[Vertex; 2], Vec<Vertex>>,
}

impl Joints {
    /// Finds the vertices of these edges that are inside other edges of the list.
    pub fn of(session: &dyn Predicates, places: &Places, edges: &[[Vertex; 2]]) -> Joints {
        let mut vertices: Vec<Vertex> = edges.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |v: Vertex| places.nearest(session.scene(), v);
        let index = BoxIndex::new(vertices.iter().map(|&v| Bounds::of([place(v)])).collect());
        let (mut inside, mut found) = (HashMap::new(), Vec::new());
        for &[a, b] in edges {
            let ends = [a, b].map(place);
            index.near(&Bounds::of(ends), 0.0, &mut found);
            let extent = [0, 1, 2].map(|axis: usize| (ends[0][axis] / 2.0 - ends[1][axis] / 2.0).abs());
            let mut axes = [Axis::X, Axis::Y, Axis::Z];
            axes.sort_by(|i, j| extent[j.index()].total_cmp(&extent[i.index()]));
            // Different vertices are at different positions.
            let order = axes.into_iter().map(|axis| (axis, session.compare(axis, b, a)));
            let Some((axis, ahead)) = order.into_iter().find(|(_, sign)| !sign.is_zero()) else { continue };
            let is_between = |v: Vertex| {
                session.compare(axis, v, a) == ahead
                    && session.compare(axis, b, v) == ahead
                    && [Plane::Xy, Plane::Yz, Plane::Zx]
                        .into_iter()
                        .all(|plane| session.orient2d(plane, a, b, v).is_zero())
            };
            let candidates = found.iter().map(|&at| vertices[at as usize]);
            let mut on: Vec<Vertex> = candidates.filter(|&v| v != a && v != b && is_between(v)).collect();
            if !on.is_empty() {
                sort_by_sign(&mut on, |v, w| session.compare(axis, v, w) * ahead);
                inside.insert([a, b], on);
            }
        }
        Joints { inside }
    }

    /// True if no edge has a vertex inside.
    pub fn is_empty(&self) -> bool {
        self.inside.is_empty()
    }

    /// A triangle, divided at all vertices inside its edges; `None` if there are none.
    pub fn divided(&self, triangle: [Vertex; 3]) -> Option<Vec<[Vertex; 3]>> {
        let [a, b, c] = triangle;
        let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| {
            let inside = self.inside.get(&[from.min(to), from.max(to)]);
            let mut inside = inside.cloned().unwrap_or_default();
            if to < from {
                inside.reverse();
            }
            inside
        });
        if sides.iter().all(Vec::is_empty) {
            return None;
        }
        let mut all = Vec::new();
        divide(triangle, sides, &mut all);
        Some(all)
    }
}

/// Divides a triangle at vertices inside its sides. The result is a fan from the corner opposite to a side with such
/// vertices; the other two sides belong to the first and the last triangle of the fan.
fn divide([a, b, c]: [Vertex; 3], [ab, bc, ca]: [Vec<Vertex>; 3], all: &mut Vec<[Vertex; 3]>) {
    if ab.is_empty() {
        if bc.is_empty() && ca.is_empty() {
            all.push([a, b, c]);
        } else {
            divide([b, c, a], [bc, ca, ab], all);
        }
        return;
    }
    let (first, last) = (ab[0], ab[ab.len() - 1]);
    divide([c, a, first], [ca, Vec::new(), Vec::new()], all);
    all.extend(ab.windows(2).map(|pair| [c, pair[0], pair[1]]));
    divide([c, last, b], [Vec::new(), Vec::new(), bc], all);
}
