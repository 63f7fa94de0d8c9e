//! The check that a complex is embedded: its simplices meet only in common faces.

use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Predicates, Vertex};

/// True if the edges of a complex of the plane, or the edges and triangles of a complex in space, meet only in common
/// vertices and edges.
///
/// A simple closed polygon is embedded, and so is every planar drawing and every surface that does not cross itself.
/// The time grows with the square of the number of simplices.
///
/// Only pairs without a common vertex are tested. That is enough. If two triangles with a common face meet outside of
/// it, they share a segment. It ends on a side of one triangle that has no vertex of the other, or in such a vertex.
/// (Tetrahedra are not tested, nor triangles of the plane.)
///
/// `exact` must answer exact signs; otherwise the result is meaningless.
pub fn is_embedded<S: Predicates + ?Sized>(exact: &S, complex: &Complex) -> bool {
    let (vertices, edges) = (complex.vertices(), complex.edges());
    let each_before = |i: usize| edges[..i].iter().map(move |&f| (edges[i], f));
    // The hierarchy's own order: the assumptions of each query were tested before it.
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

/// True if no vertex is inside a triangle, and no edge goes through it.
fn misses<S: Predicates + ?Sized>(exact: &S, complex: &Complex, triangle: &[Vertex; 3]) -> bool {
    let apart = |vertices: &[Vertex]| vertices.iter().all(|vertex| !triangle.contains(vertex));
    complex.vertices().iter().all(|&vertex| !apart(&[vertex]) || exact.triangle_vertex(*triangle, vertex).is_none())
        && complex.edges().iter().all(|&edge| !apart(&edge) || exact.triangle_edge(*triangle, edge).is_none())
}
