//! A mesh split by planes, one after the other: the five steps of the lecture, on a half-edge mesh.
//!
//! 1. Each vertex is classified in one batch: on either side of the plane, or on it. Edges that cross are split: one
//!    call constructs all points, in the order of the half-edges.
//! 2. Faces with vertices on both sides are split between their vertices on the plane. These are sorted along the line
//!    where plane and face meet: the plane can cross a concave face several times.
//! 3. The mesh is cut open along the edges where faces of both sides meet: the two sides are disconnected in place.
//! 4. Caps cover the loops that this opens. A cap can have several loops, also nested ones; later planes split it like
//!    a face. Loops of a mesh that was open are covered at the end, seen from a side from which they are simple. If
//!    there is no such side, they stay open, and the answer lists them.
//! 5. Faces and caps are triangulated after the last plane. Where a part touches itself, the triangle at an edge is
//!    divided at the vertex on that edge.
//!
//! A plane is three vertices; *positive* is the side where [`Predicates::orient3d`] of them and a point is positive. A
//! part is the solid on one side of each plane; it may consist of several pieces.
//!
//! # What is constructed
//! Later planes split edges that earlier planes have made, and their new vertices again. No construction uses a
//! constructed vertex: each edge stores its line, by two input vertices or by two planes of three. So sessions that
//! [keep](predicament_predicates::Constructs) only constructions from input vertices can take any number of planes. For
//! the same reason faces are triangulated last and must be planar: a face that is not planar for the session is divided
//! into triangles first. (The session returns zero for all vertices of a planar polygon, unless it breaks ties: then
//! the perturbed polygon is not planar.)
//!
//! # What lies on a plane
//! A vertex with sign zero does not move. An edge on the plane is not a crossing. A face on the plane belongs to the
//! side of the solid: opposite to the direction that it faces.
//!
//! For sessions that break ties, only a plane's three vertices are on it, and the vertices constructed there. An edge
//! that lies in the plane of the given scene may cross the perturbed plane: then there is no point to construct, the
//! session refuses, and so does the algorithm. A plane along an edge or a face can be given by their own vertices,
//! which are on it.
//!
//! # When signs contradict each other
//! A sign belongs to a vertex, so a closed mesh stays closed, whatever the signs are. Wrong signs can spoil the order
//! along a line, and the triangulation. The size of the mesh bounds all loops. [`Sliced::broken`] names the first
//! invariant that fails; the parts are those made up to then.

mod chords;
mod contradiction;
mod cutter;
mod flat;
mod lines;
mod output;
mod planar;
mod projection;
mod sides;

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::OperationError;
use predicament_predicates::{Construction, Predicates, Refused, Vertex};

pub use contradiction::Contradiction;

use self::cutter::Cutter;
use self::planar::Planar;

/// The origin of a part's triangle.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Source {
    /// The face of the mesh with this handle.
    Face(u32),
    /// The cap in the plane with this index.
    Cap(u32),
    /// The cover of a loop that is not in any of the planes.
    Cover,
}

/// The part of the solid on one side of each plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Part {
    /// The triangles, counterclockwise as seen from outside.
    pub triangles: Vec<[Vertex; 3]>,
    /// For each triangle, its origin.
    pub sources: Vec<Source>,
    /// Loops without a cover, in the direction in which a cover would go around them.
    pub open: Vec<Vec<Vertex>>,
}

/// A mesh divided into parts.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Sliced {
    /// The parts that have faces.
    pub parts: Vec<Part>,
    /// The points constructed in the session, in the order of the vertices; some may be unused.
    pub constructions: Vec<Construction>,
    /// The number of faces split, summed over all planes.
    pub faces_split: u64,
    /// The first rule that fails, and the index of the plane there; `None` for the triangulation, after all planes.
    pub broken: Option<(Contradiction, Option<u32>)>,
}

/// Splits a mesh by planes. `supports` has three vertices of each face that turn as the face does.
///
/// # Errors
/// [`Refused`] if the session does not construct a requested point.
///
/// # Panics
/// If the numbers of supports and faces differ.
pub fn slice(
    session: &mut dyn Predicates,
    mesh: HalfEdgeMesh,
    supports: &[[Vertex; 3]],
    planes: &[[Vertex; 3]],
) -> Result<Sliced, Refused> {
    assert_eq!(mesh.face_count(), supports.len(), "a support for each face");
    let before = session.scene().constructions().len();
    let planar = match Planar::new(session, mesh, supports) {
        Ok(planar) => planar,
        Err(Halt::Refused(why)) => return Err(why),
        Err(Halt::Broken(what)) => return Ok(Sliced { broken: Some((what, Some(0))), ..Sliced::default() }),
    };
    let mut cutter = Cutter::new(session, planar, planes);
    let mut broken = None;
    for place in 0..planes.len() {
        match cutter.cut(place) {
            Ok(()) => {}
            Err(Halt::Refused(why)) => return Err(why),
            Err(Halt::Broken(what)) => {
                broken = Some((what, u32::try_from(place).ok()));
                break;
            }
        }
    }
    let mut sliced = cutter.output(before);
    sliced.broken = broken.or(sliced.broken);
    Ok(sliced)
}

/// The reason why a plane is not finished.
enum Halt {
    Refused(Refused),
    /// The invariant that fails.
    Broken(Contradiction),
}

impl From<Refused> for Halt {
    fn from(why: Refused) -> Halt {
        Halt::Refused(why)
    }
}

impl From<OperationError> for Halt {
    fn from(why: OperationError) -> Halt {
        use OperationError as E;
        Halt::Broken(match why {
            E::EdgeExists(_) => Contradiction::Joined,
            E::OneVertex(_) => Contradiction::TwoEnds,
            E::TooFewHalfEdges(_) => Contradiction::ThreeEdges,
            E::TwoFaces(..) | E::OneLoop(..) => Contradiction::Across,
            E::Full => Contradiction::TooMany,
            _ => Contradiction::Mesh,
        })
    }
}
