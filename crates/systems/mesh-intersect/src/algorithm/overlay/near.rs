//! The triangles and edges of each mesh that are near the other mesh.

use predicament_grid::{Bounds, shared};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};
use rayon::prelude::*;

/// The number of triangles in one thread's work item.
const PART: usize = 16384;

/// The triangles of a mesh that may meet the other one.
#[derive(Default)]
pub(super) struct Near {
    /// The indices of the triangles in the mesh, ascending.
    pub triangles: Vec<u32>,
    /// Their edges, each once, from the smaller vertex to the larger, ascending.
    pub edges: Vec<[Vertex; 2]>,
    /// The edges of each near triangle: first that from its first corner to its second, and so on.
    pub edges_of: Vec<[u32; 3]>,
    /// For each edge, the end of its uses in the list.
    ends: Vec<u32>,
    /// Uses of edges: three times the index of a near triangle, plus the corner at which the edge begins.
    uses: Vec<u32>,
}

impl Near {
    /// Finds the near parts of both meshes, and their boxes. The result contains everything that meets, except pairs of
    /// triangles neither of which is in `asked`.
    pub fn of(scene: &Scene, meshes: [&MaterialMesh; 2], asked: Option<[Vec<u32>; 2]>) -> ([Near; 2], [Bounds<3>; 2]) {
        let box_of = meshes.map(|mesh| {
            let triangles = mesh.triangles();
            move |place: usize| Bounds::of(triangles[place].map(|v| scene.point3(v)))
        });
        let counts = meshes.map(|mesh| mesh.triangles().len());
        let ([first, second], bounds) = match asked {
            None => shared(counts, [&box_of[0], &box_of[1]]),
            Some(asked) => {
                let [few, others] = [0, 1].map(|mesh: usize| {
                    let (asked, box_of) = (&asked[mesh], &box_of[mesh]);
                    move |at: usize| box_of(asked[at] as usize)
                });
                let ([first, seconds], [bounds, _]) = shared([counts[0], asked[1].len()], [&box_of[0], &others]);
                let ([firsts, second], [_, other_bounds]) = shared([asked[0].len(), counts[1]], [&few, &box_of[1]]);
                let joined = |all: Vec<u32>, places: Vec<u32>, asked: &[u32]| {
                    let mut all: Vec<u32> =
                        all.into_iter().chain(places.into_iter().map(|at| asked[at as usize])).collect();
                    all.sort_unstable();
                    all.dedup();
                    all
                };
                ([joined(first, firsts, &asked[0]), joined(second, seconds, &asked[1])], [bounds, other_bounds])
            }
        };
        let (first, second) = rayon::join(|| Near::new(meshes[0], first), || Near::new(meshes[1], second));
        ([first, second], bounds)
    }

    fn new(mesh: &MaterialMesh, triangles: Vec<u32>) -> Near {
        let corners: Vec<[Vertex; 3]> = triangles.iter().map(|&place| mesh.triangles()[place as usize]).collect();
        Near { triangles, ..Near::default() }.over(&corners)
    }

    /// The same triangles with these corners.
    pub fn over(self, corners: &[[Vertex; 3]]) -> Near {
        let triangles = self.triangles;
        let smallest = corners.as_flattened().iter().map(|v| v.index()).min().unwrap_or(0);
        let largest = corners.as_flattened().iter().map(|v| v.index()).max().unwrap_or(0);
        let side = |[a, b]: [Vertex; 2]| (a.min(b).index() - smallest, a.max(b));
        let sides = || corners.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).map(side);
        // Counting sort by the smaller vertex; few edges share it, and these are sorted by the larger.
        let mut starts = vec![0_u32; largest - smallest + 2];
        sides().for_each(|(from, _)| starts[from + 1] += 1);
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut sorted = vec![(Vertex::input(0), 0); 3 * triangles.len()];
        let mut filled = starts.clone();
        for ((from, to), here) in sides().zip(0..) {
            sorted[filled[from] as usize] = (to, here);
            filled[from] += 1;
        }
        let (mut edges, mut ends) = (Vec::with_capacity(sorted.len() / 2), Vec::with_capacity(sorted.len() / 2));
        let mut edges_of = vec![[0; 3]; triangles.len()];
        for (from, places) in (smallest..).zip(starts.windows(2)) {
            let of_vertex = &mut sorted[places[0] as usize..places[1] as usize];
            of_vertex.sort_unstable();
            for of_edge in of_vertex.chunk_by(|a, b| a.0 == b.0) {
                for &(_, side) in of_edge {
                    edges_of[side as usize / 3][side as usize % 3] = number(edges.len());
                }
                edges.push([Vertex::input(from), of_edge[0].0]);
                ends.push(ends.last().unwrap_or(&0) + number(of_edge.len()));
            }
        }
        Near { triangles, edges, edges_of, ends, uses: sorted.into_iter().map(|(_, side)| side).collect() }
    }

    /// The triangles at an edge: index among the near triangles, and the corner at which the edge begins.
    pub fn uses(&self, edge: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let start = edge.checked_sub(1).map_or(0, |before| self.ends[before as usize]);
        let uses = &self.uses[start as usize..self.ends[edge as usize] as usize];
        uses.iter().map(|&side| (side / 3, side as usize % 3))
    }

    /// The edge between two vertices, if it is near.
    pub fn edge(&self, a: Vertex, b: Vertex) -> Option<u32> {
        self.edges.binary_search(&[a.min(b), a.max(b)]).ok().map(number)
    }
}

/// The first and the last vertex of a mesh.
pub(super) fn span(mesh: &MaterialMesh) -> [usize; 2] {
    let indices = |triangles: &[[Vertex; 3]]| {
        let all = || triangles.as_flattened().iter().map(|v| v.index());
        [all().min().unwrap_or(0), all().max().unwrap_or(0)]
    };
    let wider = |a: [usize; 2], b: [usize; 2]| [a[0].min(b[0]), a[1].max(b[1])];
    mesh.triangles().par_chunks(PART).map(indices).reduce_with(wider).expect("a mesh has triangles")
}

/// An index as it is stored.
pub(crate) fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 sides of triangles")
}
