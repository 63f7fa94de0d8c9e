//! Covers of loops by the rule of least area, without crossings.
//!
//! Among all triangulations of a loop of n points, dynamic programming finds one of least area in O(n³) steps:
//! Barequet and Sharir, Filling gaps in the boundary of a polyhedron, 1995; Liepa, Filling holes in meshes, 2003. The
//! rule does not know whether triangles cross. So the signs of a session test the cover (`search.rs`). A triangle that
//! crosses the mesh is excluded, and of two triangles that cross each other one is excluded at a time. The next cover
//! is again one of least area. The first cover without a crossing is the answer.
//!
//! Areas are doubles (`area.rs`). They select among covers and never decide whether triangles cross.
//!
//! Loops are covered in their order. A cover belongs to the mesh when the next loop is covered.

mod area;
mod search;

use std::collections::BTreeSet;

use predicament_grid::{Bounds, BoxIndex};
use predicament_mesh_intersect::algorithm::rounding::flaws::flaw;
use predicament_predicates::{Predicates, Scene, Vertex};

use crate::answer::{Cover, Reason, edges, undirected};
use search::Search;

/// The work limit of one loop of n points, in covers that are tried. Each takes n³/6 steps of the dynamic programming:
/// 2^26 steps, but not fewer than 100 covers, and not more than 20,000.
#[must_use]
pub fn most_covers(n: usize) -> usize {
    ((1 << 26) / (n * n * n / 6 + 1)).clamp(100, 20_000)
}

/// The triangles that a cover must not cross: those of the mesh, and of covers of earlier loops.
pub struct Surface {
    triangles: Vec<[Vertex; 3]>,
    /// The edges, ends ascending.
    edges: BTreeSet<[Vertex; 2]>,
    /// The boxes of the mesh's triangles.
    index: BoxIndex<3>,
    /// The triangles of the mesh; those behind them are of covers, with their boxes in `added`.
    given: usize,
    added: Vec<Bounds<3>>,
}

fn bounds(scene: &Scene, corners: [Vertex; 3]) -> Bounds<3> {
    Bounds::of(corners.map(|v| scene.point3(v)))
}

impl Surface {
    /// The surface of a mesh.
    ///
    /// # Panics
    /// If the scene lacks a vertex, or is planar.
    #[must_use]
    pub fn new(scene: &Scene, triangles: &[[Vertex; 3]]) -> Surface {
        Surface {
            triangles: triangles.to_vec(),
            edges: triangles.iter().flat_map(|corners| edges(corners)).map(undirected).collect(),
            index: BoxIndex::new(triangles.iter().map(|&corners| bounds(scene, corners)).collect()),
            given: triangles.len(),
            added: Vec::new(),
        }
    }

    /// Covers a loop, and adds the cover to the surface.
    pub fn cover(&mut self, session: &dyn Predicates, around: &[Vertex]) -> Cover {
        if around.iter().collect::<BTreeSet<_>>().len() < around.len() {
            return Cover::Uncovered(Reason::Repeats);
        }
        match Search::new(session, self, around).run() {
            Ok(triangles) => {
                for &corners in &triangles {
                    self.edges.extend(edges(&corners).map(undirected));
                    self.added.push(bounds(session.scene(), corners));
                    self.triangles.push(corners);
                }
                Cover::Triangles(triangles)
            }
            Err(reason) => Cover::Uncovered(reason),
        }
    }

    fn has_edge(&self, ends: [Vertex; 2]) -> bool {
        self.edges.contains(&undirected(ends))
    }

    /// True if a triangle has more in common with the surface than vertices and edges of both.
    fn meets(&self, session: &dyn Predicates, corners: [Vertex; 3]) -> bool {
        let (here, reach) = (bounds(session.scene(), corners), session.reach());
        let mut near = Vec::new();
        self.index.near(&here, reach, &mut near);
        let added = self.added.iter().zip(self.given..).filter(|(other, _)| other.is_near(&here, reach));
        let near = near.into_iter().map(|at| at as usize).chain(added.map(|(_, at)| at));
        near.into_iter().any(|at| cross(session, corners, self.triangles[at]))
    }
}

/// True if two triangles have more in common than their common vertices and edge.
fn cross(session: &dyn Predicates, first: [Vertex; 3], second: [Vertex; 3]) -> bool {
    let place = |v: Vertex| u32::try_from(v.index()).expect("a vertex has 32 bits");
    flaw(session, first.map(place), second.map(place)).is_some()
}
