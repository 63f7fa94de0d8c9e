//! The crate `parry3d-f64`: distances of meshes, which are surfaces: a mesh inside another one is apart from it.

use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::TriMesh;
use predicament_engine::{Engine, Simplices, Task, locked, serve};

#[derive(Default)]
struct Parry;

impl Engine for Parry {
    const NAME: &'static str = "parry-distances";
    const TASKS: &'static [Task] = &[Task::Distance];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "parry3d-f64")
    }

    fn distance(&self, points: &[[f64; 3]], a: &Simplices, b: &Simplices, dimension: usize) -> Result<f64, String> {
        if dimension == 2 {
            return Err("parry3d measures meshes, and no polygons".to_owned());
        }
        let told = |error: &dyn std::fmt::Display| format!("parry: {error}");
        let mesh = |parts: &Simplices| {
            let vertices = points.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect();
            let triangles = parts.iter().map(|part| [part[0], part[1], part[2]]).collect();
            TriMesh::new(vertices, triangles).map_err(|error| told(&error))
        };
        let at = Pose::default();
        let found = query::distance(&at, &mesh(a)?, &at, &mesh(b)?).map_err(|error| told(&error))?;
        Ok(found.distance)
    }
}

fn main() -> std::process::ExitCode {
    serve::<Parry>()
}
