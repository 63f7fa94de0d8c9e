//! Resolution of closed meshes that cross, fold onto or touch themselves.
//!
//! A mesh of doubles that was rounded, or read from a file, may pass through itself. Its inside is defined as the
//! points with a positive winding number. The resolution returns that inside, regularised, as a surface whose triangles
//! meet in common corners and edges only. A part inside another part is removed, and so is a part that is turned inside
//! out.
//!
//! # Steps of a resolution
//! 1. Vertices at one position are merged; triangles with a vertex twice or without area are removed; equal triangles
//!    are counted, and opposite ones cancel (`faces.rs`).
//! 2. Pairs of triangles that have more in common than corners and edges are found, exactly:
//!    [`mod@crate::algorithm::rounding::flaws`].
//! 3. Triangles in such pairs are cut along their intersections: those of one plane together (`cut.rs`). No other
//!    triangle is cut: if a point of a triangle's edge is on a third triangle, the neighbour at this edge finds it as
//!    well.
//! 4. Vertices at one position are replaced by the first of them.
//! 5. Winding numbers on both sides of each face are computed (`winding.rs`): faces with the inside behind them and the
//!    outside in front stay.
//!
//! All points are intersections of an edge and a plane, or of three planes, of input vertices. All decisions are signs
//! of the session, which must return exact zeros.
//!
//! # Back to doubles
//! [`rounded`] rounds a resolution ([`mod@crate::algorithm::rounding`]), resolves new crossings, and repeats this at
//! most [`PASSES`] times (Valque, *Iterated snap rounding in space*; Devillers, Lazard and Lenhart, *Rounding meshes in
//! 3D*, subdivide in advance instead). It stops early if the pairs that meet become more. It keeps the pass with the
//! fewest pairs.
//!
//! **Guaranteed**, if it ends with nothing [left](Counts::left): the mesh is closed, each triangle has an area, and
//! triangles meet in common corners and edges only. The winding number is 0 or 1 everywhere off the surface. Each point
//! of the surface is within [`Counts::farthest`] in each coordinate of a point of the given surface.
//!
//! **Not guaranteed** is that it ends so: in each pass another rounded vertex may pass through a triangle that was
//! beside it. Crossings after the last pass are counted. The topology is not kept either where parts are nearer to each
//! other than doubles are: such parts merge, or vanish.

mod cut;
pub(crate) mod faces;
mod winding;

use predicament_predicates::{Declined, Predicates, Scene, SceneError, Vertex};

use self::cut::Groups;
use self::faces::Face;
use crate::algorithm::limit::Places;
use crate::algorithm::limit::places::Same;
use crate::algorithm::overlay::{Undone, number};
use crate::algorithm::rounding::flaws::pairs;
use crate::algorithm::rounding::{self, Closed, NotRounded, Rounded};
use crate::algorithm::sessions::{Sessions, with};

/// The maximum number of roundings; each rounds the resolution of the previous result.
pub const PASSES: usize = 16;

/// Statistics of a resolution.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Counts {
    /// The number of resolutions that had something to resolve.
    pub passes: usize,
    /// Pairs of triangles that had more in common than corners and edges.
    pub pairs: usize,
    /// Triangles that were cut.
    pub cut: usize,
    /// Points that were constructed.
    pub constructed: usize,
    /// Faces, after cutting, that do not bound the inside.
    pub dropped: usize,
    /// Pairs that remain after the last rounding; 0 for a resolution, which leaves none.
    pub left: usize,
    /// An upper bound on the move of any point in each coordinate, in units of the scene: the sum of the largest moves
    /// of all roundings.
    pub farthest: f64,
}

impl Counts {
    fn add(&mut self, other: &Counts) {
        self.passes += other.passes;
        self.pairs += other.pairs;
        self.cut += other.cut;
        self.constructed += other.constructed;
        self.dropped += other.dropped;
        self.left = other.left;
        self.farthest += other.farthest;
    }
}

/// A mesh that does not cross itself.
#[derive(Clone, PartialEq, Debug)]
pub struct Resolved {
    /// The points of the given mesh, and the constructed ones.
    pub scene: Scene,
    /// The triangles, counterclockwise as seen from outside, by vertices of the scene at different positions.
    pub triangles: Vec<[Vertex; 3]>,
    /// The doubles nearest to the scene's vertices.
    pub places: Places,
    /// Statistics of the resolution.
    pub counts: Counts,
}

/// The reason why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum Unresolved {
    /// A coordinate is not finite, or there are too many vertices.
    Scene(SceneError),
    /// The backend declines the scene.
    Declined(Declined),
    /// A point is not constructed, or signs or the mesh break an invariant.
    Undone(Undone),
}

impl std::fmt::Display for Unresolved {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Unresolved::Scene(why) => why.fmt(f),
            Unresolved::Declined(why) => why.fmt(f),
            Unresolved::Undone(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for Unresolved {}

impl From<Declined> for Unresolved {
    fn from(why: Declined) -> Unresolved {
        Unresolved::Declined(why)
    }
}

impl From<Undone> for Unresolved {
    fn from(why: Undone) -> Unresolved {
        Unresolved::Undone(why)
    }
}

impl From<NotRounded> for Unresolved {
    fn from(why: NotRounded) -> Unresolved {
        match why {
            NotRounded::Scene(why) => Unresolved::Scene(why),
            NotRounded::Declined(why) => Unresolved::Declined(why),
        }
    }
}

/// Computes the surface of the points with a positive winding number in a closed mesh, without self-intersections;
/// `exact` is the backend with exact zeros.
///
/// # Errors
/// [`Unresolved`]; [`Undone::Broken`] also if the mesh is not closed.
///
/// # Panics
/// If a triangle has a vertex that does not exist.
pub fn resolved(exact: &dyn Sessions, mesh: &Closed) -> Result<Resolved, Unresolved> {
    let scene = Scene::from_points3(&mesh.points).map_err(Unresolved::Scene)?;
    with(exact, &scene, &mut |session| {
        let Found { faces, pairs } = find(session, mesh, &|_| true);
        let Kept { triangles, places, counts } = kept(session, &faces, &pairs)?;
        Ok(Resolved { scene: session.scene().clone(), triangles, places, counts })
    })
}

/// Resolves a mesh to doubles, with at most [`PASSES`] roundings; an empty mesh is empty space.
///
/// # Errors
/// As [`resolved`].
///
/// # Panics
/// As [`resolved`].
pub fn rounded(exact: &dyn Sessions, mesh: &Closed) -> Result<(Closed, Counts), Unresolved> {
    let all = vec![true; mesh.points.len()];
    rounded_since(exact, mesh.clone(), all, true)
}

/// Resolves like [`rounded`], for a mesh in which only triangles with a moved vertex can meet others. `is_suspect`
/// means that a winding number may differ from 0 and 1 even if no triangles meet.
pub(crate) fn rounded_since(
    exact: &dyn Sessions,
    mut mesh: Closed,
    mut moved: Vec<bool>,
    mut is_suspect: bool,
) -> Result<(Closed, Counts), Unresolved> {
    let mut counts = Counts::default();
    let mut best: Option<(Closed, Counts)> = None;
    let mut worse = 0;
    for pass in 0..=PASSES {
        let scene = Scene::from_points3(&mesh.points).map_err(Unresolved::Scene)?;
        let next = with(exact, &scene, &mut |session| {
            let Found { faces, pairs } = find(session, &mesh, &|v| moved[v as usize]);
            counts.left = pairs.len();
            let fewest = best.as_ref().map_or(usize::MAX, |(_, best)| best.left);
            worse = if pairs.len() < fewest { 0 } else { worse + 1 };
            // (If two passes have no pairs, the later one: its winding numbers are 0 and 1.)
            if pairs.len() <= fewest {
                best = Some((mesh.clone(), counts));
            }
            let most = MOST.max(fewest.saturating_mul(GROWTH));
            let is_done = pairs.is_empty() && !is_suspect;
            if is_done || pass == PASSES || worse > WORSE || pairs.len() > most {
                return Ok::<_, Unresolved>(None);
            }
            let Kept { triangles, places, counts: of_pass } = kept(session, &faces, &pairs)?;
            counts.add(&of_pass);
            let surface = (&triangles[..], &places);
            let ways = rounding::PASSES;
            let made = rounding::of_triangles(exact, session, surface, ways)?;
            counts.farthest += farthest(session, &triangles, &places);
            Ok(Some(made))
        })?;
        let Some(Rounded { closed, moved: now, counts: made, .. }) = next else { break };
        (mesh, moved) = (closed, now);
        is_suspect = made.left > 0;
    }
    Ok(best.expect("there is a first pass"))
}

/// The maximum number of passes without fewer pairs than an earlier pass.
const WORSE: usize = 3;
/// The process stops if a pass leaves more pairs than [`MOST`] and than this many times the fewest.
const GROWTH: usize = 8;
/// The process never stops early with at most this number of pairs: see [`GROWTH`].
const MOST: usize = 256;

/// The largest distance along a coordinate between a vertex and its possible roundings: at most an ulp.
fn farthest(session: &dyn Predicates, triangles: &[[Vertex; 3]], places: &Places) -> f64 {
    let constructed = triangles.as_flattened().iter().filter(|v| v.is_constructed());
    let move_of = |&v: &Vertex| {
        let [nearest, beyond] = [places.nearest(session.scene(), v), places.beyond(session.scene(), v)];
        (0..3).map(|axis| (nearest[axis] - beyond[axis]).abs()).fold(0.0, f64::max)
    };
    constructed.map(move_of).fold(0.0, f64::max)
}

/// The faces of a mesh, and the pairs that meet.
struct Found {
    faces: Vec<Face>,
    /// Pairs of indices, each with true if they are in one plane.
    pairs: Vec<([u32; 2], bool)>,
}

fn find(session: &dyn Predicates, mesh: &Closed, is_moved: &(dyn Fn(u32) -> bool + Sync)) -> Found {
    // Vertices at one position are replaced by the first, which has moved if one of them has.
    let key = |v: u32| mesh.points[v as usize].map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..number(mesh.points.len())).collect();
    order.sort_unstable_by_key(|&v| (key(v), v));
    let mut stands = order.clone();
    let mut moved = vec![false; order.len()];
    for same in order.chunk_by(|&v, &w| key(v) == key(w)) {
        same.iter().for_each(|&v| stands[v as usize] = same[0]);
        moved[same[0] as usize] = same.len() > 1 || is_moved(same[0]);
    }
    let triangles = mesh.triangles.iter().map(|triangle| triangle.map(|v| Vertex::input(stands[v as usize] as usize)));
    let faces = faces::summed(session, triangles);
    let triangle = |at: usize| faces[at].corners.map(|v| number(v.index()));
    let pairs = pairs(session, faces.len(), &triangle, &|v| moved[v as usize]);
    let is_coplanar = |[first, second]: [u32; 2]| {
        let [first, second] = [first, second].map(|at| faces[at as usize].corners);
        second.into_iter().all(|v| faces::side(session, first, v).is_zero())
    };
    let pairs = pairs.into_iter().map(|(pair, _)| (pair, is_coplanar(pair))).collect();
    Found { faces, pairs }
}

/// The faces that bound the inside.
struct Kept {
    triangles: Vec<[Vertex; 3]>,
    places: Places,
    counts: Counts,
}

fn kept(session: &mut dyn Predicates, faces: &[Face], pairs: &[([u32; 2], bool)]) -> Result<Kept, Undone> {
    let mut places = Places::new(session.scene())?;
    let mut counts = Counts { passes: 1, pairs: pairs.len(), ..Counts::default() };
    let groups = Groups::of(pairs);
    let mut is_cut = vec![false; faces.len()];
    let mut parts: Vec<Face> = Vec::new();
    for group in &groups.all {
        group[0].iter().for_each(|&at| is_cut[at as usize] = true);
        parts.extend(cut::cut(session, &mut places, faces, group)?);
    }
    counts.cut = is_cut.iter().filter(|is| **is).count();
    counts.constructed = session.scene().constructions().len();
    let same = Same::of(session, &places, parts.iter().flat_map(|part| part.corners).collect());
    parts.iter_mut().for_each(|part| part.corners = part.corners.map(|v| same.stand(v)));
    let mut all: Vec<Face> = faces.iter().zip(is_cut).filter(|(_, is_cut)| !is_cut).map(|(face, _)| *face).collect();
    all.extend(parts);
    let in_front = winding::in_front(session, &places, &all)?;
    let bounds = |&(face, front): &(&Face, i32)| front <= 0 && front + face.times > 0;
    let triangles: Vec<[Vertex; 3]> = all.iter().zip(in_front).filter(bounds).map(|(face, _)| face.corners).collect();
    counts.dropped = all.len() - triangles.len();
    Ok(Kept { triangles, places, counts })
}
