//! The truth about polygons: edges that touch, the nesting of loops, and the plane in which each polygon is seen.

use crate::checks::Polygon;
use predicament_judge::sign;
use predicament_predicates::{Dimension, Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::{Stop, Watch};

/// The reason why loops are not a polygon to triangulate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The reason.
    pub why: String,
    /// The vertices there.
    pub vertices: Vec<Vertex>,
    /// The fix, in one line.
    pub cure: &'static str,
}

/// A polygon, its plane, and the reason why it is none. This is the only check of validity: readers, the judge and
/// hunts all use it.
#[derive(Debug)]
pub struct Examined {
    /// The facts about the loops.
    pub polygon: Polygon,
    /// The plane in which the polygon is seen, and true if it is seen from behind.
    pub seen: (Plane, bool),
    /// The reason why the loops are not a polygon.
    pub flaw: Option<Flaw>,
}

impl Examined {
    /// Examines loops of a scene.
    #[must_use]
    pub fn new(scene: &Scene, loops: &[Vec<Vertex>]) -> Examined {
        let seen = seen(scene, loops);
        let polygon = Polygon::new(scene, seen.0, seen.1, loops);
        let flaw = uneven(scene, loops).or_else(|| {
            let fault = polygon.fault()?;
            Some(Flaw { why: fault.to_string(), vertices: fault.vertices.clone(), cure: fault.cure() })
        });
        Examined { polygon, seen, flaw }
    }
}

/// The first region with a flaw, if every region of a map has one.
#[must_use]
pub fn first_flaw_if_all(scene: &Scene, polygons: &[Vec<Vec<Vertex>>]) -> Option<(usize, Flaw)> {
    let mut first = None;
    for (at, loops) in polygons.iter().enumerate() {
        let flaw = Examined::new(scene, loops).flaw?;
        first.get_or_insert((at, flaw));
    }
    first
}

/// The reason why the corners of a face are not in one plane, or are all in line.
fn uneven(scene: &Scene, loops: &[Vec<Vertex>]) -> Option<Flaw> {
    let flaw = |why: String, vertices: Vec<Vertex>| {
        let cure = "put all corners in one plane but not on one line, or divide the face";
        Some(Flaw { why, vertices, cure })
    };
    let corners: Vec<Vertex> = loops.iter().flatten().copied().collect();
    let in_space = scene.dimension() == Dimension::Three;
    let planes = if in_space { &[Plane::Xy, Plane::Yz, Plane::Zx][..] } else { &[Plane::Xy] };
    let turns = |b: Vertex, c: Vertex| {
        planes.iter().any(|&plane| !sign(scene, Question::Orient2d(plane), &[corners[0], b, c]).is_zero())
    };
    let second = corners.iter().copied().find(|&b| scene.point(b) != scene.point(corners[0]));
    let plane = second.and_then(|b| Some((b, corners.iter().copied().find(|&c| turns(b, c))?)));
    let Some((b, c)) = plane else {
        return flaw("all corners are on one line".to_owned(), corners.first().copied().into_iter().collect());
    };
    let is_off = |d: &&Vertex| !sign(scene, Question::Orient3d, &[corners[0], b, c, **d]).is_zero();
    let off = *corners.iter().find(|d| in_space && is_off(d))?;
    flaw(format!("the corner {off} is not in the plane of {}, {b} and {c}", corners[0]), vec![off, corners[0], b, c])
}

/// The truth about each polygon of a scene.
#[derive(Debug)]
pub struct Truth {
    /// The polygons in the scene's order.
    pub polygons: Vec<Examined>,
}

impl Truth {
    /// Computes the truth, polygon by polygon.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, polygons: &[Vec<Vec<Vertex>>], watch: &Watch) -> Result<Truth, Stop> {
        let mut truth = Truth { polygons: Vec::with_capacity(polygons.len()) };
        for loops in polygons {
            truth.polygons.push(Examined::new(scene, loops));
            watch.done(1)?;
        }
        Ok(truth)
    }

    /// The first flaw, if no polygon is one.
    #[must_use]
    pub fn flaw(&self) -> Option<&Flaw> {
        if self.polygons.iter().any(|examined| examined.flaw.is_none()) {
            return None;
        }
        self.polygons.first()?.flaw.as_ref()
    }

    /// The comparisons left out, as text.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let all = self.polygons.len();
        let count = |is: &dyn Fn(&Examined) -> bool| self.polygons.iter().filter(|examined| is(examined)).count();
        let wrong = count(&|examined| examined.flaw.is_some());
        let unknown = count(&|examined| !examined.polygon.touches().is_known);
        let mut said = Vec::new();
        if wrong > 0 {
            said.push(format!(
                "{wrong} of {all} regions are not judged: they are not polygons, for example because their rings cross"
            ));
        }
        if unknown > 0 {
            said.push(format!(
                "{unknown} of {all} polygons are assumed not to touch themselves: their edges were not compared"
            ));
        }
        (!said.is_empty()).then(|| said.join("; "))
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
