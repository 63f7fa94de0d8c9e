//! The lines that edges are on, by input vertices, and where they meet a plane.

use predicament_mesh::half_edge::HalfEdge;
use predicament_predicates::{Construction, Vertex};

use super::cutter::Cutter;

/// What spans the line of an edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Line {
    /// Two input vertices.
    Vertices([Vertex; 2]),
    /// Two planes of three input vertices each.
    Planes([[Vertex; 3]; 2]),
}

/// The user data of a half-edge whose ends are two input vertices that span its line; other values are places in the list of lines,
/// from 1.
pub(super) const OWN_ENDS: u32 = 0;

impl Cutter<'_> {
    /// The user data of edges on a line.
    pub(super) fn add_line(&mut self, line: Line) -> u32 {
        self.lines.push(line);
        u32::try_from(self.lines.len()).expect("fewer lines than half-edges")
    }

    fn line(&self, h: HalfEdge) -> Line {
        match self.mesh.user_data(h) {
            OWN_ENDS => Line::Vertices([self.mesh.start(h), self.mesh.end(h)].map(|v| self.mesh.scene_vertex(v))),
            place => self.lines[place as usize - 1],
        }
    }

    /// The point where the line of an edge meets a plane.
    pub(super) fn definition(&self, h: HalfEdge, plane: [Vertex; 3]) -> Construction {
        match self.line(h) {
            Line::Vertices(line) => Construction::Lpi { line, plane },
            Line::Planes([first, second]) => Construction::Tpi([first, second, plane]),
        }
    }

    /// Splits an edge, whose halves remember the line.
    pub(super) fn split_edge(&mut self, h: HalfEdge, vertex: Vertex) -> Result<(), super::Halt> {
        let line = match (self.mesh.user_data(h), self.line(h)) {
            (OWN_ENDS, line) => self.add_line(line),
            (place, _) => place,
        };
        let part = self.mesh.vertex_user_data(self.mesh.start(h));
        let v = self.mesh.split_edge(h, vertex)?;
        for half in [h, self.mesh.next(h)] {
            let opposite = self.mesh.opposite(half);
            self.mesh.set_user_data(half, line);
            self.mesh.set_user_data(opposite, line);
        }
        self.mesh.set_vertex_user_data(v, part);
        self.see_new_vertices(&[v]);
        Ok(())
    }
}
