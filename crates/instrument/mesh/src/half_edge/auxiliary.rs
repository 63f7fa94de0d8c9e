//! Auxiliary edges: they join two loops into one, such as the loops of a face and of its hole.

use super::{HalfEdge, HalfEdgeMesh, OperationError};

impl HalfEdgeMesh {
    /// Inserts an edge from the end of `first` to the end of `second`, which are in different loops; returns the
    /// half-edge in that direction. At least one of both loops is a boundary loop. The joined loop belongs to the face
    /// of the other loop, if it has a face. This makes holes: the boundary loop of the hole becomes a part of the face.
    ///
    /// The time is proportional to the length of a boundary loop. The inverse is
    /// [`remove_auxiliary_edge`](HalfEdgeMesh::remove_auxiliary_edge) of the half-edge that comes from the face, or of
    /// either half-edge if there is no face.
    ///
    /// # Errors
    /// [`OperationError`] if both half-edges are of faces or of one loop, or if the ends are one vertex or already
    /// joined.
    pub fn insert_auxiliary_edge(&mut self, first: HalfEdge, second: HalfEdge) -> Result<HalfEdge, OperationError> {
        for h in [first, second] {
            self.known_half_edge(h)?;
        }
        let face = match (self.face(first), self.face(second)) {
            (Some(a), Some(b)) if a == b => return Err(OperationError::OneLoop(first, second)),
            (Some(_), Some(_)) => return Err(OperationError::TwoFaces(first, second)),
            (None, None) if self.loop_of(first).any(|h| h == second) => {
                return Err(OperationError::OneLoop(first, second));
            }
            (one, other) => one.or(other),
        };
        let [v1, v2] = [first, second].map(|h| self.end(h));
        if v1 == v2 {
            return Err(OperationError::OneVertex(v1));
        }
        if let Some(other) = self.find(v1, v2) {
            return Err(OperationError::EdgeExists(other));
        }
        self.room(2, 0, 0)?;
        // This must precede the linking into one loop: only the loop without a face is walked.
        if face.is_some() {
            let open = if self.is_boundary(first) { first } else { second };
            self.fill_loop(open, face);
        }
        let [h, o] = self.link(first, second);
        self.set_face(h, face);
        self.set_face(o, face);
        Ok(h)
    }

    /// Removes an edge that has both sides in one loop, which becomes two loops. The loop at the start of `edge` keeps
    /// the face, if there is one. The loop at the end of `edge` becomes a boundary loop; one of its half-edges is
    /// returned.
    ///
    /// # Errors
    /// [`OperationError::NotAuxiliary`]; [`OperationError::LastEdge`] if an end has no other edge;
    /// [`OperationError::TooFewHalfEdges`] if the face would keep fewer than three half-edges.
    pub fn remove_auxiliary_edge(&mut self, edge: HalfEdge) -> Result<HalfEdge, OperationError> {
        self.known_half_edge(edge)?;
        let back = self.opposite(edge);
        let face = self.face(edge);
        if face != self.face(back) || !self.loop_of(edge).any(|h| h == back) {
            return Err(OperationError::NotAuxiliary(edge));
        }
        for (h, other) in [(edge, back), (back, edge)] {
            if self.next(h) == other {
                return Err(OperationError::LastEdge(self.end(h)));
            }
        }
        let [Some(before_edge), Some(before_back)] = [edge, back].map(|h| self.previous(h)) else {
            return Err(OperationError::Broken(edge));
        };
        let kept = self.loop_of(self.next(back)).take_while(|&h| h != edge).take(3).count();
        if let Some(f) = face {
            if kept < 3 {
                return Err(OperationError::TooFewHalfEdges(before_edge));
            }
            self.face_half_edge[f.index()] = before_edge;
        }
        self.unlink([edge, back], [before_edge, before_back]);
        self.fill_loop(before_back, None);
        Ok(before_back)
    }
}
