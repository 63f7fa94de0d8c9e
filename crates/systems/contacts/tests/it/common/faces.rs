//! The faces of a simplex, by trying all subsets of its vertices.

use predicament_predicates::Vertex;

/// A simplex by its vertices.
pub type Cell = Vec<Vertex>;

/// All non-empty subsets, the simplex itself included.
pub fn faces(cell: &[Vertex]) -> Vec<Cell> {
    let subset = |bits: u32| (0..cell.len()).filter(|i| bits >> i & 1 == 1).map(|i| cell[i]).collect();
    (1_u32..1 << cell.len()).map(subset).collect()
}
