//! A list of triangles in which edges collapse.

use std::collections::BTreeSet;

use predicament_predicates::Vertex;

/// The reason why an edge cannot be collapsed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Obstacle {
    /// The two vertices are not joined by an edge.
    NoEdge,
    /// Both ends have this common neighbour, which is not across from the edge.
    Vertex(Vertex),
    /// Both ends are on the boundary, and the edge is not.
    Boundary,
    /// Both ends have triangles with this edge, or it joins both ends' boundaries to one vertex.
    Edge(Vertex),
}

impl std::fmt::Display for Obstacle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Obstacle::NoEdge => f.write_str("no edge joins them"),
            Obstacle::Vertex(v) => write!(f, "both are joined to {v}, which is not across from the edge"),
            Obstacle::Boundary => f.write_str("both are on the boundary, and the edge is not"),
            Obstacle::Edge(v) => write!(f, "triangles or boundaries would meet at {v}"),
        }
    }
}

/// Triangles, and those around each vertex.
#[derive(Clone, Debug)]
pub struct Replay {
    triangles: Vec<Option<[Vertex; 3]>>,
    around: Vec<Vec<usize>>,
    left: usize,
}

impl Replay {
    /// The triangles of a scene with so many vertices.
    ///
    /// # Panics
    /// If a triangle has another vertex.
    #[must_use]
    pub fn new(vertices: usize, triangles: &[[Vertex; 3]]) -> Replay {
        let mut around = vec![Vec::new(); vertices];
        for (at, corners) in triangles.iter().enumerate() {
            corners.iter().for_each(|v| around[v.index()].push(at));
        }
        Replay { triangles: triangles.iter().copied().map(Some).collect(), around, left: triangles.len() }
    }

    /// The triangles that are left, in the order of the input.
    pub fn triangles(&self) -> impl Iterator<Item = [Vertex; 3]> + '_ {
        self.triangles.iter().flatten().copied()
    }

    /// The number of triangles that are left.
    #[must_use]
    pub fn left(&self) -> usize {
        self.left
    }

    /// The triangles around a vertex, each from this vertex on; none if the scene lacks it.
    fn fan(&self, v: Vertex) -> impl Iterator<Item = [Vertex; 3]> + '_ {
        let around = self.around.get(v.index()).into_iter().flatten();
        around.filter_map(|&at| self.triangles[at]).filter_map(move |[a, b, c]| match v {
            _ if v == a => Some([a, b, c]),
            _ if v == b => Some([b, c, a]),
            _ if v == c => Some([c, a, b]),
            _ => None,
        })
    }

    /// The other two corners of the triangles around a vertex that a step moves and does not remove.
    pub fn moved(&self, gone: Vertex, kept: Vertex) -> impl Iterator<Item = [Vertex; 2]> + '_ {
        self.fan(gone).map(|[_, b, c]| [b, c]).filter(move |base| !base.contains(&kept))
    }

    /// The neighbours of a vertex.
    fn neighbours(&self, v: Vertex) -> BTreeSet<Vertex> {
        self.fan(v).flat_map(|[_, b, c]| [b, c]).collect()
    }

    /// The corners across from an edge.
    fn apexes(&self, [u, v]: [Vertex; 2]) -> Vec<Vertex> {
        self.fan(u)
            .filter_map(|[_, b, c]| match v {
                _ if v == b => Some(c),
                _ if v == c => Some(b),
                _ => None,
            })
            .collect()
    }

    /// The neighbours of a vertex along the boundary.
    fn along_boundary(&self, v: Vertex) -> BTreeSet<Vertex> {
        self.neighbours(v).into_iter().filter(|&other| self.apexes([v, other]).len() == 1).collect()
    }

    /// The reason why the collapse of an edge would change the surface: its first violation of the link condition.
    #[must_use]
    pub fn obstacle(&self, [u, v]: [Vertex; 2]) -> Option<Obstacle> {
        let apexes = self.apexes([u, v]);
        if apexes.is_empty() {
            return Some(Obstacle::NoEdge);
        }
        let [of_u, of_v] = [u, v].map(|v| self.neighbours(v));
        if let Some(&common) = of_u.intersection(&of_v).find(|common| !apexes.contains(common)) {
            return Some(Obstacle::Vertex(common));
        }
        let [rim_u, rim_v] = [u, v].map(|v| self.along_boundary(v));
        if !rim_u.is_empty() && !rim_v.is_empty() && apexes.len() > 1 {
            return Some(Obstacle::Boundary);
        }
        // Edges of both links: to the vertex that closes the boundary, and between two vertices.
        if let Some(&common) = rim_u.intersection(&rim_v).next() {
            return Some(Obstacle::Edge(common));
        }
        let link = |v: Vertex| self.fan(v).map(|[_, b, c]| [b.min(c), b.max(c)]).collect::<BTreeSet<_>>();
        link(u).intersection(&link(v)).next().map(|edge| Obstacle::Edge(edge[0]))
    }

    /// Collapses an edge: triangles with both ends are removed, and those around `gone` get `kept` in its place.
    pub fn collapse(&mut self, gone: Vertex, kept: Vertex) {
        let Some(moved) = self.around.get_mut(gone.index()).map(std::mem::take) else { return };
        for at in moved {
            let Some(corners) = self.triangles[at] else { continue };
            if corners.contains(&kept) {
                self.triangles[at] = None;
                self.left -= 1;
            } else {
                self.triangles[at] = Some(corners.map(|v| if v == gone { kept } else { v }));
                self.around[kept.index()].push(at);
            }
        }
        let triangles = &self.triangles;
        self.around[kept.index()].retain(|&at| triangles[at].is_some());
    }

    /// The edges that are left, each in both directions, ascending.
    #[must_use]
    pub fn edges(&self) -> Vec<[Vertex; 2]> {
        let sides = self.triangles().flat_map(|[a, b, c]| [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]]);
        let mut edges: Vec<[Vertex; 2]> = sides.collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }
}
