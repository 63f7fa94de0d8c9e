//! Splitting edges and faces, and the inverse operations.

use predicament_predicates::Vertex;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, OperationError};

impl HalfEdgeMesh {
    /// Splits an edge by a new vertex, and returns the vertex: `edge` then ends at it, and its next goes on to the
    /// former end of `edge`. The new half-edges copy the markers and the user data of the half-edges that they
    /// continue.
    ///
    /// The inverse is [`join_edges`](HalfEdgeMesh::join_edges).
    ///
    /// # Errors
    /// [`OperationError::NoSuchHalfEdge`], [`OperationError::Full`].
    pub fn split_edge(&mut self, edge: HalfEdge, scene_vertex: Vertex) -> Result<MeshVertex, OperationError> {
        self.known_half_edge(edge)?;
        self.room(2, 0, 1)?;
        let back = self.opposite(edge);
        let split = self.new_vertex(scene_vertex, edge);
        // The half-edges behind the new vertex, in either direction.
        let [edge_b, back_b] = [edge, back].map(|h| {
            let end = self.end(h);
            let behind = self.new_half_edge(end);
            self.marker[behind.index()] = self.marker(h);
            self.user_data[behind.index()] = self.user_data(h);
            self.anchor_vertex(end, h, behind);
            self.set_face(behind, self.face(h));
            behind
        });
        for (h, behind) in [(edge, edge_b), (back, back_b)] {
            self.set_next(behind, self.next(h));
            self.set_next(h, behind);
            self.end[h.index()] = split;
        }
        self.set_opposite(edge, back_b);
        self.set_opposite(back, edge_b);
        Ok(split)
    }

    /// Removes a vertex of two edges and joins them into one edge; returns a half-edge of it.
    ///
    /// # Errors
    /// [`OperationError::NotTwoEdges`]; [`OperationError::TooFewHalfEdges`] for a triangle;
    /// [`OperationError::EdgeExists`] if the neighbours are already joined.
    pub fn join_edges(&mut self, v: MeshVertex) -> Result<HalfEdge, OperationError> {
        self.known_vertex(v)?;
        let mut ring = self.ring(v);
        let (Some(edge), Some(back), None) = (ring.next(), ring.next(), ring.next()) else {
            return Err(OperationError::NotTwoEdges(v));
        };
        drop(ring);
        let [edge_b, back_b] = [self.opposite(back), self.opposite(edge)];
        // A face on both sides of the edges loses two half-edges.
        let lost = if self.face(edge) == self.face(back) { 2 } else { 1 };
        for h in [edge, back] {
            if self.face(h).is_some() && self.loop_of(h).nth(2 + lost).is_none() {
                return Err(OperationError::TooFewHalfEdges(h));
            }
        }
        if let Some(other) = self.find(self.start(edge), self.start(back)) {
            return Err(OperationError::EdgeExists(other));
        }
        for (h, behind) in [(edge, edge_b), (back, back_b)] {
            let (end, next) = (self.end(behind), self.next(behind));
            self.end[h.index()] = end;
            self.set_next(h, next);
            self.anchor_vertex(end, behind, h);
            self.anchor_face(self.face(h), behind, h);
        }
        self.set_opposite(edge, back);
        self.delete_half_edge(back_b);
        self.delete_half_edge(edge_b);
        self.delete_vertex(v);
        Ok(edge)
    }

    /// Splits a face by an edge from the end of `first` to the end of `second`, and returns the half-edge in that
    /// direction, which follows `first`. The loop with `first` keeps the face. The loop of the returned half-edge's
    /// opposite, from the next of `first` to `second`, gets a new face. The time is proportional to the length of the
    /// new loop.
    ///
    /// The inverse is [`join_faces`](HalfEdgeMesh::join_faces) of the returned half-edge.
    ///
    /// # Errors
    /// [`OperationError`] if the half-edges are not of one face, if one of the parts would have fewer than three
    /// half-edges, or if the ends are one vertex or already joined.
    pub fn split_face(&mut self, first: HalfEdge, second: HalfEdge) -> Result<HalfEdge, OperationError> {
        for h in [first, second] {
            self.known_half_edge(h)?;
            self.face(h).ok_or(OperationError::OnBoundary(h))?;
        }
        if self.face(first) != self.face(second) {
            return Err(OperationError::TwoFaces(first, second));
        }
        let [v1, v2] = [first, second].map(|h| self.end(h));
        if v1 == v2 {
            return Err(OperationError::OneVertex(v1));
        }
        for (h, other) in [(first, second), (second, first)] {
            if self.next(h) == other {
                return Err(OperationError::TooFewHalfEdges(h));
            }
        }
        if let Some(other) = self.find(v1, v2) {
            return Err(OperationError::EdgeExists(other));
        }
        self.room(2, 1, 0)?;
        let old = self.face(first);
        let [h, o] = self.link(first, second);
        self.set_face(h, old);
        if let Some(old) = old {
            self.face_half_edge[old.index()] = first;
        }
        let new = self.new_face(self.next(o));
        self.fill_loop(o, Some(new));
        Ok(h)
    }

    /// Splits a face by an edge between two of its vertices: finds the half-edges of the face that end at them by the
    /// rings of both.
    ///
    /// # Errors
    /// As [`split_face`](HalfEdgeMesh::split_face), and [`OperationError::NotInFace`] or
    /// [`OperationError::SeveralCorners`] if a vertex is not exactly one corner of the face.
    pub fn split_face_between(&mut self, f: Face, v1: MeshVertex, v2: MeshVertex) -> Result<HalfEdge, OperationError> {
        self.known_face(f)?;
        let corner = |v: MeshVertex| {
            self.known_vertex(v)?;
            let mut here = self.ring(v).filter(|&h| self.face(h) == Some(f));
            match (here.next(), here.next()) {
                (Some(h), None) => Ok(h),
                (None, _) => Err(OperationError::NotInFace(f, v)),
                (Some(_), Some(_)) => Err(OperationError::SeveralCorners(f, v)),
            }
        };
        let (first, second) = (corner(v1)?, corner(v2)?);
        self.split_face(first, second)
    }

    /// Cuts off an ear: the end of `before` and the next two vertices become a separate triangle. Returns the new
    /// half-edge of the remaining face, which follows `before` and bypasses the ear's tip.
    ///
    /// The inverse is [`join_faces`](HalfEdgeMesh::join_faces) of the returned half-edge.
    ///
    /// # Errors
    /// As [`split_face`](HalfEdgeMesh::split_face).
    pub fn cut_ear(&mut self, before: HalfEdge) -> Result<HalfEdge, OperationError> {
        self.known_half_edge(before)?;
        self.split_face(before, self.next(self.next(before)))
    }

    /// Removes an edge between two faces: the face on the left of `edge` takes over the other face's loop.
    ///
    /// # Errors
    /// [`OperationError::OnBoundary`], or [`OperationError::OneFace`] for an edge with one face on both sides.
    pub fn join_faces(&mut self, edge: HalfEdge) -> Result<Face, OperationError> {
        self.known_half_edge(edge)?;
        let back = self.opposite(edge);
        let kept = self.face(edge).ok_or(OperationError::OnBoundary(edge))?;
        let lost = self.face(back).ok_or(OperationError::OnBoundary(back))?;
        if kept == lost {
            return Err(OperationError::OneFace(edge));
        }
        let [Some(before_edge), Some(before_back)] = [edge, back].map(|h| self.previous(h)) else {
            return Err(OperationError::Broken(edge));
        };
        self.fill_loop(back, Some(kept));
        self.unlink([edge, back], [before_edge, before_back]);
        self.face_half_edge[kept.index()] = before_edge;
        self.delete_face(lost);
        Ok(kept)
    }

    /// Links a new edge behind two half-edges: the first half-edge follows `first`, its opposite follows `second`.
    pub(super) fn link(&mut self, first: HalfEdge, second: HalfEdge) -> [HalfEdge; 2] {
        let [h, o] = self.new_edge(self.end(first), self.end(second));
        let [after_first, after_second] = [first, second].map(|h| self.next(h));
        self.set_next(first, h);
        self.set_next(h, after_second);
        self.set_next(second, o);
        self.set_next(o, after_first);
        [h, o]
    }

    /// Unlinks an edge from its loops and removes it; `before` are the predecessors of its two half-edges.
    pub(super) fn unlink(&mut self, edge: [HalfEdge; 2], before: [HalfEdge; 2]) {
        let [h, o] = edge;
        let [after_h, after_o] = edge.map(|h| self.next(h));
        let [end_h, end_o] = edge.map(|h| self.end(h));
        let [before_h, before_o] = before;
        self.set_next(before_h, after_o);
        self.set_next(before_o, after_h);
        self.anchor_vertex(end_h, h, before_o);
        self.anchor_vertex(end_o, o, before_h);
        self.delete_half_edge(o);
        self.delete_half_edge(h);
    }

    /// Sets the face of a whole loop.
    pub(super) fn fill_loop(&mut self, first: HalfEdge, face: Option<Face>) {
        let mut h = first;
        for _ in 0..self.end.len() {
            self.set_face(h, face);
            h = self.next(h);
            if h == first {
                break;
            }
        }
    }
}
