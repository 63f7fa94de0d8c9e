//! A map with its probes, and where they are by the judge's signs, as peers ask for it.

use std::rc::Rc;

use predicament_judge::Judged;
use predicament_mesh::PolygonMap;
use predicament_polygon_locate::algorithm::{LocateIndex, Locations, question_all};
use predicament_polygon_locate::task::MapWithProbes;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::AnyCase;

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
    pub exact: Rc<Locations>,
}

impl<'a> Case<'a> {
    /// The map of a case; none where it is about something else.
    pub fn of(case: &'a dyn AnyCase) -> Option<Case<'a>> {
        let content = case.loaded().content::<MapWithProbes>()?;
        let scene = &case.loaded().scene;
        let (index, probes) = (content.locate_index(scene), content.vertices());
        let exact = Rc::new(question_all(index, &Judged::exact(scene), &probes, &|_| true));
        Some(Case { scene, map: &content.map, index, probes, exact })
    }
}
