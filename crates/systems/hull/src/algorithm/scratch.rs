//! Arrays by vertex, shared by the hulls of a scene's parts, so that a small part costs little.

use predicament_predicates::Vertex;

/// The mark of an empty entry.
pub(super) const NONE: u32 = u32::MAX;

/// Two numbers for each vertex, [`NONE`] between uses.
pub(super) struct Scratch {
    /// The face that a vertex is outside of.
    pub seat: Vec<u32>,
    /// The new face whose first edge begins at a vertex.
    pub spoke: Vec<u32>,
}

impl Scratch {
    /// Arrays for vertices below this index.
    pub fn new(vertices: usize) -> Scratch {
        Scratch { seat: vec![NONE; vertices], spoke: vec![NONE; vertices] }
    }

    /// Clears the seats of these vertices.
    pub fn clear(&mut self, vertices: &[Vertex]) {
        vertices.iter().for_each(|v| self.seat[v.index()] = NONE);
    }
}
