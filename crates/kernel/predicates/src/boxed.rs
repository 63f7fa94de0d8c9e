//! Sessions behind a pointer.
//!
//! Code that is generic over [`Predicates`] is compiled once for all boxed sessions. The cost is one dynamic call per
//! query.

use crate::{
    Axis, Band, Construction, Declined, Derived, Plane, PredicateKind, Predicates, Question, Refused, Scene, Sessions,
    Sign, Vertex,
};
use alloc::{boxed::Box, vec::Vec};

// A method that is missing here would use the trait's default and bypass the session's own method.
#[deny(clippy::missing_trait_methods)]
impl<P: Predicates + ?Sized> Predicates for Box<P> {
    fn scene(&self) -> &Scene {
        (**self).scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        (**self).construct(definitions)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        (**self).supports(kind)
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        (**self).compare(axis, a, b)
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        (**self).orient2d(plane, a, b, c)
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        (**self).orient3d(a, b, c, d)
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        (**self).incircle(a, b, c, d)
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        (**self).insphere(a, b, c, d, e)
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        (**self).sign(predicate, vertices)
    }

    fn sign_batch(&self, predicate: Derived, vertices: &[Vertex], out: &mut [Sign]) {
        (**self).sign_batch(predicate, vertices, out);
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        (**self).estimate(question, args)
    }

    fn rounded_point(&self, v: Vertex) -> Option<&[f64]> {
        (**self).rounded_point(v)
    }

    fn own_nanoseconds(&self) -> Option<u64> {
        (**self).own_nanoseconds()
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        (**self).unperturbed()
    }

    fn moves_second_mesh(&self) -> bool {
        (**self).moves_second_mesh()
    }

    fn allows(&self, shortcut: &str) -> bool {
        (**self).allows(shortcut)
    }

    fn band(&self, question: Question) -> Option<Band> {
        (**self).band(question)
    }

    fn reach(&self) -> f64 {
        (**self).reach()
    }

    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        (**self).contact_band(ranks)
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        (**self).supports_contacts()
    }

    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        (**self).vertex_vertex(a, p)
    }

    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        (**self).edge_vertex(edge, p)
    }

    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        (**self).edge_edge(e, f)
    }

    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        (**self).triangle_vertex(triangle, p)
    }

    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        (**self).triangle_edge(triangle, edge)
    }

    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        (**self).tetrahedron_vertex(tetrahedron, p)
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        (**self).compare_batch(axis, queries, out);
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        (**self).orient2d_batch(plane, queries, out);
    }

    fn orient2d_line(&self, plane: Plane, line: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        (**self).orient2d_line(plane, line, points, out);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        (**self).orient3d_batch(queries, out);
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        (**self).orient3d_plane(plane, points, out);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        (**self).incircle_batch(queries, out);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        (**self).insphere_batch(queries, out);
    }
}
