//! Closed meshes that cross, fold onto or touch themselves, as meshes that do not.
//!
//! A mesh of doubles that was rounded, or read from a file, may pass through itself. What it bounds is taken to be what it goes around more often than not at all: where its winding number
//! is positive. That is what is left of it here, regularised, as a surface whose triangles meet in common corners and edges only. A part that is inside of another goes, and so
//! does one that is turned inside out.
//!
//! # Steps of a resolution
//! 1. Vertices at one place become one; triangles with a vertex twice or without area go; equal ones are counted, and opposite ones cancel (`faces.rs`).
//! 2. Pairs of triangles that have more in common than corners and edges are found, exactly: [`mod@crate::algorithm::rounding::flaws`].
//! 3. Triangles in such pairs are cut along what they have in common: those of one plane together (`cut.rs`). No other triangle is cut: a point of a triangle's edge that is on a third one is found by
//!    the neighbour at this edge as well.
//! 4. Of vertices at one place the first stands for all.
//! 5. Winding numbers on both sides of each face (`winding.rs`): what has the inside behind it and the outside in front stays.
//!
//! All points are crossings of an edge and a plane, or of three planes, of input vertices. All decisions are signs of the session, which has to say zero where something is zero.
//!
//! # Back to doubles
//! [`rounded`] rounds a resolution ([`mod@crate::algorithm::rounding`]), resolves what crosses then, and so on (Valque, *Iterated snap rounding in space*; Devillers, Lazard and Lenhart, *Rounding meshes in
//! 3D*, subdivide in advance instead), [`PASSES`] times at most, and not for long where pairs that meet become more. What has the fewest stays.
//!
//! **Guaranteed**, if it ends with nothing [left](Counts::left): the mesh is closed, no triangle is without area, triangles meet in common corners and edges only, the winding number is 0 or 1
//! everywhere off the surface, and each point of the surface is within [`Counts::farthest`] in each coordinate of a point of the surface that was given.
//!
//! **Not guaranteed** is that it ends so: a rounded vertex may pass through a triangle that was beside it, in each pass another one. What crosses after the last pass is counted. Nor is the topology
//! kept where parts are nearer to each other than doubles are: they grow together, or vanish.

mod cut;
mod faces;
mod planar;
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

/// Roundings, at most, each of the resolution of what the one before it left.
pub const PASSES: usize = 16;

/// What was done.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Counts {
    /// Resolutions of something.
    pub passes: usize,
    /// Pairs of triangles that had more in common than corners and edges.
    pub pairs: usize,
    /// Triangles that were cut.
    pub cut: usize,
    /// Points that were constructed.
    pub constructed: usize,
    /// Faces, after cutting, that do not bound the inside.
    pub dropped: usize,
    /// Pairs that are left after the last rounding; 0 for a resolution, which leaves none.
    pub left: usize,
    /// In each coordinate no point has moved farther than this, in units of the scene: the sum of the largest moves of all roundings.
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
    /// The points of the mesh that was given, and the constructed ones.
    pub scene: Scene,
    /// Counterclockwise as seen from outside, by vertices of the scene, each of them at another place.
    pub triangles: Vec<[Vertex; 3]>,
    /// The doubles nearest to these.
    pub places: Places,
    /// What was done.
    pub counts: Counts,
}

/// Why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum Unresolved {
    /// A coordinate is not finite, or there are too many vertices.
    Scene(SceneError),
    /// The backend does not take the scene.
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

/// The surface of what a closed mesh goes around more often than not at all, without self-intersections; `exact` is what says zero where something is zero.
///
/// # Errors
/// [`Unresolved`]; [`Undone::Broken`] also where the mesh is not closed.
///
/// # Panics
/// If a triangle has a vertex that there is not.
pub fn resolved(exact: &dyn Sessions, mesh: &Closed) -> Result<Resolved, Unresolved> {
    let scene = Scene::from_points3(&mesh.points).map_err(Unresolved::Scene)?;
    with(exact, &scene, &mut |session| {
        let Found { faces, pairs } = find(session, mesh, &|_| true);
        let Kept { triangles, places, counts } = kept(session, &faces, &pairs)?;
        Ok(Resolved { scene: session.scene().clone(), triangles, places, counts })
    })
}

/// The same in doubles, as far as [`PASSES`] roundings go; no mesh at all is empty space.
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

/// [`rounded`] for a mesh of which only triangles with a moved vertex can meet others; `is_suspect` says that it may go around something not once even if
/// none of them does.
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
            // (Of two without any the later one: it goes around everything once.)
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

/// Passes that leave no fewer pairs than one before them, after which nothing more is tried.
const WORSE: usize = 3;
/// Nothing more is tried where a pass leaves so many times the fewest pairs,
const GROWTH: usize = 8;
/// and more than this.
const MOST: usize = 256;

/// The largest distance along a coordinate of a vertex from where it may go: at most an ulp.
fn farthest(session: &dyn Predicates, triangles: &[[Vertex; 3]], places: &Places) -> f64 {
    let constructed = triangles.as_flattened().iter().filter(|v| v.is_constructed());
    let move_of = |&v: &Vertex| {
        let [nearest, beyond] = [places.nearest(session.scene(), v), places.beyond(session.scene(), v)];
        (0..3).map(|axis| (nearest[axis] - beyond[axis]).abs()).fold(0.0, f64::max)
    };
    constructed.map(move_of).fold(0.0, f64::max)
}

/// The faces of a mesh, and those that meet.
struct Found {
    faces: Vec<Face>,
    /// By their places, with whether they are of one plane.
    pairs: Vec<([u32; 2], bool)>,
}

fn find(session: &dyn Predicates, mesh: &Closed, is_moved: &(dyn Fn(u32) -> bool + Sync)) -> Found {
    // Of vertices at one place the first stands for all, and has moved if one of them has.
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

/// What bounds the inside.
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
