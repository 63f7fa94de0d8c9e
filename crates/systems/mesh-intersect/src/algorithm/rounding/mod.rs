//! Results of operations on meshes as meshes of doubles.
//!
//! A constructed vertex goes to the nearest double in each coordinate. That moves it by half an ulp, and a thin triangle may collapse,
//! turn over, or pass through another one. What becomes of a result is counted, and mended where that can be done by other
//! choices.
//!
//! # Steps
//! 1. Vertices at one place become one. Triangles with a vertex twice go, and pairs of opposite ones, and flat ones: their neighbours are divided
//!    at vertices on their edges.
//! 2. Triangles with moved vertices are looked at, exactly: whether they have turned over (`turned`), lie on a neighbour (`folded`), or pass through
//!    another one or touch it where they have no common vertex (`crossing`): see `flaws.rs`.
//! 3. Vertices of such triangles go to other doubles beside their place, and all is looked at again, [`PASSES`] times at most. The
//!    first way with the fewest flaws stays.
//!
//! # What is guaranteed
//! The result is closed and has no triangle without area. If no flaw is left, its triangles meet in common vertices and edges
//! only, or where they have met before and none of them has a moved vertex; none is turned over, and each vertex is within one ulp of its place in each coordinate. That flaws do not stay is not guaranteed:
//! for that, vertices would have to move farther (Valque, *Iterated snap rounding in space*), or triangles be divided.

pub mod flaws;

use predicament_mesh::{MaterialError, MaterialMesh};
use predicament_predicates::{Axis, Declined, Plane, Predicates, Scene, SceneError, Sign, Vertex};

use self::flaws::Flaws;
use crate::algorithm::limit::chain::Chain;
use crate::algorithm::limit::joints::Joints;
use crate::algorithm::limit::{Limit, Places};
use crate::algorithm::sessions::{Sessions, with};

/// Ways of rounding that are tried.
pub const PASSES: u32 = 8;

/// A closed mesh of doubles: an empty one is empty space.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Closed {
    /// The vertices, each of them a corner.
    pub points: Vec<[f64; 3]>,
    /// Counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Closed {
    /// Whether it is closed, and each triangle has three vertices that there are. An empty one is.
    ///
    /// # Errors
    /// The first triangle, else the first edge, that is wrong.
    pub fn check(&self) -> Result<(), MaterialError> {
        if self.triangles.is_empty() {
            return Ok(());
        }
        let vertex = |v: u32| Vertex::input(v as usize);
        let triangles = self.triangles.iter().map(|triangle| triangle.map(vertex)).collect();
        MaterialMesh::of_closed(self.points.len(), triangles).map(|_| ())
    }
}

/// What rounding has done.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Counts {
    /// Constructed vertices that are no doubles.
    pub moved: usize,
    /// Vertices that have become one with another.
    pub merged: usize,
    /// Triangles that are gone.
    pub collapsed: usize,
    /// Triangles that have turned over where all vertices go to the nearest doubles.
    pub turned: usize,
    /// Pairs of triangles with a common edge, of which one lies on the other then.
    pub folded: usize,
    /// Other pairs of triangles that pass through each other then.
    pub crossing: usize,
    /// Vertices that do not go to the nearest doubles, so that there are fewer of these.
    pub mended: usize,
    /// All of these that are left.
    pub left: usize,
}

/// A limit in doubles.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Rounded {
    /// The mesh.
    pub closed: Closed,
    /// For each point the vertex of the limit that it was.
    pub vertices: Vec<Vertex>,
    /// For each point whether a vertex has moved there.
    pub moved: Vec<bool>,
    /// What rounding has done.
    pub counts: Counts,
}

/// Why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum NotRounded {
    /// There are too many vertices.
    Scene(SceneError),
    /// The backend does not take the scene.
    Declined(Declined),
}

impl From<Declined> for NotRounded {
    fn from(why: Declined) -> NotRounded {
        NotRounded::Declined(why)
    }
}

impl std::fmt::Display for NotRounded {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NotRounded::Scene(why) => why.fmt(f),
            NotRounded::Declined(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for NotRounded {}

/// The limit of a result in doubles. The session is the one of the limit; `exact` is what says zero where something is zero.
///
/// # Errors
/// [`NotRounded`], where the rounded mesh is no scene that the backend takes.
pub fn rounded(exact: &dyn Sessions, session: &dyn Predicates, limit: &Limit) -> Result<Rounded, NotRounded> {
    of_triangles(exact, session, (&limit.solid.triangles, &limit.places), PASSES)
}

/// A closed surface in doubles, by at most so many ways.
pub(crate) fn of_triangles(
    exact: &dyn Sessions,
    session: &dyn Predicates,
    (triangles, places): (&[[Vertex; 3]], &Places),
    passes: u32,
) -> Result<Rounded, NotRounded> {
    let mut rounding = Rounding::new(session, triangles, places);
    let moved = rounding.vertices.iter().filter(|vertex| vertex.is_moved).count();
    if moved == 0 {
        let triangles = std::mem::take(&mut rounding.triangles);
        let closed = Closed { points: rounding.points(), triangles };
        let moved = vec![false; closed.points.len()];
        return Ok(Rounded { closed, vertices: rounding.names, moved, counts: Counts::default() });
    }
    let mut best: Option<Rounded> = None;
    let mut first = Flaws::default();
    for pass in 0..passes {
        let scene = Scene::from_points3(&rounding.points()).map_err(NotRounded::Scene)?;
        let (built, flaws) = with(exact, &scene, &mut |session| {
            let built = rounding.built(session);
            let is_moved = |v: u32| built.moved[v as usize];
            let flaws = flaws::flaws(session, &built.triangles, &is_moved, &rounding.turns);
            Ok::<_, NotRounded>((built, flaws))
        })?;
        if pass == 0 {
            first = flaws.clone();
        }
        let left = flaws.count();
        if best.as_ref().is_none_or(|best| left < best.counts.left) {
            let counts = Counts {
                moved,
                merged: built.merged,
                collapsed: built.collapsed,
                turned: first.turned,
                folded: first.folded,
                crossing: first.crossing,
                mended: rounding.vertices.iter().filter(|vertex| vertex.way != 0).count(),
                left,
            };
            let (closed, kept) = compact(&rounding.points(), &built.triangles);
            let vertices = kept.iter().map(|&v| rounding.names[v as usize]).collect();
            let moved = kept.iter().map(|&v| built.moved[v as usize]).collect();
            best = Some(Rounded { closed, vertices, moved, counts });
        }
        if left == 0 {
            break;
        }
        flaws.vertices.iter().for_each(|&v| rounding.vertices[v as usize].turn_to(pass + 1));
    }
    Ok(best.expect("there is a first pass"))
}

/// A vertex on its way to doubles.
#[derive(Clone, Copy)]
struct Place {
    /// The nearest doubles.
    nearest: [f64; 3],
    /// In each coordinate the double on the other side of its place; the nearest one where that is its place.
    other: [f64; 3],
    is_moved: bool,
    /// A bit for each coordinate that goes to the other side.
    way: u32,
}

impl Place {
    fn point(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis: usize| if self.way >> axis & 1 == 1 { self.other[axis] } else { self.nearest[axis] })
    }

    /// Takes another way, by a mixture of the number of the pass and the vertex.
    fn turn_to(&mut self, pass: u32) {
        if self.is_moved {
            let bits = self.nearest.iter().fold(u64::from(pass), |sum, x| {
                (sum ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(31)
            });
            self.way = u32::try_from(bits >> 61).expect("three bits");
        }
    }
}

/// The vertices of a limit, its triangles by these, and how each triangle is turned in a coordinate plane.
struct Rounding {
    vertices: Vec<Place>,
    /// The vertex of the limit that each is.
    names: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
    /// For triangles with a moved vertex.
    turns: Vec<Option<(Plane, Sign)>>,
}

/// A rounded mesh over all vertices.
struct Built {
    /// With the place of the triangle that each is, or is a part of.
    triangles: Vec<([u32; 3], u32)>,
    /// For each vertex whether it has moved, or stands for one that has.
    moved: Vec<bool>,
    merged: usize,
    collapsed: usize,
}

impl Rounding {
    fn new(session: &dyn Predicates, named: &[[Vertex; 3]], places: &Places) -> Rounding {
        let scene = session.scene();
        let (mut vertices, mut names) = (Vec::new(), Vec::new());
        let mut of_input = vec![u32::MAX; scene.len()];
        let mut of_constructed = vec![u32::MAX; scene.constructions().len()];
        let mut place = |v: Vertex| {
            let known = match v.construction() {
                None => &mut of_input[v.index()],
                Some(index) => &mut of_constructed[index],
            };
            if *known == u32::MAX {
                *known = number(vertices.len());
                let nearest = places.nearest(scene, v);
                let is_moved = !places.is_exact(v);
                let other = if is_moved { places.beyond(scene, v) } else { nearest };
                names.push(v);
                vertices.push(Place { nearest, other, is_moved, way: 0 });
            }
            *known
        };
        let triangles: Vec<[u32; 3]> = named.iter().map(|triangle| triangle.map(&mut place)).collect();
        let turn = |(named, triangle): (&[Vertex; 3], &[u32; 3])| {
            triangle.iter().any(|&v| vertices[v as usize].is_moved).then(|| {
                let [a, b, c] = *named;
                let planes = by_area(triangle.map(|v| vertices[v as usize].nearest));
                let turns = planes.map(|plane| (plane, session.orient2d(plane, a, b, c)));
                turns.into_iter().find(|(_, turn)| !turn.is_zero()).unwrap_or(turns[0])
            })
        };
        let turns = named.iter().zip(&triangles).map(turn).collect();
        Rounding { vertices, names, triangles, turns }
    }

    fn points(&self) -> Vec<[f64; 3]> {
        self.vertices.iter().map(Place::point).collect()
    }

    /// The mesh of doubles as the vertices are now, without what has no area.
    fn built(&self, session: &dyn Predicates) -> Built {
        // Of vertices at one place the first stands for all; only moved ones have come there.
        let points = self.points();
        let mut order: Vec<u32> = (0..number(points.len())).collect();
        let key = |v: u32| points[v as usize].map(|x| (x + 0.0).to_bits());
        order.sort_unstable_by_key(|&v| (key(v), v));
        let mut stand: Vec<u32> = (0..number(points.len())).collect();
        let mut moved: Vec<bool> = self.vertices.iter().map(|vertex| vertex.is_moved).collect();
        let mut merged = 0;
        for same in order.chunk_by(|&v, &w| key(v) == key(w)) {
            same[1..].iter().for_each(|&v| stand[v as usize] = same[0]);
            moved[same[0] as usize] = same.iter().any(|&v| moved[v as usize]);
            merged += same.len() - 1;
        }
        let mut triangles: Vec<([u32; 3], u32)> =
            (0..).zip(&self.triangles).map(|(place, triangle)| (triangle.map(|v| stand[v as usize]), place)).collect();
        let before = triangles.len();
        triangles.retain(|([a, b, c], _)| a != b && b != c && c != a);
        if merged > 0 {
            cancel(&mut triangles);
        }
        let mut removed = Chain::default();
        triangles.retain(|(triangle, place)| {
            let vertices = triangle.map(|v| Vertex::input(v as usize));
            let [a, b, c] = vertices;
            let is_flat = self.turns[*place as usize].is_some()
                && [Plane::Xy, Plane::Yz, Plane::Zx]
                    .into_iter()
                    .all(|plane| session.orient2d(plane, a, b, c).is_zero());
            if is_flat {
                removed.add(vertices, 1);
            }
            !is_flat
        });
        let collapsed = before - triangles.len();
        let joints = Joints::of(session, &Places::default(), &removed.open());
        if !joints.is_empty() {
            let pieces = triangles.into_iter().flat_map(|(triangle, place)| {
                let divided = joints.divided(triangle.map(|v| Vertex::input(v as usize)));
                let pieces = divided.map_or_else(
                    || vec![triangle],
                    |pieces| pieces.into_iter().map(|piece| piece.map(|v| number(v.index()))).collect(),
                );
                pieces.into_iter().map(move |piece| (piece, place))
            });
            triangles = pieces.collect();
        }
        Built { triangles, moved, merged, collapsed }
    }
}

/// The coordinate planes, those first in which a triangle is largest.
fn by_area([p, q, r]: [[f64; 3]; 3]) -> [Plane; 3] {
    let area = |plane: Plane| {
        let [i, j] = plane.axes().map(Axis::index);
        let difference = |to: [f64; 3], axis: usize| to[axis] / 2.0 - p[axis] / 2.0;
        (difference(q, i) * difference(r, j) - difference(q, j) * difference(r, i)).abs()
    };
    let mut planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    planes.sort_by(|a, b| area(*b).total_cmp(&area(*a)));
    planes
}

/// Removes pairs of opposite triangles.
fn cancel(triangles: &mut Vec<([u32; 3], u32)>) {
    let sorted = |[a, b, c]: [u32; 3]| {
        let mut all = [a, b, c];
        all.sort_unstable();
        (all, [[a, b, c], [b, c, a], [c, a, b]].contains(&all))
    };
    let mut all: Vec<(([u32; 3], bool), usize)> =
        triangles.iter().enumerate().map(|(at, (triangle, _))| (sorted(*triangle), at)).collect();
    all.sort_unstable();
    let mut goes = vec![false; triangles.len()];
    for same in all.chunk_by(|a, b| a.0.0 == b.0.0) {
        let (odd, even) = same.split_at(same.partition_point(|((_, is_even), _)| !is_even));
        for ((_, first), (_, second)) in odd.iter().zip(even) {
            goes[*first] = true;
            goes[*second] = true;
        }
    }
    let mut goes = goes.into_iter();
    triangles.retain(|_| goes.next() == Some(false));
}

/// A mesh over the vertices that it has corners at, and which these are.
fn compact(points: &[[f64; 3]], triangles: &[([u32; 3], u32)]) -> (Closed, Vec<u32>) {
    let mut of = vec![u32::MAX; points.len()];
    let mut kept = Vec::new();
    let triangles = triangles.iter().map(|(triangle, _)| {
        triangle.map(|v| {
            let known = &mut of[v as usize];
            if *known == u32::MAX {
                *known = number(kept.len());
                kept.push(v);
            }
            *known
        })
    });
    let triangles = triangles.collect();
    (Closed { points: kept.iter().map(|&v| points[v as usize]).collect(), triangles }, kept)
}

fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 vertices")
}
