//! The contacts of two complexes, as a backend registers them.
//!
//! Parity and resolution are about contacts. How a backend is asked for them
//! is the oracle's business, and is written here only.

use predicament_algorithms::contacts::Contacts;
use predicament_mesh::Complex;
use predicament_oracle::Contestant;
use predicament_predicates::Scene;

/// All contacts of two complexes of a scene, which has to know the lengths of their primitives.
///
/// # Errors
/// The reason, where the backend declines.
pub(crate) fn contacts(backend: &dyn Contestant, scene: &Scene, complexes: [&Complex; 2]) -> Result<Contacts, String> {
    backend.contacts(scene, complexes)
}
