//! Whether a complex of the plane is embedded: its edges meet in common vertices only.

use predicament_mesh::Complex;
use predicament_predicates::Predicates;

/// Whether the edges of a complex of the plane meet in common vertices only:
/// a simple closed polygon does, and so does every planar drawing. Time goes
/// with the square of the edges.
///
/// `exact` must answer exact signs; with anything else the result means nothing.
pub fn is_embedded<S: Predicates + ?Sized>(exact: &S, complex: &Complex) -> bool {
    let (vertices, edges) = (complex.vertices(), complex.edges());
    let each_before = |i: usize| edges[..i].iter().map(move |&f| (edges[i], f));
    // The hierarchy's own order: what a question assumes was answered before it.
    let apart = (0..vertices.len()).all(|i| vertices[..i].iter().all(|&p| !exact.vertex_vertex(p, vertices[i])));
    apart
        && edges.iter().all(|edge| {
            vertices.iter().all(|vertex| edge.contains(vertex) || exact.edge_vertex(*edge, *vertex).is_none())
        })
        && (0..edges.len())
            .flat_map(each_before)
            .all(|(e, f)| e.iter().any(|vertex| f.contains(vertex)) || exact.edge_edge(f, e).is_none())
}
