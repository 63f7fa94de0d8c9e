//! Faces that would turn over.
//!
//! A face turns over if its normals before and after the step make an angle of 90° or more: then the sign of their
//! scalar product, a polynomial of degree 4 in the coordinates, is not positive. The sign is zero for a face without
//! area, too. A face without area has no normal and may stay without area, but it may not get a normal: the new normal
//! could be either of two.
//!
//! A perturbed session has no zeros: its faces all have normals, and keep them in the perturbed scene.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::MeshVertex;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use crate::answer::same_facing;

/// The first face that turns over if a vertex moves into another one: its other two corners, and the sign.
pub(super) fn turned<P: Predicates + ?Sized>(
    session: &P,
    mesh: &HalfEdgeMesh,
    gone: MeshVertex,
    kept: MeshVertex,
) -> Option<([Vertex; 2], Sign)> {
    let [u, v] = [gone, kept].map(|v| mesh.scene_vertex(v));
    mesh.ring(gone).find_map(|h| {
        mesh.face(h)?;
        let corners = [mesh.end(mesh.next(h)), mesh.start(h)];
        if corners.contains(&kept) {
            return None;
        }
        let base @ [b, c] = corners.map(|v| mesh.scene_vertex(v));
        let sign = session.sign(same_facing(), &[u, v, b, c]);
        let is_kept = match sign {
            Sign::Positive => true,
            Sign::Zero => [u, v].into_iter().all(|apex| is_flat(session, [apex, b, c])),
            Sign::Negative => false,
        };
        (!is_kept).then_some((base, sign))
    })
}

/// True if a triangle has no area: its corners are on a line in all three projections.
fn is_flat<P: Predicates + ?Sized>(session: &P, [a, b, c]: [Vertex; 3]) -> bool {
    [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().all(|plane| session.orient2d(plane, a, b, c) == Sign::Zero)
}
