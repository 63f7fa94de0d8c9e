//! Two polygons merged by the contacts that a backend registers.

use predicament_contacts::algorithm::arrangement::Arrangement;
use predicament_contacts::algorithm::pairs::Contacts;
use predicament_contacts::checks::pairs::{Cluster, Collapse, Crossings, Seat, clusters, collapses, crossings};
use predicament_tasks::{AnswerError, Contestant};

use super::PolygonPair;
use crate::contacts::contacts;

/// The results of merging two polygons.
#[derive(Clone, PartialEq, Debug)]
pub struct Examined {
    /// The registered pairs.
    pub contacts: Contacts,
    /// The crossings after merging, for each of [`Seat::ALL`].
    pub crossings: [Crossings; 3],
    /// The clusters: vertices of one polygon that became one.
    pub clusters: Vec<Cluster>,
    /// The edges that became a point.
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

/// Registers the contacts of two polygons with this backend, merges them, and counts crossings.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
///
/// # Panics
/// Never: polygons are closed.
pub fn examine(backend: &dyn Contestant, pair: &PolygonPair) -> Result<Examined, AnswerError> {
    let (scene, complexes) = pair.scene();
    let complexes = complexes.each_ref();
    let contacts = contacts(backend, &scene, complexes)?;
    let arrangement = Arrangement::new(&scene, complexes, &contacts);
    let count = |seat| crossings(&scene, complexes, &contacts, &arrangement, seat).expect("polygons are closed");
    Ok(Examined {
        crossings: Seat::ALL.map(count),
        clusters: clusters(&arrangement, &contacts),
        collapses: collapses(&arrangement, complexes),
        contacts,
    })
}
