//! Arrays by vertex that the hulls of parts of a scene share, so that a small part costs little.

use predicament_predicates::Vertex;

/// What an array holds where it holds nothing.
pub(super) const NONE: u32 = u32::MAX;

/// Two numbers for each vertex, [`NONE`] between uses.
pub(super) struct Scratch {
    /// The face that a vertex is outside of.
    pub seat: Vec<u32>,
    /// The new face whose first edge begins at a vertex.
    pub spoke: Vec<u32>,
}

impl Scratch {
    /// For vertices below this index.
    pub fn new(vertices: usize) -> Scratch {
        Scratch { seat: vec![NONE; vertices], spoke: vec![NONE; vertices] }
    }

    /// Forgets the seats of these vertices.
    pub fn clear(&mut self, vertices: &[Vertex]) {
        vertices.iter().for_each(|v| self.seat[v.index()] = NONE);
    }
}
