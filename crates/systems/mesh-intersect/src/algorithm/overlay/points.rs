//! The points where edges pass through triangles: constructed together, and sorted along their edges.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Predicates, Refused, Vertex};

use super::along::sort_along;
use super::meet::Hit;
use super::near::{Near, number};

/// The points on the edges of one mesh.
pub(super) struct Points {
    /// The hits, by triangle of the other mesh, then by edge.
    pub hits: Vec<Hit>,
    /// The vertex of each hit.
    pub vertices: Vec<Vertex>,
    /// Indices of hits, by edge, in order along each.
    along: Vec<u32>,
    /// For each edge, the end of its entries in `along`.
    ends: Vec<u32>,
}

/// The definitions of the points of both meshes, those on edges of the first mesh first.
pub(super) fn definitions(hits: [&[Hit]; 2], near: [&Near; 2], meshes: [&MaterialMesh; 2]) -> Vec<Construction> {
    let of = |mesh: usize| {
        let (edges, triangles) = (&near[mesh].edges, &near[1 - mesh].triangles);
        hits[mesh].iter().map(move |hit| Construction::Lpi {
            line: edges[hit.edge as usize],
            plane: meshes[1 - mesh].triangles()[triangles[hit.triangle as usize] as usize],
        })
    };
    of(0).chain(of(1)).collect()
}

impl Points {
    /// Sorts the points of these hits along the edges of a mesh.
    pub fn new(session: &dyn Predicates, near: &Near, hits: Vec<Hit>, vertices: &[Vertex]) -> Points {
        let mut ends = vec![0_u32; near.edges.len()];
        hits.iter().for_each(|hit| ends[hit.edge as usize] += 1);
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum;
        }
        // Filled from the end; afterwards each entry is the start of its edge's range.
        let mut starts = ends.clone();
        let mut along = vec![0; hits.len()];
        for (place, hit) in hits.iter().enumerate().rev() {
            starts[hit.edge as usize] -= 1;
            along[starts[hit.edge as usize] as usize] = number(place);
        }
        let mut points = Points { hits, vertices: vertices.to_vec(), along, ends };
        let many: Vec<u32> = (0..number(near.edges.len())).filter(|&edge| points.on(edge).len() > 1).collect();
        let sorted = predicament_grid::parallel::each(many.len(), &|at| {
            let mut places = points.on(many[at]).to_vec();
            sort_along(session, near.edges[many[at] as usize], &mut places, |at| points.vertices[at as usize]);
            places
        });
        for (edge, places) in many.into_iter().zip(sorted) {
            let end = points.ends[edge as usize] as usize;
            points.along[end - places.len()..end].copy_from_slice(&places);
        }
        points
    }

    /// The indices of the hits on an edge, from its first vertex to its second.
    pub fn on(&self, edge: u32) -> &[u32] {
        let start = edge.checked_sub(1).map_or(0, |before| self.ends[before as usize]);
        &self.along[start as usize..self.ends[edge as usize] as usize]
    }

    /// The indices of the hits in a triangle of the other mesh.
    pub fn within(&self, triangle: u32) -> std::ops::Range<usize> {
        let start = self.hits.partition_point(|hit| hit.triangle < triangle);
        let count = self.hits[start..].iter().take_while(|hit| hit.triangle == triangle).count();
        start..start + count
    }
}

/// Constructs all points: those of the first mesh, then those of the second.
pub(super) fn construct(
    session: &mut dyn Predicates,
    hits: [&[Hit]; 2],
    near: [&Near; 2],
    meshes: [&MaterialMesh; 2],
) -> Result<[Vec<Vertex>; 2], Refused> {
    let mut first = session.construct(&definitions(hits, near, meshes))?;
    let second = first.split_off(hits[0].len());
    Ok([first, second])
}
