//! Predicates in Rust for the tool `predicament`: a type with a library's predicates, and a `main` of one line.
//!
//! ```text
//! use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};
//!
//! #[derive(Default)]
//! struct Mine;
//!
//! impl Engine for Mine {
//!     const NAME: &'static str = "mine";
//!     const ZERO: Zero = Zero::Exact;
//!     const PREDICATES: &'static [Predicate] = &[Predicate::Orient2d];
//!
//!     fn version() -> String {
//!         locked(include_str!("../Cargo.lock"), "mine")
//!     }
//!
//!     fn orient2d(&self, [a, b, c]: [Vertex<2>; 3]) -> Answer {
//!         mine::orient2d(a.at, b.at, c.at).into()
//!     }
//! }
//!
//! fn main() -> std::process::ExitCode {
//!     serve::<Mine>()
//! }
//! ```
//!
//! An engine may also answer whole [tasks](Task): it lists them in `TASKS` and has a function for each.
//!
//! Signs are those of `docs/ENGINES.md`. If a predicate panics, the answer is `error`, with the query and the text of
//! the panic: the tool counts the scene as a panic and restarts the engine. `stdout.rs` redirects the output of a
//! library.

mod message;
pub mod rings;
mod server;
mod stdout;
mod tasks;

use std::cmp::Ordering;
use std::ops::Neg;
use std::process::ExitCode;

/// The meaning of the engine's zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Zero {
    /// The determinant is zero.
    Exact,
    /// The engine breaks ties, so a zero has no meaning.
    Never,
}

/// The precision to which coordinates are rounded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Precision {
    /// Double precision: coordinates are not rounded.
    F64,
    /// Single precision.
    F32,
}

/// A predicate of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Predicate {
    /// The order of two coordinates.
    Compare,
    /// The turn of three points.
    Orient2d,
    /// The side of the fourth of four points.
    Orient3d,
    /// The position of a fourth point relative to the circle of three.
    Incircle,
    /// The position of a fifth point relative to the sphere of four.
    Insphere,
    /// The turn of three directions, points of a sphere around the origin.
    OrientOnSphere,
}

impl Predicate {
    /// The predicate's name in the protocol.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Predicate::Compare => "compare",
            Predicate::Orient2d => "orient2d",
            Predicate::Orient3d => "orient3d",
            Predicate::Incircle => "incircle",
            Predicate::Insphere => "insphere",
            Predicate::OrientOnSphere => "orient_on_sphere",
        }
    }
}

/// An answer; its number is the byte of the protocol.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Answer {
    /// The sign −1.
    Negative = 255,
    /// The sign 0.
    Zero = 0,
    /// The sign +1.
    Positive = 1,
    /// The engine declines the query, and with it the scene.
    Declined = 2,
    /// The library returned NaN.
    Nan = 3,
}

impl From<Ordering> for Answer {
    fn from(order: Ordering) -> Answer {
        match order {
            Ordering::Less => Answer::Negative,
            Ordering::Equal => Answer::Zero,
            Ordering::Greater => Answer::Positive,
        }
    }
}

impl From<f64> for Answer {
    /// The sign of a determinant; `Nan` for NaN.
    fn from(determinant: f64) -> Answer {
        determinant.partial_cmp(&0.0).map_or(Answer::Nan, Answer::from)
    }
}

impl Neg for Answer {
    type Output = Answer;

    fn neg(self) -> Answer {
        match self {
            Answer::Negative => Answer::Positive,
            Answer::Positive => Answer::Negative,
            other => other,
        }
    }
}

/// A vertex of the scene: its coordinates and its id.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Vertex<const D: usize> {
    /// The coordinates.
    pub at: [f64; D],
    /// The vertex number, counted from 0.
    pub id: u32,
}

/// All points that predicates receive, by the ids of their vertices.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Points<'p> {
    /// The points of a scene in the plane, or of a scene in space, projected.
    Plane(&'p [[f64; 2]]),
    /// The points of a scene in space.
    Space(&'p [[f64; 3]]),
}

/// A task that an engine answers as a whole. The function of the same name in [`Engine`] answers it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Task {
    /// Delaunay triangulations.
    Delaunay2d,
    /// Convex hulls in the plane.
    Hull2d,
    /// Convex hulls in space.
    Hull3d,
    /// Triangulations of polygons.
    Triangulate,
    /// Boolean operations on polygons.
    Overlay2d,
    /// Points in the regions of a map.
    PolygonLocate,
    /// Points in solids.
    MeshLocate,
    /// Lines, rays or segments against a mesh.
    MeshRays,
    /// The distance of two polygons or meshes.
    Distance,
    /// Boolean operations on solids.
    MeshIntersect,
    /// Simplices in the plane that meet.
    Contacts2d,
    /// Simplices in space that meet.
    Contacts3d,
    /// Crossings of segments.
    Crossings,
    /// Numbers in the cells of a line.
    Interval,
    /// The measures of a union of cubes.
    CubeUnion,
    /// Cuts of a solid by planes.
    Slice,
    /// Segments rounded to a grid.
    Snap2d,
}

impl Task {
    /// The task's name in the protocol.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Task::Delaunay2d => "delaunay2d",
            Task::Hull2d => "hull2d",
            Task::Hull3d => "hull3d",
            Task::Triangulate => "triangulate",
            Task::Overlay2d => "overlay2d",
            Task::PolygonLocate => "polygon-locate",
            Task::MeshLocate => "mesh-locate",
            Task::MeshRays => "mesh-rays",
            Task::Distance => "distance",
            Task::MeshIntersect => "mesh-intersect",
            Task::Contacts2d => "contacts2d",
            Task::Contacts3d => "contacts3d",
            Task::Crossings => "crossings",
            Task::Interval => "interval",
            Task::CubeUnion => "cube-union",
            Task::Slice => "slice",
            Task::Snap2d => "snap2d",
        }
    }
}

/// The rings of a polygon; in results the outer one is first.
pub type Polygon = Vec<Vec<[f64; 2]>>;

/// A triangle mesh with its own vertices.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<[f64; 3]>,
    /// The triangles, by indices of vertices.
    pub triangles: Vec<[u32; 3]>,
}

/// The largest simplices of a complex, each with the indices of its points.
pub type Simplices = Vec<Vec<u32>>;

/// A segment of the plane.
pub type Segment = [[f64; 2]; 2];

/// A line, a ray or a segment in space, by two points.
pub type Ray = [[f64; 3]; 2];

/// The measures of a union of cubes.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Measures {
    /// The volume.
    pub volume: f64,
    /// The area of the surface.
    pub area: f64,
    /// The length of the edges; `None` if the library lacks it.
    pub edge_length: Option<f64>,
}

/// The results of Boolean operations; `None` for operations that the library lacks.
#[derive(Clone, PartialEq, Debug)]
pub struct Results<T> {
    /// The points in either operand.
    pub union: Option<T>,
    /// The points in both operands.
    pub intersection: Option<T>,
    /// The points in the first operand alone.
    pub difference: Option<T>,
    /// The points in exactly one operand.
    pub symmetric_difference: Option<T>,
}

/// The reason for declining a task: [`Engine::TASKS`] lists it, but its function is not written.
fn not_written<R>() -> Result<R, String> {
    Err("the engine lists a task that it does not answer".to_owned())
}

/// A library's predicates and tasks in the tool's conventions.
///
/// A function of a task returns the reason if a scene is not for the library.
pub trait Engine: Default {
    /// The engine's name in the answer to `hello`.
    const NAME: &'static str;
    /// The meaning of zero.
    const ZERO: Zero = Zero::Exact;
    /// The predicates that the engine has; others are declined.
    const PREDICATES: &'static [Predicate] = &[];
    /// The tasks that the engine answers as a whole.
    const TASKS: &'static [Task] = &[];
    /// The precision to which coordinates are rounded.
    const PRECISION: Precision = Precision::F64;
    /// True if orient2d in the zx plane receives (x, z), and the answer is negated. A perturbation that moves a point's
    /// coordinates in their order needs this, since the library itself would project in that order.
    const IN_ORDER: bool = false;

    /// The version of the library, on one line.
    fn version() -> String;

    /// Receives the points before the first batch of a scene, outside of the measured time, and again whenever
    /// predicates get other points: orient2d in a plane of a scene in space gets projected points. Ids stay the same.
    ///
    /// # Errors
    /// The reason why the scene is not for this engine.
    fn prepare(&mut self, points: Points<'_>) -> Result<(), String> {
        let _ = points;
        Ok(())
    }

    /// The order of two coordinates; `axis` is 0, 1 or 2.
    fn compare(&self, axis: usize, points: [Vertex<1>; 2]) -> Answer {
        let _ = (axis, points);
        Answer::Declined
    }

    /// The turn of three points, positive if counterclockwise.
    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The side of the fourth point, positive if it is below the plane of the others, which are counterclockwise from
    /// above.
    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The position of the fourth point, positive if it is inside the circle of the others, which turn
    /// counterclockwise.
    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The position of the fifth point, positive if it is inside the sphere of the others, which have a positive
    /// orient3d.
    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The turn of three directions from the origin, positive if it is counterclockwise from outside.
    fn orient_on_sphere(&self, points: [Vertex<3>; 3]) -> Answer {
        let _ = points;
        Answer::Declined
    }

    /// The triangles of a Delaunay triangulation. Constraints are pairs of points.
    fn delaunay2d(&self, points: &[[f64; 2]], constraints: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
        let _ = (points, constraints);
        not_written()
    }

    /// The corners of the convex hull, one after the other.
    fn hull2d(&self, points: &[[f64; 2]]) -> Result<Vec<u32>, String> {
        let _ = points;
        not_written()
    }

    /// The triangles of the convex hull's surface.
    fn hull3d(&self, points: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, String> {
        let _ = points;
        not_written()
    }

    /// The triangles of one polygon, which has rings of indices in any order.
    fn triangulate(&self, points: &[[f64; 2]], rings: &[Vec<u32>]) -> Result<Vec<[u32; 3]>, String> {
        let _ = (points, rings);
        not_written()
    }

    /// Boolean operations on the rings of two operands. `even_odd` is false for the rule of nonzero winding numbers.
    fn overlay2d(&self, first: &Polygon, second: &Polygon, even_odd: bool) -> Result<Results<Vec<Polygon>>, String> {
        let _ = (first, second, even_odd);
        not_written()
    }

    /// For each probe the number of its region, −1 outside, −2 on a border.
    fn polygon_locate(&self, regions: &[Polygon], probes: &[[f64; 2]]) -> Result<Vec<i64>, String> {
        let _ = (regions, probes);
        not_written()
    }

    /// For each probe 1 inside, 0 outside, −2 on the surface.
    fn mesh_locate(&self, mesh: &Mesh, probes: &[[f64; 3]]) -> Result<Vec<i64>, String> {
        let _ = (mesh, probes);
        not_written()
    }

    /// For each ray the triangles that it hits, in their order along it. `extent` is "line", "ray" or "segment".
    fn mesh_rays(&self, mesh: &Mesh, rays: &[Ray], extent: &str) -> Result<Vec<Vec<u32>>, String> {
        let _ = (mesh, rays, extent);
        not_written()
    }

    /// The distance of two objects, zero if they have a common point. Objects are solids: loops of points in the plane,
    /// where z is 0, or triangles in space. `dimension` is 2 or 3.
    fn distance(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices, dimension: usize) -> Result<f64, String> {
        let _ = (points, a, b, dimension);
        not_written()
    }

    /// Boolean operations on two solids.
    fn mesh_intersect(&self, first: &Mesh, second: &Mesh) -> Result<Results<Mesh>, String> {
        let _ = (first, second);
        not_written()
    }

    /// The pairs of simplices that meet: the indices of one of `a`, and those of one of `b`.
    fn contacts2d(&self, points: &[[f64; 2]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        let _ = (points, a, b);
        not_written()
    }

    /// The pairs of simplices that meet, in space.
    fn contacts3d(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices) -> Result<Vec<[Vec<u32>; 2]>, String> {
        let _ = (points, a, b);
        not_written()
    }

    /// For each segment the numbers of those that cross it, in their order from its first end on.
    fn crossings(&self, segments: &[Segment]) -> Result<Vec<Vec<u32>>, String> {
        let _ = segments;
        not_written()
    }

    /// For each probe the number of its cell, −1 outside, −2 at an end of a cell.
    fn interval(&self, cells: &[[f64; 2]], probes: &[f64]) -> Result<Vec<i64>, String> {
        let _ = (cells, probes);
        not_written()
    }

    /// The measures of a union of cubes. A cube has x, y and z of its lower corner and the length of its edges.
    fn cube_union(&self, cubes: &[[f64; 4]]) -> Result<Measures, String> {
        let _ = cubes;
        not_written()
    }

    /// The parts of a closed mesh that is cut by planes, each part on one side of each plane. A plane is three points.
    fn slice(&self, mesh: &Mesh, planes: &[[[f64; 3]; 3]]) -> Result<Vec<Mesh>, String> {
        let _ = (mesh, planes);
        not_written()
    }

    /// For each segment a polyline from its first end to its second, with coordinates that are multiples of `side`.
    fn snap2d(&self, segments: &[Segment], side: f64) -> Result<Vec<Vec<[f64; 2]>>, String> {
        let _ = (segments, side);
        not_written()
    }
}

/// The points sorted by id, and true if the permutation is odd; `None` if a vertex occurs twice.
#[must_use]
pub fn by_id<const D: usize, const N: usize>(mut points: [Vertex<D>; N]) -> Option<([Vertex<D>; N], bool)> {
    let mut odd = false;
    for end in (1..N).rev() {
        for at in 0..end {
            if points[at].id > points[at + 1].id {
                points.swap(at, at + 1);
                odd = !odd;
            }
        }
    }
    let twice = points.windows(2).any(|pair| pair[0].id == pair[1].id);
    (!twice).then_some((points, odd))
}

/// The version of a package in a Cargo lock file.
#[must_use]
pub fn locked(lock: &str, package: &str) -> String {
    let name = format!("name = \"{package}\"");
    let version = lock.lines().skip_while(|line| *line != name).nth(1);
    version.and_then(|line| line.split('"').nth(1)).unwrap_or("unknown").to_owned()
}

/// Answers the tool until stdin ends; with `--version`, prints the version of the library.
pub fn serve<E: Engine>() -> ExitCode {
    match server::main::<E>(std::env::args().skip(1).collect()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_numbers_and_orders() {
        assert_eq!([-1e-300, -0.0, 5.0, f64::NAN].map(Answer::from).map(|answer| answer as u8), [255, 0, 1, 3]);
        assert_eq!(Answer::from(1.cmp(&2)), Answer::Negative);
        assert_eq!([Answer::Positive, Answer::Zero, Answer::Nan].map(Neg::neg), {
            [Answer::Negative, Answer::Zero, Answer::Nan]
        });
    }

    #[test]
    fn vertices_are_sorted_with_their_parity() {
        let at = |ids: [u32; 4]| by_id(ids.map(|id| Vertex { at: [f64::from(id)], id }));
        let ids = |ids| at(ids).map(|(points, odd)| (points.map(|point| point.id), odd));
        assert_eq!(ids([0, 1, 2, 3]), Some(([0, 1, 2, 3], false)));
        assert_eq!(ids([3, 1, 2, 0]), Some(([0, 1, 2, 3], true)));
        assert_eq!(ids([7, 9, 2, 4]), Some(([2, 4, 7, 9], false)));
        assert_eq!(ids([7, 9, 2, 7]), None);
    }

    #[test]
    fn versions_are_read_from_a_lock_file() {
        let lock =
            "[[package]]\nname = \"ab\"\nversion = \"2.0.0\"\n\n[[package]]\nname = \"a\"\nversion = \"1.2.3\"\n";
        assert_eq!(locked(lock, "a"), "1.2.3");
        assert_eq!(locked(lock, "b"), "unknown");
    }
}
