//! Contacts of a mesh with itself, which the table of cases does not have.

use predicament_mesh::MaterialMesh;
use predicament_predicates::Predicates;

use super::stands::Stands;
use crate::algorithm::overlay::near::number;
use crate::algorithm::rounding::flaws::pairs;

/// The first pair of triangles of a mesh that have more in common than whole edges and corners; vertices at one
/// position count as one.
pub(super) fn pair(session: &dyn Predicates, mesh: &MaterialMesh, stands: &Stands) -> Option<[u32; 2]> {
    let corners = |at: usize| mesh.triangles()[at].map(|v| number(stands.of(v).index()));
    let found = pairs(session, mesh.triangles().len(), &corners, &|_| true);
    found.into_iter().map(|([a, b], _)| [a.min(b), a.max(b)]).min()
}
