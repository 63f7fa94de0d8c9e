//! The crate `spade`. Points that coincide are one vertex for it. It refuses coordinates out of its range, and constraints
//! that conflict with each other or have no length: such scenes are declined.

use predicament_engine::{Engine, Task, locked, serve};
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// A point with its index.
struct Site(Point2<f64>, u32);

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.0
    }
}

#[derive(Default)]
struct Spade;

impl Engine for Spade {
    const NAME: &'static str = "spade";
    const TASKS: &'static [Task] = &[Task::Delaunay2d];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "spade")
    }

    fn delaunay2d(&self, points: &[[f64; 2]], constraints: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
        let sites = (0..).zip(points).map(|(id, &[x, y])| Site(Point2::new(x, y), id)).collect();
        let edges = constraints.iter().map(|edge| edge.map(|id| id as usize)).collect();
        let mut conflicts = 0;
        let made = ConstrainedDelaunayTriangulation::<Site>::try_bulk_load_cdt(sites, edges, |_| conflicts += 1);
        let made = made.map_err(|error| format!("spade: {error}"))?;
        if conflicts > 0 {
            return Err(format!("spade: {conflicts} constraints conflict"));
        }
        Ok(made.inner_faces().map(|face| face.vertices().map(|vertex| vertex.data().1)).collect())
    }
}

fn main() -> std::process::ExitCode {
    serve::<Spade>()
}
