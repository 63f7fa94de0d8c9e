//! A result between two steps as doubles, as stored by programs without constructed vertices.
//!
//! Most points of a result are points of the result before. So points keep their indices from step to step, and only
//! new points are looked up by their coordinates.

use std::collections::HashMap;

use predicament_overlay::algorithm::overlay::{Edge, Polygon, Region, Rule};
use predicament_predicates::{Predicates, Scene, SceneError, Vertex};

use super::cascade::Loop;
use super::rounded::place;

/// A loop by the indices of its points.
pub(super) type Ring = Vec<u32>;

const NONE: u32 = u32::MAX;

/// The number of points that are kept although no loop passes them, beyond the number of those in use.
const SPARE: usize = 1024;

/// The loops of two operands in one scene; equal points are one vertex.
pub(super) struct Pair {
    pub scene: Scene,
    /// The result so far.
    pub first: Vec<Region>,
    pub second: Polygon,
    /// The point of each vertex.
    points: Vec<u32>,
}

/// Distinct points.
#[derive(Default)]
pub(super) struct Points {
    pub points: Vec<[f64; 2]>,
    // Only looked up, never iterated.
    places: HashMap<[u64; 2], u32>,
}

impl Points {
    /// The index of this point; a point that is not a number is distinct from every point.
    pub fn index(&mut self, point: [f64; 2]) -> u32 {
        let points = &mut self.points;
        let mut new = || {
            points.push(point);
            number(points.len() - 1)
        };
        if point.iter().any(|x| x.is_nan()) {
            return new();
        }
        // -0 and +0 are the same place.
        *self.places.entry(point.map(|x| (x + 0.0).to_bits())).or_insert_with(new)
    }

    /// The vertex at this point.
    pub fn vertex(&mut self, point: [f64; 2]) -> Vertex {
        Vertex::input(self.index(point) as usize)
    }

    /// A loop as edges, without edges of zero length.
    pub fn edges(&mut self, corners: &[[f64; 2]]) -> Vec<Edge> {
        let ring: Vec<Vertex> = corners.iter().map(|&corner| self.vertex(corner)).collect();
        edges(&ring, |&v| v)
    }

    /// The scene of all points.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        Scene::from_points2(&self.points)
    }
}

/// A closed loop as edges, without edges of zero length.
fn edges<T>(ring: &[T], mut vertex: impl FnMut(&T) -> Vertex) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(ring.len());
    let Some((first, rest)) = ring.split_first() else { return edges };
    let first = vertex(first);
    let mut from = first;
    for to in rest {
        let to = vertex(to);
        if from != to {
            edges.push(Edge::whole(from, to));
        }
        from = to;
    }
    if from != first {
        edges.push(Edge::whole(from, first));
    }
    edges
}

/// Vertices for some points, in the order in which they are first asked for.
pub(super) struct Numbering {
    /// One more than the index of each point's vertex; zero if it has none.
    vertices: Vec<u32>,
    /// The point of each vertex.
    pub points: Vec<u32>,
}

impl Numbering {
    /// A numbering of points with indices below a number.
    pub fn below(count: usize) -> Numbering {
        Numbering { vertices: vec![0; count], points: Vec::new() }
    }

    /// The vertex of a point.
    #[inline]
    pub fn vertex(&mut self, point: u32) -> Vertex {
        let vertex = &mut self.vertices[point as usize];
        if *vertex == 0 {
            self.points.push(point);
            *vertex = number(self.points.len());
        }
        Vertex::input(*vertex as usize - 1)
    }
}

/// A result.
pub(super) struct Current {
    pub points: Points,
    /// The loops of each region, the outer loop first.
    pub regions: Vec<Vec<Ring>>,
}

impl Current {
    pub fn new(start: &Loop) -> Current {
        let mut current = Current { points: Points::default(), regions: Vec::new() };
        current.regions = vec![vec![current.ring(start)]];
        current
    }

    /// The loop of these points.
    pub fn ring(&mut self, corners: &Loop) -> Ring {
        corners.iter().map(|&corner| self.points.index(corner)).collect()
    }

    /// Replaces the regions by those of the next result.
    pub fn replace(&mut self, regions: Vec<Vec<Ring>>) {
        self.regions = regions;
        if self.points.points.len() > 2 * self.held() + SPARE {
            let all = std::mem::take(&mut self.points);
            for point in self.regions.iter_mut().flatten().flatten() {
                *point = self.points.index(all.points[*point as usize]);
            }
        }
    }

    /// The number of corners.
    pub fn held(&self) -> usize {
        self.regions.iter().flatten().map(Vec::len).sum()
    }

    /// The loops by their corners.
    pub fn loops(&self) -> Vec<Vec<Loop>> {
        let corners = |ring: &Ring| ring.iter().map(|&point| self.points.points[point as usize]).collect();
        self.regions.iter().map(|region| region.iter().map(corners).collect()).collect()
    }

    /// The scene of a result and the next operand.
    ///
    /// # Errors
    /// A coordinate that is not finite.
    pub fn pair(&self, operand: &Ring) -> Result<Pair, SceneError> {
        let mut numbering = Numbering::below(self.points.points.len());
        let mut edges = |ring: &Ring| edges(ring, |&point| numbering.vertex(point));
        let mut first = Vec::with_capacity(self.regions.len());
        for region in &self.regions {
            let mut loops = region.iter().map(&mut edges).filter(|one| !one.is_empty());
            let Some(outer) = loops.next() else { continue };
            first.push(Region { outer, holes: loops.collect() });
        }
        let second = Polygon { loops: vec![edges(operand)], rule: Rule::NonZero };
        Ok(Pair { scene: self.scene(&numbering.points)?, first, second, points: numbering.points })
    }

    /// The scene of some points.
    pub fn scene(&self, points: &[u32]) -> Result<Scene, SceneError> {
        let coordinates: Vec<[f64; 2]> = points.iter().map(|&point| self.points.points[point as usize]).collect();
        Scene::from_points2(&coordinates)
    }
}

/// The points of a session's vertices.
pub(super) struct Places<'a> {
    pair: &'a Pair,
    session: &'a dyn Predicates,
    /// The points of constructed vertices, as far as they are known.
    constructed: Vec<u32>,
}

impl<'a> Places<'a> {
    pub fn new(pair: &'a Pair, session: &'a dyn Predicates) -> Places<'a> {
        Places { pair, session, constructed: vec![NONE; session.scene().constructions().len()] }
    }

    /// The point of a vertex; a constructed vertex is rounded.
    #[inline]
    pub fn of(&mut self, points: &mut Points, v: Vertex) -> u32 {
        let Some(at) = v.construction() else { return self.pair.points[v.index()] };
        if self.constructed[at] == NONE {
            self.constructed[at] = points.index(place(self.session, v));
        }
        self.constructed[at]
    }

    /// The loops of regions.
    pub fn rings(&mut self, points: &mut Points, regions: &[Region]) -> Vec<Vec<Ring>> {
        let mut ring = |one: &Vec<Edge>| one.iter().map(|edge| self.of(points, edge.from)).collect();
        regions.iter().map(|region| region.loops().map(&mut ring).collect()).collect()
    }
}

/// Loops without repeated corners, and the number of removed loops with fewer than three corners.
pub(super) fn cleaned<T: PartialEq>(regions: Vec<Vec<Vec<T>>>) -> (Vec<Vec<Vec<T>>>, usize) {
    let mut collapsed = 0;
    let mut clean = |mut one: Vec<T>| {
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

fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 points")
}
