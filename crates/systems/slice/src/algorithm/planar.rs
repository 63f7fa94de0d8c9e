//! Faces that are planar for the session; others are divided into triangles.
//!
//! A planar polygon is not planar once its vertices have moved, and its edges do not meet a line of its plane. A
//! session that breaks ties shows it: for some vertex of the polygon it does not return zero.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{Face, IndexedFaces};
use predicament_predicates::{Predicates, Sign, Vertex};

use super::projection::seen;
use super::{Contradiction, Halt};
use predicament_triangulate::algorithm::{Method, triangulate};

/// Faces for [`Cutter`](super::cutter::Cutter).
pub(super) struct Planar {
    pub(super) mesh: HalfEdgeMesh,
    /// For each face, three vertices of its plane.
    pub(super) supports: Vec<[Vertex; 3]>,
    /// For each face, the face of the input that it is a piece of.
    pub(super) faces: Vec<u32>,
}

impl Planar {
    /// Returns the mesh, with each polygon that is not planar for the session divided into triangles.
    pub(super) fn new(session: &dyn Predicates, mesh: HalfEdgeMesh, supports: &[[Vertex; 3]]) -> Result<Planar, Halt> {
        let mut is_plane = Vec::with_capacity(supports.len());
        for (f, &support) in mesh.faces().zip(supports) {
            is_plane.push(is_plane_for(session, &corners(&mesh, f), support));
        }
        let own = 0..u32::try_from(supports.len()).unwrap_or(u32::MAX);
        if is_plane.iter().all(|&plane| plane) {
            return Ok(Planar { mesh, supports: supports.to_vec(), faces: own.collect() });
        }
        let (vertices, indexed) = mesh.to_indexed();
        let (mut faces, mut all, mut of) = (IndexedFaces::default(), Vec::new(), Vec::new());
        for ((((f, corners_in), &support), is_plane), face) in
            mesh.faces().zip(indexed.iter()).zip(supports).zip(is_plane).zip(own)
        {
            if is_plane {
                faces.push(corners_in.iter().copied());
                all.push(support);
                of.push(face);
                continue;
            }
            let (plane, reversed) = seen(session, support).ok_or(Halt::Broken(Contradiction::NoArea))?;
            let around = corners(&mesh, f);
            let made = triangulate(session, plane, reversed, std::slice::from_ref(&around), Method::Monotone);
            if let Some(what) = made.broken {
                return Err(Halt::Broken(what.into()));
            }
            for triangle in made.triangles {
                // The face begins at the start of its half-edge, this list at the end.
                let place = |v: Vertex| around.iter().position(|&w| w == v).map_or(0, |at| (at + 1) % around.len());
                faces.push(triangle.map(|v| corners_in[place(v)]));
                all.push(triangle);
                of.push(face);
            }
        }
        let mesh = HalfEdgeMesh::new(vertices, &faces);
        let mesh = mesh.map_err(|_| Halt::Broken(Contradiction::Joined))?;
        Ok(Planar { mesh, supports: all, faces: of })
    }
}

/// The vertices of a face.
fn corners(mesh: &HalfEdgeMesh, f: Face) -> Vec<Vertex> {
    mesh.vertex_loop(mesh.half_edge_of_face(f)).map(|v| mesh.scene_vertex(v)).collect()
}

fn is_plane_for(session: &dyn Predicates, corners: &[Vertex], support: [Vertex; 3]) -> bool {
    if corners.len() == 3 {
        return true;
    }
    let mut signs = vec![Sign::Zero; corners.len()];
    session.orient3d_plane(support, corners, &mut signs);
    signs.iter().all(|sign| sign.is_zero())
}
