//! The lines of edges, defined by input vertices, and their intersections with a plane.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::HalfEdge;
use predicament_predicates::{Construction, Vertex};

/// The input vertices that define an edge's line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Line {
    /// Two input vertices.
    Vertices([Vertex; 2]),
    /// The line where two planes meet, each through three input vertices.
    Planes([[Vertex; 3]; 2]),
}

/// The user data of a half-edge whose ends are two input vertices that define its line. Other values are indices in the
/// list of lines, from 1.
pub(super) const OWN_ENDS: u32 = 0;

/// The lines that the ends of their edges do not define.
#[derive(Default)]
pub(super) struct Lines(Vec<Line>);

impl Lines {
    /// Adds a line; returns the user data of the edges on it.
    pub(super) fn add(&mut self, line: Line) -> u32 {
        self.0.push(line);
        u32::try_from(self.0.len()).expect("fewer lines than half-edges")
    }

    /// The line that a half-edge is on.
    pub(super) fn of(&self, mesh: &HalfEdgeMesh, h: HalfEdge) -> Line {
        match mesh.user_data(h) {
            OWN_ENDS => Line::Vertices([mesh.start(h), mesh.end(h)].map(|v| mesh.scene_vertex(v))),
            place => self.0[place as usize - 1],
        }
    }

    /// The point where the line of an edge meets a plane.
    pub(super) fn definition(&self, mesh: &HalfEdgeMesh, h: HalfEdge, plane: [Vertex; 3]) -> Construction {
        match self.of(mesh, h) {
            Line::Vertices(line) => Construction::Lpi { line, plane },
            Line::Planes([first, second]) => Construction::Tpi([first, second, plane]),
        }
    }
}
