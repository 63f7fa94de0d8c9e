//! The flip of an edge between two triangles.

use super::{HalfEdge, HalfEdgeMesh, OperationError};

impl HalfEdgeMesh {
    /// Flips an edge between two triangles: it then joins the two vertices opposite to it, and `edge` ends at the third
    /// vertex of the triangle that was on its left. The inverse is to flip the same half-edge again.
    ///
    /// # Errors
    /// [`OperationError::OnBoundary`], [`OperationError::NoTriangle`], and [`OperationError::OneVertex`] or
    /// [`OperationError::EdgeExists`] if the vertices opposite to the edge are one vertex, or already joined.
    pub fn flip_edge(&mut self, edge: HalfEdge) -> Result<(), OperationError> {
        self.known_half_edge(edge)?;
        let back = self.opposite(edge);
        let mut faces = [None; 2];
        for (h, face) in [edge, back].into_iter().zip(&mut faces) {
            let f = self.face(h).ok_or(OperationError::OnBoundary(h))?;
            if self.next(self.next(self.next(h))) != h {
                return Err(OperationError::NoTriangle(f));
            }
            *face = Some(f);
        }
        // The loops: edge a to b, then b to c, c to a; back b to a, then a to d, d to b.
        let [b_c, a_d] = [edge, back].map(|h| self.next(h));
        let [c_a, d_b] = [b_c, a_d].map(|h| self.next(h));
        let [a, b, c, d] = [back, edge, b_c, a_d].map(|h| self.end(h));
        if c == d {
            return Err(OperationError::OneVertex(c));
        }
        if let Some(other) = self.find(c, d) {
            return Err(OperationError::EdgeExists(other));
        }
        self.anchor_vertex(a, back, c_a);
        self.anchor_vertex(b, edge, d_b);
        self.end[edge.index()] = c;
        self.end[back.index()] = d;
        for (triangle, face) in [[edge, c_a, a_d], [back, d_b, b_c]].into_iter().zip(faces) {
            for (at, &h) in triangle.iter().enumerate() {
                self.set_next(h, triangle[(at + 1) % 3]);
                self.set_face(h, face);
            }
            if let Some(f) = face {
                self.face_half_edge[f.index()] = triangle[0];
            }
        }
        Ok(())
    }
}
