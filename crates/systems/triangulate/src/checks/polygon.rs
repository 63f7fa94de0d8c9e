//! The truth about the loops of a polygon, before any triangulation.

use std::cmp::Ordering;

use predicament_predicates::{Plane, Scene, Vertex};
use rug::{Integer, Rational};

use super::nesting::{edges, holes};
use super::plane::Points;
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
    /// A vertex at which loops cross each other.
    tangle: Option<Vertex>,
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
        let (passages, tangle) = passages(&points, &loops);
        let triangles = (corners + 2 * holes).saturating_sub(2 * outer + 2 * passages);
        let touches = Touches::new(&points, &loops);
        let tangle = tangle.map(|place| points.vertex(place));
        Polygon { points, loops, area, triangles, touches, tangle }
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

    /// The reason why the loops bound no polygon, and the vertices there: loops cross, or pass along one edge twice.
    #[must_use]
    pub fn fault(&self) -> Option<(String, Vec<Vertex>)> {
        match (self.touches.crossing, self.tangle) {
            (Some([[a, b], [c, d]]), _) => {
                let why = format!("the edges from {a} to {b} and from {c} to {d} cross, or overlap on a line");
                Some((why, vec![a, b, c, d]))
            }
            (None, Some(v)) => Some((format!("loops cross each other at vertex {v}"), vec![v])),
            (None, None) => None,
        }
    }

    /// The places where loops touch or cross.
    #[must_use]
    pub fn touches(&self) -> &Touches {
        &self.touches
    }
}

/// The number of times that loops pass through a vertex from inside another loop that passes through it. It is, summed
/// over all vertices, the number of corners around any direction to the inside, less one.
///
/// If that number differs between the edges that leave a vertex, loops cross there: the second value is the first such
/// vertex.
fn passages(points: &Points, loops: &[Vec<usize>]) -> (usize, Option<usize>) {
    let mut at: Vec<Vec<[usize; 2]>> = vec![Vec::new(); points.len()];
    for one in loops {
        for (&before, [corner, after]) in one.iter().cycle().skip(one.len() - 1).zip(edges(one)) {
            at[corner].push([after, before]);
        }
    }
    let (mut all, mut tangle) = (0, None);
    for (v, corners) in at.iter().enumerate().filter(|(_, corners)| corners.len() > 1) {
        // The region right after an edge that leaves is inside.
        let covers = |direction: usize| {
            corners.iter().filter(|&&[from, to]| is_between(points, v, [from, to], direction)).count()
        };
        let around: Vec<usize> = corners.iter().map(|&[from, _]| covers(from)).collect();
        if around.iter().any(|&count| count != around[0]) {
            tangle.get_or_insert(v);
        }
        all += around.into_iter().min().unwrap_or(0).saturating_sub(1);
    }
    (all, tangle)
}

/// True if the region right after a direction from v, counterclockwise, is in the sector between two others.
fn is_between(points: &Points, v: usize, [from, to]: [usize; 2], direction: usize) -> bool {
    // The angle from the first direction, in classes: zero, less than half a turn, half a turn, more.
    let turn = |far: usize| match (points.side(v, from, far), points.along(v, from, far).cmp0()) {
        (Ordering::Equal, Ordering::Greater) => 0,
        (Ordering::Greater, _) => 1,
        (Ordering::Equal, _) => 2,
        (Ordering::Less, _) => 3,
    };
    match (turn(direction), turn(to)) {
        (a, b) if a == b => points.side(v, direction, to).is_gt(),
        (a, b) => a < b,
    }
}
