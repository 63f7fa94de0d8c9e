//! Half-edge meshes: orientable surfaces with boundaries, polygons of any size as faces.
//!
//! Each edge has two half-edges, one in each direction. A half-edge stores its *end vertex*, the *next* half-edge of
//! its loop, its *opposite*, and the *face* on its left; it has a *marker* and *user data*. A loop belongs to one face,
//! or to none: then it is a boundary loop. Boundary half-edges exist and are linked like all others, so the ring of
//! every vertex is closed.
//!
//! # Invariants
//! [`validate`](HalfEdgeMesh::validate) returns the first violation; every operation keeps all invariants
//! or refuses. Let h be any half-edge, and start(h) the end of its opposite:
//! * opposite(h) ≠ h, opposite(opposite(h)) = h, start(h) ≠ end(h);
//! * next(h) ≠ h, start(next(h)) = end(h), and no other half-edge has this next;
//! * face(next(h)) = face(h), each face has one loop, of at least three half-edges;
//! * the half-edge of a face is in its loop, that of a vertex ends at it;
//! * the half-edges that end at a vertex make one ring: h, opposite(next(h)), and so on;
//! * two vertices are joined by at most one edge.
//!
//! # What is allowed
//! * A pinched vertex: several fans of faces with gaps between them. Boundary loops are linked through it so that its
//!   ring visits all fans. [`gaps`](HalfEdgeMesh::gaps) counts them. A closed fan must be the only fan at its vertex.
//! * A face that visits a vertex twice, or has both sides of an edge: auxiliary edges make such faces.
//! * A wire: an edge without a face on either side.
//! * A vertex without edges.
//!
//! Faces with several loops are not allowed: an auxiliary edge joins a hole to the outer loop.
//!
//! The mesh uses no coordinates. An algorithm with a wrong predicate can make a mesh whose geometry is nonsense, but
//! not a mesh that breaks an invariant. All traversals end after at most as many steps as there are half-edges, even if
//! an invariant is broken.

mod auxiliary;
mod build;
mod collapse;
mod conversion_error;
mod cut;
mod flip;
mod handles;
mod indexed;
mod links;
mod operation_error;
mod remove;
mod split;
mod storage;
mod traverse;
mod validate;

use predicament_predicates::Vertex;

pub use collapse::{Collapsed, Side};
pub use conversion_error::ConversionError;
pub use handles::{Face, HalfEdge, MeshVertex};
pub use indexed::IndexedFaces;
pub use links::{Link, Links};
pub use operation_error::OperationError;
pub use validate::{Element, Violation};

/// The half-edge value of a removed vertex; a vertex without edges has [`handles::NONE`].
const REMOVED: HalfEdge = HalfEdge(handles::NONE - 1);

/// A half-edge mesh, as a structure of arrays.
///
/// Later operations reuse the handles of removed elements. Methods that get a handle of another mesh, or of a removed
/// element, panic or answer about another element; operations return an error if they detect it.
#[derive(Clone, Debug, Default)]
pub struct HalfEdgeMesh {
    // Half-edges; the end of a removed half-edge is `NONE`.
    end: Vec<MeshVertex>,
    next: Vec<HalfEdge>,
    opposite: Vec<HalfEdge>,
    face: Vec<Face>,
    marker: Vec<u8>,
    user_data: Vec<u32>,
    // Faces; the half-edge of a removed face is `NONE`.
    face_half_edge: Vec<HalfEdge>,
    face_marker: Vec<u8>,
    face_user_data: Vec<u32>,
    // Vertices.
    vertex_half_edge: Vec<HalfEdge>,
    vertex_marker: Vec<u8>,
    vertex_user_data: Vec<u32>,
    scene_vertex: Vec<Vertex>,
    // The handles of removed elements, to be reused.
    free_half_edges: Vec<HalfEdge>,
    free_faces: Vec<Face>,
    free_vertices: Vec<MeshVertex>,
}

impl HalfEdgeMesh {
    /// The vertex that the half-edge ends at.
    #[inline]
    #[must_use]
    pub fn end(&self, h: HalfEdge) -> MeshVertex {
        self.end[h.index()]
    }

    /// The vertex that the half-edge starts at: the end of its opposite.
    #[inline]
    #[must_use]
    pub fn start(&self, h: HalfEdge) -> MeshVertex {
        self.end(self.opposite(h))
    }

    /// The next half-edge of the loop.
    #[inline]
    #[must_use]
    pub fn next(&self, h: HalfEdge) -> HalfEdge {
        self.next[h.index()]
    }

    /// The other half-edge of the edge.
    #[inline]
    #[must_use]
    pub fn opposite(&self, h: HalfEdge) -> HalfEdge {
        self.opposite[h.index()]
    }

    /// The face on the left; `None` on a boundary.
    #[inline]
    #[must_use]
    pub fn face(&self, h: HalfEdge) -> Option<Face> {
        self.face[h.index()].some()
    }

    /// True if the half-edge has no face on its left.
    #[inline]
    #[must_use]
    pub fn is_boundary(&self, h: HalfEdge) -> bool {
        self.face(h).is_none()
    }

    /// A half-edge of the face.
    #[inline]
    #[must_use]
    pub fn half_edge_of_face(&self, f: Face) -> HalfEdge {
        self.face_half_edge[f.index()]
    }

    /// A half-edge that ends at the vertex; `None` if the vertex has no edges.
    #[inline]
    #[must_use]
    pub fn half_edge_of_vertex(&self, v: MeshVertex) -> Option<HalfEdge> {
        self.vertex_half_edge[v.index()].some()
    }

    /// The vertex of the scene that the mesh vertex represents.
    #[inline]
    #[must_use]
    pub fn scene_vertex(&self, v: MeshVertex) -> Vertex {
        self.scene_vertex[v.index()]
    }

    /// The marker of a half-edge; 0 until it is set.
    #[must_use]
    pub fn marker(&self, h: HalfEdge) -> u8 {
        self.marker[h.index()]
    }

    /// Sets the marker of a half-edge.
    pub fn set_marker(&mut self, h: HalfEdge, marker: u8) {
        self.marker[h.index()] = marker;
    }

    /// The marker of a face; 0 until it is set.
    #[must_use]
    pub fn face_marker(&self, f: Face) -> u8 {
        self.face_marker[f.index()]
    }

    /// Sets the marker of a face.
    pub fn set_face_marker(&mut self, f: Face, marker: u8) {
        self.face_marker[f.index()] = marker;
    }

    /// The marker of a vertex; 0 until it is set.
    #[must_use]
    pub fn vertex_marker(&self, v: MeshVertex) -> u8 {
        self.vertex_marker[v.index()]
    }

    /// Sets the marker of a vertex.
    pub fn set_vertex_marker(&mut self, v: MeshVertex, marker: u8) {
        self.vertex_marker[v.index()] = marker;
    }

    /// Sets the markers of all half-edges, faces and vertices to 0.
    pub fn clear_markers(&mut self) {
        self.marker.fill(0);
        self.face_marker.fill(0);
        self.vertex_marker.fill(0);
    }

    /// The user data of a half-edge; 0 until it is set.
    #[must_use]
    pub fn user_data(&self, h: HalfEdge) -> u32 {
        self.user_data[h.index()]
    }

    /// Sets the user data of a half-edge.
    pub fn set_user_data(&mut self, h: HalfEdge, data: u32) {
        self.user_data[h.index()] = data;
    }

    /// The user data of a face; 0 until it is set.
    #[must_use]
    pub fn face_user_data(&self, f: Face) -> u32 {
        self.face_user_data[f.index()]
    }

    /// Sets the user data of a face.
    pub fn set_face_user_data(&mut self, f: Face, data: u32) {
        self.face_user_data[f.index()] = data;
    }

    /// The user data of a vertex; 0 until it is set.
    #[must_use]
    pub fn vertex_user_data(&self, v: MeshVertex) -> u32 {
        self.vertex_user_data[v.index()]
    }

    /// Sets the user data of a vertex.
    pub fn set_vertex_user_data(&mut self, v: MeshVertex, data: u32) {
        self.vertex_user_data[v.index()] = data;
    }
}
