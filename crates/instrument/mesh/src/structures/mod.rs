//! Other structures of the same connectivity, and their conversions to half-edges and back.
//!
//! A program that keeps its meshes in one of these structures can give them to this project and take them back. Each
//! conversion goes through [`Links`](crate::half_edge::Links), takes linear time and returns equal links when it is
//! undone.
//!
//! | half-edge h of edge e | [winged edge](WingedEdges) | [quad edge](QuadEdges) | [radial edge](RadialEdges) |
//! |---|---|---|---|
//! | h, opposite(h) | the left and the right side of e | e, Sym(e) | two uses of e by faces of both sides |
//! | next(h) | the next wing of its side | Lnext(e) = Rot⁻¹(e).Onext.Rot | the next use in its loop |
//! | the half-edge before h | the previous wing of its side | Sym(Onext(e)) | the use before it in its loop |
//! | end(h) | the end of the edge, or the start | Dest(e) = Org(Sym(e)) | the start of the next use |
//! | face(h) | the face of its side | Left(e) = Org(Rot⁻¹(e)) | the face of the use |
//!
//! Only the radial edge has more than two faces at an edge.

mod quad;
mod radial;
mod winged;

pub use quad::QuadEdges;
pub use radial::{RadialEdges, Wedge};
pub use winged::{WingedEdge, WingedEdges};

/// An element of a structure whose links contradict each other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Contradiction {
    /// The links of the edge do not fit those of its neighbours.
    Edge(u32),
    /// The directed edge of a quad edge breaks the rule that e.Rot.Onext.Rot.Onext is e.
    Ring(u32),
    /// The use of the edge sees the front of a face by its back: one of both faces is turned over.
    Turned(u32),
}

impl std::fmt::Display for Contradiction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Contradiction::Edge(edge) => write!(f, "the links of edge {edge} do not fit those of its neighbours"),
            Contradiction::Ring(edge) => write!(f, "e.Rot.Onext.Rot.Onext is not e for the directed edge {edge}"),
            Contradiction::Turned(edge) => write!(f, "the use {edge} of an edge is beside a face that is turned over"),
        }
    }
}

impl std::error::Error for Contradiction {}
