//! A result between two steps as doubles, as stored by programs without constructed vertices.

use std::collections::HashMap;

use predicament_overlay::algorithm::overlay::{Edge, Polygon, Region, Rule};
use predicament_predicates::{Scene, SceneError, Vertex};

use super::cascade::Loop;

/// The loops of two operands in one scene; equal points are one vertex.
pub(super) struct Pair {
    pub scene: Scene,
    /// The result so far.
    pub first: Vec<Region>,
    pub second: Polygon,
}

/// Distinct points.
#[derive(Default)]
pub(super) struct Points {
    pub points: Vec<[f64; 2]>,
    // Only looked up, never iterated.
    places: HashMap<[u64; 2], usize>,
}

impl Points {
    /// The vertex at this point.
    pub fn vertex(&mut self, point: [f64; 2]) -> Vertex {
        // -0 and +0 are the same place.
        let key = point.map(|x| (x + 0.0).to_bits());
        let points = &mut self.points;
        Vertex::input(*self.places.entry(key).or_insert_with(|| {
            points.push(point);
            points.len() - 1
        }))
    }

    /// A loop as edges, without edges of zero length.
    pub fn edges(&mut self, corners: &[[f64; 2]]) -> Vec<Edge> {
        let vertices: Vec<Vertex> = corners.iter().map(|&corner| self.vertex(corner)).collect();
        let ends = vertices.iter().zip(vertices.iter().cycle().skip(1));
        ends.filter(|(from, to)| from != to).map(|(&from, &to)| Edge::whole(from, to)).collect()
    }

    /// The scene of all points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        Scene::from_points2(&self.points)
    }
}

impl Pair {
    /// The scene of a result and the next operand.
    ///
    /// # Errors
    /// A coordinate that is not finite.
    pub fn new(regions: &[Vec<Loop>], corners: &Loop) -> Result<Pair, SceneError> {
        let mut points = Points::default();
        let mut region = |loops: &Vec<Loop>| {
            let mut loops = loops.iter().map(|one| points.edges(one));
            Region { outer: loops.next().unwrap_or_default(), holes: loops.collect() }
        };
        let first = regions.iter().map(&mut region).collect();
        let second = Polygon { loops: vec![points.edges(corners)], rule: Rule::NonZero };
        Ok(Pair { scene: points.scene()?, first, second })
    }
}

/// Loops without repeated corners, and the number of removed loops with fewer than three corners.
pub(super) fn cleaned(regions: Vec<Vec<Loop>>) -> (Vec<Vec<Loop>>, usize) {
    let mut collapsed = 0;
    let mut clean = |mut one: Loop| {
        one.dedup();
        while one.len() > 1 && one.first() == one.last() {
            one.pop();
        }
        let is_loop = one.len() > 2;
        collapsed += usize::from(!is_loop);
        is_loop.then_some(one)
    };
    let mut kept = Vec::with_capacity(regions.len());
    for region in regions {
        let mut loops = region.into_iter();
        // Without its outer loop a region is removed.
        if let Some(outer) = loops.next().and_then(&mut clean) {
            kept.push([outer].into_iter().chain(loops.filter_map(&mut clean)).collect());
        }
    }
    (kept, collapsed)
}
