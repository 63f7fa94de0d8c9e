//! Cutting a mesh open along edges: separates the parts on either side, in place.
//!
//! Each edge becomes two, one for the face on either side, with boundary half-edges between them. At a vertex the faces
//! between two gaps are a fan, and each fan gets its own vertex. If the edges enclose a part of the mesh, that part is
//! disconnected. The time is proportional to the rings at the edges, and independent of the size of the parts.

use super::{HalfEdge, HalfEdgeMesh, MeshVertex, OperationError};

impl HalfEdgeMesh {
    /// Cuts the mesh open along edges that have a face on either side. For each half-edge h of `edges`, in their order,
    /// it returns two new boundary half-edges: the new opposite of h, and the new opposite of the former opposite of h.
    ///
    /// Each new boundary half-edge has the marker and user data of the half-edge that it replaces. A vertex whose faces
    /// are separated is divided: the first fan of its ring keeps it, and each other fan gets a new vertex, with its
    /// scene vertex, marker and user data.
    ///
    /// # Errors
    /// [`OperationError::NoSuchHalfEdge`], [`OperationError::OnBoundary`], [`OperationError::Full`];
    /// [`OperationError::EdgeListedTwice`]; [`OperationError::EdgeExists`] if two edges would join the same vertices,
    /// as at a slit within a mesh; [`OperationError::Broken`] for an edge at a vertex with a wire.
    pub fn cut_along(&mut self, edges: &[HalfEdge]) -> Result<Vec<[HalfEdge; 2]>, OperationError> {
        let mut listed = Vec::with_capacity(edges.len());
        let mut touched = Vec::with_capacity(2 * edges.len());
        for &h in edges {
            self.known_half_edge(h)?;
            let o = self.opposite(h);
            for side in [h, o] {
                self.face(side).ok_or(OperationError::OnBoundary(side))?;
                touched.push(self.end(side));
            }
            listed.push((h.min(o), h));
        }
        listed.sort_unstable();
        if let Some(pair) = listed.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(OperationError::EdgeListedTwice(pair[1].1));
        }
        self.room(2 * edges.len(), 0, 2 * edges.len())?;
        touched.sort_unstable();
        // If an edge is the only gap at both of its ends, two edges would join them.
        let is_divided = |v: MeshVertex| {
            let listed = touched.partition_point(|&other| other <= v) - touched.partition_point(|&other| other < v);
            listed + self.gaps(v) > 1
        };
        if let Some(&h) = edges.iter().find(|&&h| !is_divided(self.start(h)) && !is_divided(self.end(h))) {
            return Err(OperationError::EdgeExists(h));
        }
        touched.dedup();
        // The corners at each vertex, by the half-edges of faces that end there.
        let mut corners: Vec<HalfEdge> = Vec::new();
        let mut ends = Vec::with_capacity(touched.len());
        for &v in &touched {
            for h in self.ring(v) {
                match (self.face(h), self.face(self.opposite(h))) {
                    (Some(_), _) => corners.push(h),
                    (None, Some(_)) => {}
                    (None, None) => return Err(OperationError::Broken(h)),
                }
            }
            ends.push(corners.len());
        }
        let mut doubled = Vec::with_capacity(edges.len());
        for &h in edges {
            let pair = [h, self.opposite(h)];
            let beside = pair.map(|side| {
                let replaced = self.opposite(side);
                let boundary = self.new_half_edge(self.end(replaced));
                self.set_face(boundary, None);
                self.marker[boundary.index()] = self.marker(replaced);
                self.user_data[boundary.index()] = self.user_data(replaced);
                boundary
            });
            pair.into_iter().zip(beside).for_each(|(side, boundary)| self.set_opposite(side, boundary));
            doubled.push(beside);
        }
        let mut start = 0;
        for (v, end) in touched.into_iter().zip(ends) {
            self.divide(v, &corners[start..end])?;
            start = end;
        }
        Ok(doubled)
    }

    /// Joins the ends of two half-edges that an edge already joins, and divides the mesh at that edge: for a face, or
    /// for a face and a boundary loop, that touch an edge between two other faces. Each of these faces gets its own
    /// edge, shared with what touched it, and either end is divided into two vertices.
    ///
    /// Returns the new half-edge from the end of `first` to that of `second`, the new half-edge in the other direction,
    /// and the new vertices. Loops and faces are as after [`split_face`](HalfEdgeMesh::split_face) for two half-edges
    /// of one face, and as after [`insert_auxiliary_edge`](HalfEdgeMesh::insert_auxiliary_edge) if `second` is on a
    /// boundary.
    ///
    /// # Errors
    /// [`OperationError`] if these operations would be refused for another reason than that edge; if `edge` does not
    /// join the two ends, or if one of its faces is that of `first`.
    pub fn divide_at_edge(
        &mut self,
        first: HalfEdge,
        second: HalfEdge,
        edge: HalfEdge,
    ) -> Result<([HalfEdge; 2], Vec<MeshVertex>), OperationError> {
        for h in [first, second, edge] {
            self.known_half_edge(h)?;
        }
        let face = self.face(first).ok_or(OperationError::OnBoundary(first))?;
        let is_one = match self.face(second) {
            Some(other) if other == face => true,
            None => false,
            Some(_) => return Err(OperationError::TwoFaces(first, second)),
        };
        if is_one && (self.next(first) == second || self.next(second) == first) {
            return Err(OperationError::TooFewHalfEdges(first));
        }
        let [from, to] = [first, second].map(|h| self.end(h));
        // `along` has the direction of the new half-edge.
        let along = if self.end(edge) == to { edge } else { self.opposite(edge) };
        let back = self.opposite(along);
        if from == to || self.end(along) != to || self.start(along) != from {
            return Err(OperationError::EdgeExists(edge));
        }
        for side in [along, back] {
            let beyond = self.face(side).ok_or(OperationError::OnBoundary(side))?;
            if beyond == face {
                return Err(OperationError::EdgeExists(edge));
            }
        }
        self.room(2, 1, 2)?;
        if !is_one {
            self.fill_loop(second, Some(face));
        }
        let [h, o] = self.link(first, second);
        self.set_face(h, Some(face));
        self.set_face(o, Some(face));
        if is_one {
            self.face_half_edge[face.index()] = first;
            let new = self.new_face(o);
            self.fill_loop(o, Some(new));
        }
        self.set_opposite(along, o);
        self.set_opposite(back, h);
        let mut divided = Vec::with_capacity(2);
        // Each of the two vertices now has two rings, one through each of the half-edges that end there.
        for (v, kept, other) in [(to, along, h), (from, back, o)] {
            self.vertex_half_edge[v.index()] = kept;
            if self.ring(v).any(|h| h == other) {
                continue;
            }
            let place = self.copied_vertex(v);
            self.vertex_half_edge[place.index()] = other;
            let ring: Vec<HalfEdge> = self.ring(place).collect();
            ring.into_iter().for_each(|h| self.end[h.index()] = place);
            divided.push(place);
        }
        Ok(([h, o], divided))
    }

    /// Gives each fan of these corners a vertex, and links the boundary half-edges at its sides.
    fn divide(&mut self, v: MeshVertex, corners: &[HalfEdge]) -> Result<(), OperationError> {
        let mut keeps = true;
        for &first in corners {
            if !self.is_boundary(self.opposite(first)) {
                continue;
            }
            let place = if keeps { v } else { self.copied_vertex(v) };
            keeps = false;
            self.vertex_half_edge[place.index()] = first;
            let mut at = first;
            for _ in 0..=corners.len() {
                self.end[at.index()] = place;
                if self.is_boundary(at) {
                    break;
                }
                at = self.opposite(self.next(at));
            }
            if !self.is_boundary(at) {
                return Err(OperationError::Broken(first));
            }
            let out = self.opposite(first);
            self.set_next(at, out);
        }
        Ok(())
    }

    /// A new vertex for the same vertex of the scene, with the same marker and user data.
    fn copied_vertex(&mut self, v: MeshVertex) -> MeshVertex {
        let copy = self.new_vertex(self.scene_vertex(v), HalfEdge::NONE);
        self.set_vertex_marker(copy, self.vertex_marker(v));
        self.set_vertex_user_data(copy, self.vertex_user_data(v));
        copy
    }
}
