//! The truth about the loops of a polygon, before any triangulation.

use std::cmp::Ordering;

use predicament_predicates::{Plane, Scene, Vertex};
use rug::{Integer, Rational};

use super::fault::{Fault, FaultKind};
use super::nesting::{edges, holes};
use super::plane::Points;
use super::strands::crossing;
use super::touches::Touches;

/// A polygon: loops with the inside on their left, and facts that follow from them.
#[derive(Clone, Debug)]
pub struct Polygon {
    pub(super) points: Points,
    /// The loops, as indices of points.
    pub(super) loops: Vec<Vec<usize>>,
    /// Twice the area.
    pub(super) area: Integer,
    /// The number of triangles.
    pub(super) triangles: usize,
    pub(super) touches: Touches,
    fault: Option<Fault>,
}

impl Polygon {
    /// The polygon that the loops bound in a coordinate plane: a point is inside if an odd number of loops surrounds
    /// it. Loops may have either direction.
    ///
    /// # Panics
    /// If a vertex is constructed.
    #[must_use]
    pub fn new(scene: &Scene, plane: Plane, reversed: bool, loops: &[Vec<Vertex>]) -> Polygon {
        let points = Points::new(scene, plane, reversed, loops.iter().flatten().copied());
        let place = |v: &Vertex| points.place(*v).unwrap_or_default();
        let mut loops: Vec<Vec<usize>> = loops.iter().map(|one| one.iter().map(place).collect()).collect();
        let is_hole = holes(&points, &loops);
        let mut area = Integer::new();
        for (one, &is_hole) in loops.iter_mut().zip(&is_hole) {
            let mut own = points.area(one);
            if (own.cmp0() == Ordering::Less) != is_hole && own.cmp0() != Ordering::Equal {
                one.reverse();
                own = -own;
            }
            area += own;
        }
        let holes = is_hole.iter().filter(|is_hole| **is_hole).count();
        let corners: usize = loops.iter().map(Vec::len).sum();
        let outer = loops.len() - holes;
        let triangles = (corners + 2 * holes).saturating_sub(2 * outer + 2 * passages(&points, &loops));
        let touches = Touches::new(&points, &loops, &is_hole);
        let is_point = |one: &&Vec<usize>| one.iter().all(|&corner| points.is_same_place(corner, one[0]));
        let point = loops.iter().find(is_point).and_then(|one| one.first());
        let point = point.map(|&v| Fault { kind: FaultKind::Point, vertices: vec![points.vertex(v)] });
        let fault = point.or_else(|| touches.fault.clone()).or_else(|| {
            let place = crossing(&points, &loops, &touches)?;
            Some(Fault { kind: FaultKind::Cross, vertices: vec![points.vertex(place)] })
        });
        Polygon { points, loops, area, triangles, touches, fault }
    }

    /// The number of corners: a vertex counts once for each time that the loops pass through it.
    #[must_use]
    pub fn corners(&self) -> usize {
        self.loops.iter().map(Vec::len).sum()
    }

    /// The area, in the scene's units.
    #[must_use]
    pub fn area(&self) -> Rational {
        self.points.in_scene_units(&self.area)
    }

    /// The first reason why the loops bound no polygon.
    #[must_use]
    pub fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// True if an edge has no length: its ends are two vertices at one place.
    #[must_use]
    pub(super) fn has_edge_without_length(&self) -> bool {
        self.loops.iter().flat_map(|one| edges(one)).any(|[a, b]| self.points.is_same_place(a, b))
    }

    /// The places where loops touch.
    #[must_use]
    pub fn touches(&self) -> &Touches {
        &self.touches
    }
}

/// The number of times that loops pass through a vertex from inside another loop that passes through it. It is, summed
/// over all vertices, the number of corners around any direction to the inside, less one. Loops that cross there have
/// no such number.
fn passages(points: &Points, loops: &[Vec<usize>]) -> usize {
    let mut at: Vec<Vec<[usize; 2]>> = vec![Vec::new(); points.len()];
    for one in loops {
        for (&before, [corner, after]) in one.iter().cycle().skip(one.len() - 1).zip(edges(one)) {
            at[corner].push([after, before]);
        }
    }
    let mut all = 0;
    for (v, corners) in at.iter().enumerate().filter(|(_, corners)| corners.len() > 1) {
        // The region right after an edge that leaves is inside.
        let covers = |direction: usize| {
            corners.iter().filter(|&&[from, to]| points.order_around(v, from, direction, to).is_lt()).count()
        };
        all += corners.iter().map(|&[from, _]| covers(from)).min().unwrap_or(0).saturating_sub(1);
    }
    all
}
