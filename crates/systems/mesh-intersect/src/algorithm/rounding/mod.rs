//! Rounding of operation results to meshes of doubles.
//!
//! A constructed vertex is rounded to the nearest double in each coordinate. That moves it by up to half an ulp, and a
//! thin triangle may collapse, turn over, or pass through another one. The flaws of a result are counted, and mended if
//! other roundings help.
//!
//! # Steps
//! 1. Vertices at one position are merged. Triangles with a vertex twice are removed, and so are pairs of opposite
//!    triangles and flat triangles: their neighbours are divided at vertices on their edges.
//! 2. Triangles with moved vertices are tested, exactly: for reversal (`turned`), for lying on a neighbour (`folded`),
//!    and for passing through or touching a triangle without a common vertex (`crossing`): see `flaws.rs`.
//! 3. Vertices of such triangles move to other doubles beside their exact position, and everything is tested again, at
//!    most [`PASSES`] times. The first rounding with the fewest flaws stays.
//!
//! # What is guaranteed
//! The result is closed and has no triangle without area. If no flaw is left, its triangles meet in common vertices and
//! edges only, or where they met before and none of them has a moved vertex. Then no triangle is reversed, and each
//! vertex is within one ulp of its exact position in each coordinate. It is not guaranteed that no flaws stay: for
//! that, vertices would have to move farther (Valque, *Iterated snap rounding in space*), or triangles be divided.

pub mod flaws;

use predicament_mesh::{MaterialError, MaterialMesh};
use predicament_predicates::{Axis, Declined, Plane, Predicates, Scene, SceneError, Sign, Vertex};

use self::flaws::Flaws;
use crate::algorithm::limit::chain::Chain;
use crate::algorithm::limit::joints::Joints;
use crate::algorithm::limit::{Limit, Places};
use crate::algorithm::sessions::{Sessions, with};

/// The maximum number of roundings that are tried.
pub const PASSES: u32 = 8;

/// A closed mesh of doubles: an empty one is empty space.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Closed {
    /// The vertices, each of them a corner.
    pub points: Vec<[f64; 3]>,
    /// The triangles, counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Closed {
    /// Checks that the mesh is closed, and that each triangle has three existing vertices. An empty mesh is valid.
    ///
    /// # Errors
    /// The first invalid triangle, otherwise the first invalid edge.
    pub fn check(&self) -> Result<(), MaterialError> {
        if self.triangles.is_empty() {
            return Ok(());
        }
        let vertex = |v: u32| Vertex::input(v as usize);
        let triangles = self.triangles.iter().map(|triangle| triangle.map(vertex)).collect();
        MaterialMesh::of_closed(self.points.len(), triangles).map(|_| ())
    }
}

/// Statistics of rounding.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Counts {
    /// Constructed vertices that are not doubles.
    pub moved: usize,
    /// Vertices merged with another one.
    pub merged: usize,
    /// Triangles that have collapsed.
    pub collapsed: usize,
    /// Triangles that are reversed if all vertices go to the nearest doubles.
    pub turned: usize,
    /// Pairs of triangles with a common edge in which one triangle then lies on the other.
    pub folded: usize,
    /// Other pairs of triangles that then pass through each other.
    pub crossing: usize,
    /// Vertices rounded to other doubles than the nearest, to reduce these flaws.
    pub mended: usize,
    /// The flaws that remain.
    pub left: usize,
}

/// A limit, rounded to doubles.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Rounded {
    /// The mesh.
    pub closed: Closed,
    /// For each point, the vertex of the limit that it rounds.
    pub vertices: Vec<Vertex>,
    /// For each point, true if a vertex has moved there.
    pub moved: Vec<bool>,
    /// Statistics of rounding.
    pub counts: Counts,
}

/// The reason why there is no result.
#[derive(Clone, PartialEq, Debug)]
pub enum NotRounded {
    /// There are too many vertices.
    Scene(SceneError),
    /// The backend declines the scene.
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

/// Rounds the limit of a result to doubles. The session is the one of the limit; `exact` is the backend with exact
/// zeros.
///
/// # Errors
/// [`NotRounded`], if the rounded mesh is not a scene that the backend accepts.
pub fn rounded(exact: &dyn Sessions, session: &dyn Predicates, limit: &Limit) -> Result<Rounded, NotRounded> {
    of_triangles(exact, session, (&limit.solid.triangles, &limit.places), PASSES)
}

/// Rounds a closed surface to doubles, with a maximum number of tries.
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

/// A vertex and its candidate roundings.
#[derive(Clone, Copy)]
struct Place {
    /// The nearest doubles.
    nearest: [f64; 3],
    /// In each coordinate, the double on the other side of the exact position; the nearest double if it is exact.
    other: [f64; 3],
    is_moved: bool,
    /// A bit for each coordinate that is rounded to the other side.
    way: u32,
}

impl Place {
    fn point(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis: usize| if self.way >> axis & 1 == 1 { self.other[axis] } else { self.nearest[axis] })
    }

    /// Chooses another rounding, by a hash of the pass and the vertex.
    fn turn_to(&mut self, pass: u32) {
        if self.is_moved {
            let bits = self.nearest.iter().fold(u64::from(pass), |sum, x| {
                (sum ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(31)
            });
            self.way = u32::try_from(bits >> 61).expect("three bits");
        }
    }
}

/// The vertices of a limit, its triangles by these, and the turn of each triangle in a coordinate plane.
struct Rounding {
    vertices: Vec<Place>,
    /// The vertex of the limit for each vertex here.
    names: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
    /// The turns of triangles with a moved vertex.
    turns: Vec<Option<(Plane, Sign)>>,
}

/// A rounded mesh over all vertices.
struct Built {
    /// The triangles, each with the index of its source.
    triangles: Vec<([u32; 3], u32)>,
    /// For each vertex, true if it has moved, or represents one that has.
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

    /// The mesh of doubles with the current roundings, without triangles that have no area.
    fn built(&self, session: &dyn Predicates) -> Built {
        // Vertices at one position are replaced by the first; only moved ones can newly coincide.
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

/// The coordinate planes, sorted by a triangle's area, largest first.
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

/// A mesh of the vertices that are corners, and the indices of these.
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
