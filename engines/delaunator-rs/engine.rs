//! The crate `delaunator`.

use delaunator::{Point, triangulate};
use predicament_engine::{Engine, Task, locked, serve};

#[derive(Default)]
struct Delaunator;

impl Engine for Delaunator {
    const NAME: &'static str = "delaunator-rs";
    const TASKS: &'static [Task] = &[Task::Delaunay2d];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "delaunator")
    }

    fn delaunay2d(&self, points: &[[f64; 2]], constraints: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
        if !constraints.is_empty() {
            return Err("delaunator has no constraints".to_owned());
        }
        let points: Vec<Point> = points.iter().map(|&[x, y]| Point { x, y }).collect();
        let corners = triangulate(&points).triangles;
        Ok(corners.as_chunks().0.iter().map(|triangle| triangle.map(|id| id as u32)).collect())
    }
}

fn main() -> std::process::ExitCode {
    serve::<Delaunator>()
}
