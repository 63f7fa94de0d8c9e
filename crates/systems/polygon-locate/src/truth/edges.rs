//! The edges of a map, each once, with the regions that they bound.

use std::collections::{BTreeMap, BTreeSet};

use predicament_judge::boxes::{Boxes, extent};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Plane, Scene};

use super::Edge;

/// The edges of a map: those that some region uses an odd number of times, in either direction.
#[derive(Clone, Debug)]
pub struct Edges {
    edges: Vec<(Edge, Vec<u32>)>,
    boxes: Boxes<2>,
}

impl Edges {
    /// Collects the edges of a map.
    ///
    /// # Panics
    /// If the map uses vertices that the scene lacks, or has 2^32 edges or regions.
    #[must_use]
    pub fn new(map: &PolygonMap, scene: &Scene) -> Edges {
        let mut owners: BTreeMap<Edge, BTreeSet<u32>> = BTreeMap::new();
        for (region, [a, b]) in map.edges() {
            let region = u32::try_from(region).expect("a map has fewer than 2^32 regions");
            let owners = owners.entry([a.min(b), a.max(b)]).or_default();
            // If a region uses an edge twice, the edge bounds it on neither side.
            if !owners.insert(region) {
                owners.remove(&region);
            }
        }
        owners.retain(|_, owners| !owners.is_empty());
        let edges: Vec<(Edge, Vec<u32>)> =
            owners.into_iter().map(|(ends, owners)| (ends, owners.into_iter().collect())).collect();
        let boxes = edges.iter().map(|(ends, _)| extent(ends.map(|v| scene.point2(Plane::Xy, v))));
        let boxes = Boxes::new(boxes.collect());
        Edges { edges, boxes }
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// True if the map bounds no region.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// All edges, each with the regions that it bounds, ascending.
    pub(super) fn all(&self) -> &[(Edge, Vec<u32>)] {
        &self.edges
    }

    /// The indices of the edges whose boxes meet the ray straight up from a point.
    pub(super) fn above(&self, [x, y]: [f64; 2]) -> Vec<u32> {
        let mut found = Vec::new();
        self.boxes.near(&[[x, y], [x, f64::INFINITY]], 0.0, &mut found);
        found
    }

    /// The edges after this one whose boxes meet its own box.
    pub(super) fn meeting(&self, at: usize) -> impl Iterator<Item = Edge> + '_ {
        let mut found = Vec::new();
        self.boxes.near(&self.boxes.all()[at], 0.0, &mut found);
        found.into_iter().map(|other| other as usize).filter(move |&other| at < other).map(|other| self.edges[other].0)
    }
}
