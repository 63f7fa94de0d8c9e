//! The points and segments of one mesh, by the simplices that they are in.

use predicament_predicates::{Predicates, Vertex};

use super::found::{Found, Pair, Segment, Simplex};
use crate::algorithm::overlay::along::sort_along;
use crate::algorithm::overlay::near::Near;

/// The points and segments in one mesh's simplices.
pub(super) struct Marks {
    /// Points inside edges, by edge, in order from the edge's first vertex to its second.
    on_edges: Lists<Vertex>,
    /// Segments along edges, by edge.
    along_edges: Lists<Mark>,
    /// Points inside triangles, by triangle.
    in_triangles: Lists<Vertex>,
    /// Segments inside triangles, by triangle.
    across_triangles: Lists<Mark>,
}

/// A segment in a simplex of one mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    /// Its ends, as in [`Segment::ends`].
    pub ends: [Vertex; 2],
    /// The edge or triangle of the other mesh.
    pub with: Simplex,
}

/// Lists by index.
struct Lists<T> {
    ends: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Lists<T> {
    fn new(count: usize, mut items: Vec<(u32, T)>) -> Lists<T> {
        items.sort_by_key(|item| item.0);
        let mut ends = vec![0; count];
        items.iter().for_each(|item| ends[item.0 as usize] += 1);
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum;
        }
        Lists { ends, items: items.into_iter().map(|item| item.1).collect() }
    }

    fn range(&self, at: u32) -> std::ops::Range<usize> {
        let start = at.checked_sub(1).map_or(0, |before| self.ends[before as usize]);
        start as usize..self.ends[at as usize] as usize
    }

    fn of(&self, at: u32) -> &[T] {
        &self.items[self.range(at)]
    }
}

impl Marks {
    /// Distributes what was found; `vertices` are the vertices of the points.
    pub fn new(session: &dyn Predicates, mesh: usize, near: &Near, found: &Found, vertices: &[Vertex]) -> Marks {
        let vertex = |pair: Pair| vertices[found.points.partition_point(|other| *other < pair)];
        let (mut on_edges, mut in_triangles) = (Vec::new(), Vec::new());
        for (pair, &v) in found.points.iter().zip(vertices) {
            match pair[mesh] {
                Simplex::Edge(edge) => on_edges.push((edge, v)),
                Simplex::Triangle(triangle) => in_triangles.push((triangle, v)),
                Simplex::Vertex(_) => {}
            }
        }
        let (mut along_edges, mut across_triangles) = (Vec::new(), Vec::new());
        for Segment { of, ends } in &found.segments {
            let mark = Mark { ends: ends.map(vertex), with: of[1 - mesh] };
            match of[mesh] {
                Simplex::Edge(edge) => along_edges.push((edge, mark)),
                Simplex::Triangle(triangle) => across_triangles.push((triangle, mark)),
                Simplex::Vertex(_) => {}
            }
        }
        let [edges, triangles] = [near.edges.len(), near.triangles.len()];
        let mut marks = Marks {
            on_edges: Lists::new(edges, on_edges),
            along_edges: Lists::new(edges, along_edges),
            in_triangles: Lists::new(triangles, in_triangles),
            across_triangles: Lists::new(triangles, across_triangles),
        };
        for (edge, &ends) in (0..).zip(&near.edges) {
            let range = marks.on_edges.range(edge);
            if range.len() > 1 {
                sort_along(session, ends, &mut marks.on_edges.items[range], |v| v);
            }
        }
        marks
    }

    /// The points inside an edge, in order.
    pub fn on_edge(&self, edge: u32) -> &[Vertex] {
        self.on_edges.of(edge)
    }

    /// The segments along an edge.
    pub fn along_edge(&self, edge: u32) -> &[Mark] {
        self.along_edges.of(edge)
    }

    /// The points inside a triangle.
    pub fn in_triangle(&self, triangle: u32) -> &[Vertex] {
        self.in_triangles.of(triangle)
    }

    /// The segments inside a triangle.
    pub fn across_triangle(&self, triangle: u32) -> &[Mark] {
        self.across_triangles.of(triangle)
    }
}
