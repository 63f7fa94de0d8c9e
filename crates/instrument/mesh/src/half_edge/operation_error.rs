//! The reasons why operations are refused; the mesh is then unchanged.

use super::{Face, HalfEdge, MeshVertex};

/// The reason why an operation on a mesh is refused. The mesh is unchanged.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OperationError {
    /// The mesh does not have this half-edge, or has it no longer.
    NoSuchHalfEdge(HalfEdge),
    /// The mesh does not have this face, or has it no longer.
    NoSuchFace(Face),
    /// The mesh does not have this vertex, or has it no longer.
    NoSuchVertex(MeshVertex),
    /// A half-edge needs a face on its left, but has none.
    OnBoundary(HalfEdge),
    /// A half-edge must not have a face on its left, but has one.
    NotOnBoundary(HalfEdge),
    /// The two half-edges are of different faces; they must be of the same face.
    TwoFaces(HalfEdge, HalfEdge),
    /// The two half-edges are of one loop; they must be of different loops.
    OneLoop(HalfEdge, HalfEdge),
    /// The face does not visit the vertex.
    NotInFace(Face, MeshVertex),
    /// The face visits the vertex more than once: select the corner by half-edges.
    SeveralCorners(Face, MeshVertex),
    /// Both ends of the new edge would be this vertex.
    OneVertex(MeshVertex),
    /// The new edge would be the second edge between its vertices; this half-edge is of the first.
    EdgeExists(HalfEdge),
    /// The loop of this half-edge, which has a face, would have fewer than three half-edges.
    TooFewHalfEdges(HalfEdge),
    /// The face is not a triangle.
    NoTriangle(Face),
    /// The vertex does not have exactly two edges.
    NotTwoEdges(MeshVertex),
    /// Both sides of the edge are in one face, so it does not separate two faces.
    OneFace(HalfEdge),
    /// The two sides of the edge are in different loops, so it is not an auxiliary edge.
    NotAuxiliary(HalfEdge),
    /// The vertex would have no edges left.
    LastEdge(MeshVertex),
    /// The vertex would have one edge left.
    OneEdge(MeshVertex),
    /// The edge of this half-edge would have no face, or has none.
    NoFace(HalfEdge),
    /// Boundaries would meet in this vertex that did not meet before, or would part there.
    Pinched(MeshVertex),
    /// Two triangles would have, or have, the same vertices.
    SameVertices(Face, Face),
    /// The two half-edges end at different vertices; they must end at one vertex.
    TwoVertices(HalfEdge, HalfEdge),
    /// The face is listed twice.
    ListedTwice(Face),
    /// The edge of this half-edge is listed twice.
    EdgeListedTwice(HalfEdge),
    /// The mesh would have more elements than there are handles.
    Full,
    /// The links at this half-edge violate an invariant.
    Broken(HalfEdge),
}

impl std::fmt::Display for OperationError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        use OperationError as E;
        match self {
            E::NoSuchHalfEdge(h) => write!(f, "the mesh has no half-edge {h}"),
            E::NoSuchFace(face) => write!(f, "the mesh has no face {face}"),
            E::NoSuchVertex(v) => write!(f, "the mesh has no vertex {v}"),
            E::OnBoundary(h) => write!(f, "half-edge {h} is on a boundary"),
            E::NotOnBoundary(h) => write!(f, "half-edge {h} is not on a boundary"),
            E::TwoFaces(a, b) => write!(f, "half-edges {a} and {b} are of two faces"),
            E::OneLoop(a, b) => write!(f, "half-edges {a} and {b} are of one loop"),
            E::NotInFace(face, v) => write!(f, "face {face} does not visit vertex {v}"),
            E::SeveralCorners(face, v) => write!(f, "face {face} visits vertex {v} several times"),
            E::OneVertex(v) => write!(f, "both ends of the edge would be vertex {v}"),
            E::EdgeExists(h) => write!(f, "half-edge {h} joins the same vertices already"),
            E::TooFewHalfEdges(h) => write!(f, "the face at half-edge {h} would have fewer than three half-edges"),
            E::NoTriangle(face) => write!(f, "face {face} is no triangle"),
            E::NotTwoEdges(v) => write!(f, "vertex {v} has not exactly two edges"),
            E::OneFace(h) => write!(f, "both sides of half-edge {h} are in one face"),
            E::NotAuxiliary(h) => write!(f, "the two sides of half-edge {h} are in different loops"),
            E::LastEdge(v) => write!(f, "vertex {v} would be left without edges"),
            E::OneEdge(v) => write!(f, "vertex {v} would be left with one edge"),
            E::NoFace(h) => write!(f, "the edge of half-edge {h} has no face, or would have none"),
            E::Pinched(v) => write!(f, "boundaries would meet or part in vertex {v}"),
            E::SameVertices(a, b) => write!(f, "faces {a} and {b} have the same vertices, or would have them"),
            E::TwoVertices(a, b) => write!(f, "half-edges {a} and {b} end at two vertices"),
            E::ListedTwice(face) => write!(f, "face {face} is listed twice"),
            E::EdgeListedTwice(h) => write!(f, "the edge of half-edge {h} is listed twice"),
            E::Full => f.write_str("a mesh has at most 2^32 - 2 elements of a kind"),
            E::Broken(h) => write!(f, "the links at half-edge {h} violate an invariant"),
        }
    }
}

impl std::error::Error for OperationError {}
