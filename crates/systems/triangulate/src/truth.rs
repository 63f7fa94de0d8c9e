//! The truth about polygons: edges that touch, the nesting of loops, and the plane in which each polygon is seen.

use crate::checks::Polygon;
use predicament_judge::sign;
use predicament_predicates::{Dimension, Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::{Stop, Watch};

/// The truth about each polygon of a scene.
#[derive(Debug)]
pub struct Truth {
    /// The polygons in the scene's order.
    pub polygons: Vec<Polygon>,
    /// The plane in which each polygon is seen, and true if it is seen from behind.
    pub seen: Vec<(Plane, bool)>,
}

impl Truth {
    /// Computes the truth, polygon by polygon.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, polygons: &[Vec<Vec<Vertex>>], watch: &Watch) -> Result<Truth, Stop> {
        let mut truth = Truth { polygons: Vec::with_capacity(polygons.len()), seen: Vec::new() };
        for loops in polygons {
            let (plane, reversed) = seen(scene, loops);
            truth.polygons.push(Polygon::new(scene, plane, reversed, loops));
            truth.seen.push((plane, reversed));
            watch.done(1)?;
        }
        Ok(truth)
    }

    /// The comparisons left out, as text.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let all = self.polygons.len();
        let count = |is: &dyn Fn(&Polygon) -> bool| self.polygons.iter().filter(|polygon| is(polygon)).count();
        let wrong = count(&|polygon| self.is_left_out(polygon));
        let unknown = count(&|polygon| !polygon.touches().is_known);
        let mut said = Vec::new();
        if wrong > 0 {
            said.push(format!(
                "{wrong} of {all} regions are not judged: their rings cross, or pass along an edge twice"
            ));
        }
        if unknown > 0 {
            said.push(format!(
                "{unknown} of {all} polygons are assumed not to touch themselves: their edges were not compared"
            ));
        }
        (!said.is_empty()).then(|| said.join("; "))
    }

    /// True if a polygon is not judged: a region of a map that is not a polygon. A single polygon with that flaw is a
    /// finding instead.
    #[must_use]
    pub fn is_left_out(&self, polygon: &Polygon) -> bool {
        self.polygons.len() > 1 && polygon.fault().is_some()
    }
}

/// The first coordinate plane in which the face has area, and true if the face is seen from behind there. The turn of
/// the outer loop at its first corner in order decides.
pub(crate) fn seen(scene: &Scene, loops: &[Vec<Vertex>]) -> (Plane, bool) {
    if scene.dimension() == Dimension::Two {
        return (Plane::Xy, false);
    }
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter();
    let turned = planes.filter_map(|plane| {
        let point = |v: Vertex| scene.point2(plane, v);
        let before = |a: Vertex, b: Vertex| point(a).partial_cmp(&point(b)) == Some(std::cmp::Ordering::Less);
        let outer = loops.iter().reduce(|one, other| {
            let first = |of: &[Vertex]| of.iter().copied().reduce(|a, b| if before(b, a) { b } else { a });
            if first(other).zip(first(one)).is_some_and(|(b, a)| before(b, a)) { other } else { one }
        })?;
        match area_sign(scene, plane, outer) {
            Sign::Zero => None,
            sign => Some((plane, sign == Sign::Negative)),
        }
    });
    turned.into_iter().next().unwrap_or((Plane::Xy, false))
}

/// The sign of the area of a loop in a plane: the turn at its first corner in order.
fn area_sign(scene: &Scene, plane: Plane, corners: &[Vertex]) -> Sign {
    let point = |at: usize| scene.point2(plane, corners[at % corners.len()]);
    let before = |a: usize, b: usize| point(a).partial_cmp(&point(b)) == Some(std::cmp::Ordering::Less);
    let Some(first) = (0..corners.len()).reduce(|a, b| if before(b, a) { b } else { a }) else { return Sign::Zero };
    let apart = |at: &usize| point(*at) != point(first);
    let count = corners.len();
    let next = (first + 1..first + count).find(apart).unwrap_or(first);
    let previous = (first + 1..first + count).rev().find(apart).unwrap_or(first);
    let turn = [previous, first, next].map(|at| corners[at % count]);
    if turn[0] == turn[2] { Sign::Zero } else { sign(scene, Question::Orient2d(plane), &turn) }
}
