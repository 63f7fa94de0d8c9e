//! Overlay in the way that a session's zeros ask for.

use std::sync::Arc;

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Predicates, Question};

use super::{MeshOverlay, Registered, Step, Undone, Zeros, mesh_overlay_by_steps, mesh_overlay_registered};

/// Overlays two meshes in the way that suits the session, and reports the end of each step.
///
/// * If zeros are bands, registered contacts decide passages, because the hierarchy of contacts interprets the bands
///   ([`mesh_overlay_registered`]). Then the positions of the constructed vertices are returned too.
/// * If the signs are those of floating-point determinants, a zero counts as positive, because it says nothing
///   ([`Zeros::Positive`]).
/// * Otherwise a zero is a zero ([`Zeros::Zero`]).
///
/// # Errors
/// [`Undone`], as the three functions say.
pub fn mesh_overlay_as_answered(
    session: &mut dyn Predicates,
    meshes: [Arc<MaterialMesh>; 2],
    done: &mut dyn FnMut(Step),
) -> Result<(MeshOverlay, Option<Registered>), Undone> {
    let question = Question::Orient3d;
    if session.band(question).is_some() {
        return mesh_overlay_registered(session, meshes, done).map(|(overlay, registered)| (overlay, Some(registered)));
    }
    let [first, second] = meshes.each_ref().map(|mesh| mesh.triangles().first());
    let is_rounded = match (first, second) {
        (Some(&[a, b, c]), Some(&[d, ..])) => session.estimate(question, &[a, b, c, d]).is_some(),
        _ => false,
    };
    let zeros = if is_rounded { Zeros::Positive } else { Zeros::Zero };
    mesh_overlay_by_steps(session, meshes, zeros, done).map(|overlay| (overlay, None))
}
