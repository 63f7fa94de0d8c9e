//! The crate `parry3d-f64`: convex hulls, whose points are matched with those of the scene by their coordinates, and points
//! in closed meshes.

use std::collections::HashMap;

use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::{TriMesh, TriMeshFlags};
use parry3d_f64::transformation::try_convex_hull;
use predicament_engine::{Engine, Mesh, Task, locked, serve};

#[derive(Default)]
struct Parry;

impl Engine for Parry {
    const NAME: &'static str = "parry";
    const TASKS: &'static [Task] = &[Task::Hull3d, Task::MeshLocate];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "parry3d-f64")
    }

    fn hull3d(&self, points: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, String> {
        let bits = |[x, y, z]: [f64; 3]| [x, y, z].map(|x| (x + 0.0).to_bits());
        let ids: HashMap<[u64; 3], u32> = points.iter().copied().map(bits).zip(0..).collect();
        let points: Vec<Vector> = points.iter().copied().map(vector).collect();
        let (corners, triangles) = try_convex_hull(&points).map_err(|error| format!("parry: {error}"))?;
        let id = |at: u32| {
            let [x, y, z] = corners[at as usize].into();
            ids.get(&bits([x, y, z])).copied().ok_or("parry moves a point of the hull")
        };
        let triangle = |[a, b, c]: [u32; 3]| Ok([id(a)?, id(b)?, id(c)?]);
        triangles.into_iter().map(triangle).collect::<Result<_, &str>>().map_err(str::to_owned)
    }

    fn mesh_locate(&self, mesh: &Mesh, probes: &[[f64; 3]]) -> Result<Vec<i64>, String> {
        let vertices = mesh.vertices.iter().copied().map(vector).collect();
        let made = TriMesh::with_flags(vertices, mesh.triangles.clone(), TriMeshFlags::ORIENTED);
        let made = made.map_err(|error| format!("parry: {error}"))?;
        Ok(probes.iter().map(|&probe| i64::from(made.contains_local_point(vector(probe)))).collect())
    }
}

fn vector([x, y, z]: [f64; 3]) -> Vector {
    Vector::new(x, y, z)
}

fn main() -> std::process::ExitCode {
    serve::<Parry>()
}
