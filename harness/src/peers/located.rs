//! A map with its probes and the truth about them, as peers ask for it.

use predicament_algorithms::polygon_locate::{LocateIndex, Locations};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::AnyCase;
use predicament_tasks::polygon_locate::{MapWithProbes, Truth};

/// A map with its probes, and where they are.
#[derive(Clone)]
pub struct Case<'a> {
    /// The points.
    pub scene: &'a Scene,
    /// The regions.
    pub map: &'a PolygonMap,
    /// The map's edges, ready for queries.
    pub index: &'a LocateIndex,
    /// What is located.
    pub probes: Vec<Vertex>,
    /// The exact answers.
    pub exact: &'a Locations,
}

impl<'a> Case<'a> {
    /// The map of a case; none where it is about something else.
    pub fn of(case: &'a dyn AnyCase) -> Option<Case<'a>> {
        let content = case.loaded().content::<MapWithProbes>()?;
        let truth = case.truth().downcast_ref::<Truth>()?;
        let scene = &case.loaded().scene;
        let (index, probes) = (content.index(scene), content.vertices());
        Some(Case { scene, map: &content.map, index, probes, exact: &truth.exact })
    }
}
