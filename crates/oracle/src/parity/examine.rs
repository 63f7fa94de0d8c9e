//! What a backend's registrations make of two polygons.

use predicament_algorithms::arrangement::Arrangement;
use predicament_algorithms::contacts::{Contacts, contacts};
use predicament_checks::contacts::{Cluster, Collapse, Crossings, Seat, clusters, collapses, crossings};
use predicament_predicates::{Backend, Declined, Off, Predicates};

use super::PolygonPair;

/// Two polygons, merged.
#[derive(Clone, PartialEq, Debug)]
pub struct Examined {
    /// What was registered.
    pub contacts: Contacts,
    /// The crossings after merging, for each of [`Seat::ALL`].
    pub crossings: [Crossings; 3],
    /// Vertices of one polygon that became one.
    pub clusters: Vec<Cluster>,
    /// Edges that became a point.
    pub collapses: Vec<Collapse>,
}

impl Examined {
    /// The crossings under one rule.
    #[must_use]
    pub fn crossings(&self, seat: Seat) -> &Crossings {
        let place = Seat::ALL.iter().position(|&other| other == seat).expect("all seats are listed");
        &self.crossings[place]
    }
}

/// Registers the contacts of two polygons with this backend, merges them, and
/// counts.
///
/// # Errors
/// [`Declined`] if the backend can't take the scene.
pub fn examine<B: Backend>(backend: &B, pair: &PolygonPair) -> Result<Examined, Declined> {
    let (scene, complexes) = pair.scene();
    let session = backend.prepare(&scene, Off)?;
    session.supports_contacts()?;
    let complexes = complexes.each_ref();
    let contacts = contacts(&session, complexes[0], complexes[1]);
    let arrangement = Arrangement::new(complexes, &contacts);
    let count = |seat| crossings(&scene, complexes, &contacts, &arrangement, seat).expect("polygons are closed");
    Ok(Examined {
        crossings: Seat::ALL.map(count),
        clusters: clusters(&arrangement, &contacts),
        collapses: collapses(&arrangement, complexes),
        contacts,
    })
}
