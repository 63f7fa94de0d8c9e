//! Vertices of one complex that merge into one point, and edges that collapse.

use std::collections::BTreeMap;

use crate::answer::Contacts;
use crate::answer::{Arrangement, Side};
use predicament_mesh::Complex;
use predicament_predicates::Vertex;

/// Vertices of one complex that became one point, because registration is not transitive: A₁ is registered with B₁, and
/// B₁ with A₂, but A₁ and A₂ are two.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cluster {
    /// The merged point.
    pub point: usize,
    /// The vertices of the cluster in each complex.
    pub vertices: [Vec<Vertex>; 2],
    /// The number of its pairs of vertices, one of each complex, that were not registered: merged only through others.
    /// Zero if registration was transitive here.
    pub unregistered: usize,
}

/// An edge whose ends became one point.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Collapse {
    /// The complex of the edge.
    pub side: Side,
    /// The edge, by its index in the complex.
    pub edge: u32,
    /// The point.
    pub point: usize,
    /// The number of other points that its path still passes through: zero if the edge has vanished.
    pub between: usize,
}

/// The merged points with more than one vertex of the same complex.
///
/// # Panics
/// If the arrangement was not made from these contacts.
#[must_use]
pub fn clusters(arrangement: &Arrangement, contacts: &Contacts) -> Vec<Cluster> {
    assert_eq!(contacts.registered.len(), arrangement.of_contacts().len(), "the arrangement's own contacts");
    let mut registered: BTreeMap<usize, usize> = BTreeMap::new();
    for (contact, &point) in contacts.registered.iter().zip(arrangement.of_contacts()) {
        if contact.a.rank == 0 && contact.b.rank == 0 {
            *registered.entry(point).or_default() += 1;
        }
    }
    let merged = arrangement.points().iter().enumerate();
    merged
        .filter(|(_, point)| point.vertices.iter().any(|vertices| vertices.len() > 1))
        .map(|(at, point)| Cluster {
            point: at,
            vertices: point.vertices.clone(),
            unregistered: point.vertices[0].len() * point.vertices[1].len() - registered[&at],
        })
        .collect()
}

/// The edges that collapsed, by side and edge.
#[must_use]
pub fn collapses(arrangement: &Arrangement, complexes: [&Complex; 2]) -> Vec<Collapse> {
    let mut collapses = Vec::new();
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        for (edge, _) in (0_u32..).zip(complex.edges()) {
            let path = arrangement.path(side, edge);
            if path.first() == path.last() {
                let point = path[0];
                let between = path.iter().filter(|&&at| at != point).count();
                collapses.push(Collapse { side, edge, point, between });
            }
        }
    }
    collapses
}
