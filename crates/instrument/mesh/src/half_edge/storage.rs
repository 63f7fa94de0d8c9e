//! Storage of elements: creation, removal, and iteration in the order of handles.

use predicament_predicates::Vertex;

use super::{Face, HalfEdge, HalfEdgeMesh, MeshVertex, OperationError, REMOVED};

/// The maximum number of elements of a kind: the two largest handle values mean "none" and "removed".
pub(super) const MOST: usize = u32::MAX as usize - 1;

impl HalfEdgeMesh {
    /// True if the mesh has this half-edge.
    #[must_use]
    pub fn has_half_edge(&self, h: HalfEdge) -> bool {
        self.end.get(h.index()).is_some_and(|end| end.some().is_some())
    }

    /// True if the mesh has this face.
    #[must_use]
    pub fn has_face(&self, f: Face) -> bool {
        self.face_half_edge.get(f.index()).is_some_and(|h| h.some().is_some())
    }

    /// True if the mesh has this vertex.
    #[must_use]
    pub fn has_vertex(&self, v: MeshVertex) -> bool {
        self.vertex_half_edge.get(v.index()).is_some_and(|&h| h != REMOVED)
    }

    /// All half-edges, in the order of their handles.
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdge> + '_ {
        (0..self.end.len()).map(HalfEdge::at).filter(|&h| self.has_half_edge(h))
    }

    /// All faces, in the order of their handles.
    pub fn faces(&self) -> impl Iterator<Item = Face> + '_ {
        (0..self.face_half_edge.len()).map(Face::at).filter(|&f| self.has_face(f))
    }

    /// All vertices, in the order of their handles.
    pub fn vertices(&self) -> impl Iterator<Item = MeshVertex> + '_ {
        (0..self.vertex_half_edge.len()).map(MeshVertex::at).filter(|&v| self.has_vertex(v))
    }

    /// The number of edges: half the number of half-edges.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        (self.end.len() - self.free_half_edges.len()) / 2
    }

    /// The number of faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.face_half_edge.len() - self.free_faces.len()
    }

    /// The number of vertices, including those without edges.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_half_edge.len() - self.free_vertices.len()
    }

    pub(super) fn known_half_edge(&self, h: HalfEdge) -> Result<(), OperationError> {
        if self.has_half_edge(h) { Ok(()) } else { Err(OperationError::NoSuchHalfEdge(h)) }
    }

    pub(super) fn known_face(&self, f: Face) -> Result<(), OperationError> {
        if self.has_face(f) { Ok(()) } else { Err(OperationError::NoSuchFace(f)) }
    }

    pub(super) fn known_vertex(&self, v: MeshVertex) -> Result<(), OperationError> {
        if self.has_vertex(v) { Ok(()) } else { Err(OperationError::NoSuchVertex(v)) }
    }

    /// Refuses to grow by `half_edges`, `faces` and `vertices` if there are too few handles.
    pub(super) fn room(&self, half_edges: usize, faces: usize, vertices: usize) -> Result<(), OperationError> {
        let fits = |length: usize, more: usize| length.checked_add(more).is_some_and(|all| all <= MOST);
        let room = fits(self.end.len(), half_edges)
            && fits(self.face_half_edge.len(), faces)
            && fits(self.vertex_half_edge.len(), vertices);
        if room { Ok(()) } else { Err(OperationError::Full) }
    }

    /// A new half-edge with only its end set.
    pub(super) fn new_half_edge(&mut self, end: MeshVertex) -> HalfEdge {
        if let Some(h) = self.free_half_edges.pop() {
            self.end[h.index()] = end;
            return h;
        }
        self.end.push(end);
        self.next.push(HalfEdge::NONE);
        self.opposite.push(HalfEdge::NONE);
        self.face.push(Face::NONE);
        self.marker.push(0);
        self.user_data.push(0);
        HalfEdge::at(self.end.len() - 1)
    }

    /// Two new half-edges that are opposite to each other, without next and face.
    pub(super) fn new_edge(&mut self, from: MeshVertex, to: MeshVertex) -> [HalfEdge; 2] {
        let [h, o] = [to, from].map(|end| self.new_half_edge(end));
        self.set_opposite(h, o);
        [h, o]
    }

    pub(super) fn new_face(&mut self, half_edge: HalfEdge) -> Face {
        if let Some(f) = self.free_faces.pop() {
            self.face_half_edge[f.index()] = half_edge;
            return f;
        }
        self.face_half_edge.push(half_edge);
        self.face_marker.push(0);
        self.face_user_data.push(0);
        Face::at(self.face_half_edge.len() - 1)
    }

    pub(super) fn new_vertex(&mut self, scene_vertex: Vertex, half_edge: HalfEdge) -> MeshVertex {
        if let Some(v) = self.free_vertices.pop() {
            self.vertex_half_edge[v.index()] = half_edge;
            self.scene_vertex[v.index()] = scene_vertex;
            return v;
        }
        self.vertex_half_edge.push(half_edge);
        self.vertex_marker.push(0);
        self.vertex_user_data.push(0);
        self.scene_vertex.push(scene_vertex);
        MeshVertex::at(self.vertex_half_edge.len() - 1)
    }

    /// Removes a half-edge; links to it must no longer exist.
    pub(super) fn delete_half_edge(&mut self, h: HalfEdge) {
        self.end[h.index()] = MeshVertex::NONE;
        self.face[h.index()] = Face::NONE;
        self.marker[h.index()] = 0;
        self.user_data[h.index()] = 0;
        self.free_half_edges.push(h);
    }

    pub(super) fn delete_face(&mut self, f: Face) {
        self.face_half_edge[f.index()] = HalfEdge::NONE;
        self.face_marker[f.index()] = 0;
        self.face_user_data[f.index()] = 0;
        self.free_faces.push(f);
    }

    pub(super) fn delete_vertex(&mut self, v: MeshVertex) {
        self.vertex_half_edge[v.index()] = REMOVED;
        self.vertex_marker[v.index()] = 0;
        self.vertex_user_data[v.index()] = 0;
        self.free_vertices.push(v);
    }

    pub(super) fn set_opposite(&mut self, h: HalfEdge, o: HalfEdge) {
        self.opposite[h.index()] = o;
        self.opposite[o.index()] = h;
    }

    pub(super) fn set_next(&mut self, h: HalfEdge, next: HalfEdge) {
        self.next[h.index()] = next;
    }

    /// Sets or clears the face on the left.
    pub(super) fn set_face(&mut self, h: HalfEdge, face: Option<Face>) {
        self.face[h.index()] = face.unwrap_or(Face::NONE);
    }

    /// Replaces the vertex' half-edge by `is`, if it was `was`.
    pub(super) fn anchor_vertex(&mut self, v: MeshVertex, was: HalfEdge, is: HalfEdge) {
        if self.vertex_half_edge[v.index()] == was {
            self.vertex_half_edge[v.index()] = is;
        }
    }

    /// Replaces the face's half-edge by `is`, if there is a face and its half-edge was `was`.
    pub(super) fn anchor_face(&mut self, face: Option<Face>, was: HalfEdge, is: HalfEdge) {
        if let Some(f) = face
            && self.face_half_edge[f.index()] == was
        {
            self.face_half_edge[f.index()] = is;
        }
    }
}
