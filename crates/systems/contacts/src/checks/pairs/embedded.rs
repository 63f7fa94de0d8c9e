//! Whether a complex is embedded: its simplices meet in common faces only.

use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Predicates, Vertex};

/// Whether the edges of a complex of the plane, or the edges and triangles of
/// a complex in space, meet in common vertices and edges only: a simple closed
/// polygon does, so does every planar drawing and every surface that does not
/// cross itself. Time goes with the square of the simplices.
///
/// Looked at are pairs without a common vertex. That is enough: where two
/// triangles with a common face meet outside of it, the common segment ends on
/// a side of one of them that has no vertex of the other, or in such a vertex.
/// (Tetrahedra are not looked at, nor triangles of the plane.)
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
        && (exact.scene().dimension() == Dimension::Two
            || complex.triangles().iter().all(|triangle| misses(exact, complex, triangle)))
}

/// Whether no vertex is on a triangle's inside, and no edge goes through it.
fn misses<S: Predicates + ?Sized>(exact: &S, complex: &Complex, triangle: &[Vertex; 3]) -> bool {
    let apart = |vertices: &[Vertex]| vertices.iter().all(|vertex| !triangle.contains(vertex));
    complex.vertices().iter().all(|&vertex| !apart(&[vertex]) || exact.triangle_vertex(*triangle, vertex).is_none())
        && complex.edges().iter().all(|&edge| !apart(&edge) || exact.triangle_edge(*triangle, edge).is_none())
}
