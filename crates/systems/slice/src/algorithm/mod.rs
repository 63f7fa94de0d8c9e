//! A mesh split by planes, one after the other: the five steps of the lecture, on a half-edge mesh.
//!
//! 1. Vertices are put on either side of the plane or on it, in one batch. Edges that cross are split: all points are
//!    constructed in one call, in the order of the half-edges.
//! 2. Faces with vertices on both sides are split between the vertices that they have on the plane, which are sorted along
//!    the line where plane and face meet: a concave face can be crossed several times.
//! 3. The mesh is cut open along the edges where faces of both sides meet: the sides are unhooked from each other in place.
//! 4. The loops that this opens are covered by caps. A cap can have several loops, and nested ones; later planes
//!    split it like a face. Loops of a mesh that was open are covered at the end, seen from a side from which they are
//!    simple; where there is none, they stay open, and the answer lists them.
//! 5. Faces and caps are triangulated, when all planes are done.
//!
//! A plane is three vertices; *positive* is the side where [`Predicates::orient3d`] of them and a point is positive. Parts
//! are what is on one side of each plane; a part may be of several pieces.
//!
//! # What is constructed
//! Later planes split edges that earlier planes have made, and those vertices again. Nothing is constructed from a
//! constructed vertex: each edge knows the line that it is on, by two input vertices or by two planes of three. So sessions that
//! [keep](predicament_predicates::Constructs) only what input vertices define can take any number of planes. It is why
//! faces are triangulated last, and have to be plane: one that is not so for the session is divided into triangles
//! first. (Of a plane polygon the session says zero for all vertices, unless it breaks ties: then the perturbed polygon is not plane.)
//!
//! # What lies on a plane
//! A vertex for which the session says zero stays as it is. An edge on the plane is no crossing. A face on the plane is on the
//! side where the solid is: opposite to where it faces.
//!
//! For sessions that break ties only the three vertices of a plane are on it, and what they have constructed there. An edge that lies
//! in the plane as the scene is given may cross the perturbed plane: then there is no point to construct, the session
//! refuses, and so does this. A plane along an edge or a face can be given by their own vertices, which are on it.
//!
//! # When signs contradict each other
//! Signs are of vertices, so a mesh that is closed stays closed, whatever they are. What can go wrong is the order along a
//! line, and the triangulation. All loops are bounded by the size of the mesh; the first invariant that
//! does not hold is named in [`Sliced::broken`], and parts are what was made so far.

mod chords;
mod contradiction;
mod cutter;
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

/// What a triangle of a part is a piece of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Source {
    /// The face of the mesh with this handle.
    Face(u32),
    /// The cap in the plane with this place in the list.
    Cap(u32),
    /// The cover of a loop that is in no plane.
    Cover,
}

/// What is on one side of each plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Part {
    /// Counterclockwise as seen from outside.
    pub triangles: Vec<[Vertex; 3]>,
    /// For each triangle what it is a piece of.
    pub sources: Vec<Source>,
    /// Loops that no cover was found for, as a cover would go around them.
    pub open: Vec<Vec<Vertex>>,
}

/// A mesh in parts.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Sliced {
    /// Those that have faces.
    pub parts: Vec<Part>,
    /// What was constructed in the session, in the order of the vertices; not all of it need be used.
    pub constructions: Vec<Construction>,
    /// How many faces were split, over all planes.
    pub faces_split: u64,
    /// The first rule that did not hold, and the place of the plane where that was; none behind the planes is
    /// for the triangulation.
    pub broken: Option<(Contradiction, Option<u32>)>,
}

/// Splits a mesh by planes. For each face of the mesh `supports` has three of its vertices that turn as the face does.
///
/// # Errors
/// [`Refused`] where the session does not construct what it is asked for.
///
/// # Panics
/// If there are not as many supports as faces.
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

/// Why a plane is not done.
enum Halt {
    Refused(Refused),
    /// The invariant that does not hold.
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
