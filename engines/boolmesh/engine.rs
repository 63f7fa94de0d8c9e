//! The crate `boolmesh`. It refuses meshes that are not closed manifolds: the scene is declined.

use boolmesh::prelude::*;
use predicament_engine::{Engine, Mesh, Results, Task, locked, serve};

/// The crate's error for a result without points.
const EMPTY: &str = "empty pos matrix";

#[derive(Default)]
struct Booleans;

impl Engine for Booleans {
    const NAME: &'static str = "boolmesh";
    const TASKS: &'static [Task] = &[Task::MeshIntersect];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "boolmesh")
    }

    fn mesh_intersect(&self, first: &Mesh, second: &Mesh) -> Result<Results<Mesh>, String> {
        let [a, b] = [solid(first)?, solid(second)?];
        let result = |operation| match compute_boolean(&a, &b, operation) {
            Ok(made) => Ok(Some(mesh(&made))),
            Err(error) if error == EMPTY => Ok(Some(Mesh::default())),
            Err(error) => Err(error),
        };
        Ok(Results {
            union: result(OpType::Add)?,
            intersection: result(OpType::Intersect)?,
            difference: result(OpType::Subtract)?,
            symmetric_difference: None,
        })
    }
}

fn solid(mesh: &Mesh) -> Result<Manifold<f64>, String> {
    let corners: Vec<usize> = mesh.triangles.as_flattened().iter().map(|&id| id as usize).collect();
    Manifold::new(mesh.vertices.as_flattened(), &corners)
}

fn mesh(made: &Manifold<f64>) -> Mesh {
    let corners: Vec<u32> = made.hs.iter().map(|half| half.tail as u32).collect();
    Mesh { vertices: made.ps.iter().map(|p| [p.x, p.y, p.z]).collect(), triangles: corners.as_chunks().0.to_vec() }
}

fn main() -> std::process::ExitCode {
    serve::<Booleans>()
}
