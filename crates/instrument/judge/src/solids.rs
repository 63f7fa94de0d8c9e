//! The exact location of points in multi-material meshes: crossing sums, triangle by triangle.
//!
//! # Definition
//! A mesh is a list of triangles. Each has one region in front of it, on the side where its corners appear
//! counterclockwise, and one region behind. The boundary of a region consists of the triangles that have the region on
//! one side; each boundary of a mesh is closed.
//! * A point is **on** a triangle iff the closed triangle contains it.
//! * Else the **winding number** of a region around the point is that of the region's boundary, counted along a ray
//!   from outside to the point: the triangles at which the ray enters the region, less those at which it leaves it.
//!   Region 0 is outside of everything and has one more. The point is **in** a region iff its winding number is 1 and
//!   all others are 0.
//!
//! # How
//! [`Materials::locate`] sends the ray along x, at (ε, ε²) beside the point in y and z, so that it avoids all vertices
//! and edges. If the box of a triangle, as seen along the ray, does not hold the point, comparing doubles decides,
//! which is exact; all other signs are those of [integers](crate::sign).
//!
//! [`Materials::winding`] is a second computation, in rationals: along a ray of a given direction, in general position
//! or refused, it decides by barycentric coordinates. Both test every point against every triangle. [`InIntegers`] is
//! that second computation for points that are not doubles, without a division. [`Boundary`] is for doubles in solids
//! whose corners are rational. (The algorithm under test sends a vertical ray, through a grid.)

mod boundary;
mod integers;
mod missed;

use std::collections::BTreeMap;

use predicament_predicates::{Axis, Plane, Question, Scene, Sign, Vertex};
use rug::Rational;

pub use boundary::Boundary;
pub use integers::InIntegers;

use crate::{rational, sign};

/// The location of a point in a mesh.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Place {
    /// On these triangles, ascending.
    On(Vec<u32>),
    /// Inside exactly one region.
    In(u32),
    /// The regions with non-zero winding numbers around the point, if they are not a single region with 1.
    Windings(Vec<(u32, i64)>),
}

/// A multi-material mesh, as its triangles.
pub struct Materials<'s> {
    scene: &'s Scene,
    triangles: &'s [[Vertex; 3]],
    sides: &'s [[u32; 2]],
}

/// The relation of a ray to a triangle.
enum Meeting {
    Missed,
    On,
    /// The ray crosses the triangle; true if the point is behind it.
    Passed(bool),
}

impl<'s> Materials<'s> {
    /// A mesh of a scene, with a pair of regions for each triangle: in front and behind.
    ///
    /// # Panics
    /// If the numbers of sides and of triangles differ.
    #[must_use]
    pub fn new(scene: &'s Scene, triangles: &'s [[Vertex; 3]], sides: &'s [[u32; 2]]) -> Materials<'s> {
        assert_eq!(triangles.len(), sides.len(), "a pair of sides for each triangle");
        Materials { scene, triangles, sides }
    }

    /// The location of a vertex of the scene.
    ///
    /// # Panics
    /// If the scene lacks the vertex.
    #[must_use]
    pub fn locate(&self, q: Vertex) -> Place {
        self.place(|_, triangle| Some(self.along_x(triangle, q))).expect("a ray beside all edges")
    }

    /// The location of a vertex of the scene, by a ray in this direction.
    ///
    /// Returns `None` if the ray touches the border of a triangle or runs in its plane.
    ///
    /// # Panics
    /// If the scene lacks the vertex, or the direction is zero.
    #[must_use]
    pub fn winding(&self, q: Vertex, direction: [i32; 3]) -> Option<Place> {
        assert_ne!(direction, [0; 3], "a ray has a direction");
        let (q, direction) = (self.scene.point3(q).map(rational), direction.map(Rational::from));
        self.place(|_, triangle| self.along(triangle, &q, &direction))
    }

    /// The triangles with integer coordinates, to locate rational points.
    #[must_use]
    pub fn in_integers(&self) -> InIntegers<'_> {
        InIntegers::new(self)
    }

    fn place(&self, meet: impl Fn(usize, [Vertex; 3]) -> Option<Meeting>) -> Option<Place> {
        let (mut on, mut windings) = (Vec::new(), BTreeMap::from([(0_u32, 1_i64)]));
        for (at, (&triangle, &[front, back])) in (0_u32..).zip(self.triangles.iter().zip(self.sides)) {
            match meet(at as usize, triangle)? {
                Meeting::Missed => {}
                Meeting::On => on.push(at),
                Meeting::Passed(from_behind) => {
                    let by = if from_behind { 1 } else { -1 };
                    *windings.entry(back).or_default() += by;
                    *windings.entry(front).or_default() -= by;
                }
            }
        }
        windings.retain(|_, winding| *winding != 0);
        let windings: Vec<(u32, i64)> = windings.into_iter().collect();
        Some(match windings[..] {
            _ if !on.is_empty() => Place::On(on),
            [(region, 1)] => Place::In(region),
            _ => Place::Windings(windings),
        })
    }

    /// The meeting of a triangle with the ray to larger x.
    fn along_x(&self, triangle: [Vertex; 3], q: Vertex) -> Meeting {
        let [a, b, c] = triangle;
        let p = self.scene.point3(q);
        let corners = triangle.map(|v| self.scene.point3(v));
        let is_beside = |axis: usize| {
            corners.iter().all(|corner| corner[axis] < p[axis]) || corners.iter().all(|corner| corner[axis] > p[axis])
        };
        if is_beside(1) || is_beside(2) || corners.iter().all(|corner| corner[0] < p[0]) {
            return Meeting::Missed;
        }
        let turn = |plane: Plane, u: Vertex, v: Vertex| sign(self.scene, Question::Orient2d(plane), &[u, v, q]);
        let side = sign(self.scene, Question::Orient3d, &[a, b, c, q]);
        let is_within = |plane: Plane| {
            let turns = [turn(plane, a, b), turn(plane, b, c), turn(plane, c, a)];
            !(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative))
        };
        // In the box, in the plane and in each projection: a point of the triangle, even of a triangle without area.
        if side == Sign::Zero && !is_beside(0) && [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().all(is_within) {
            return Meeting::On;
        }
        let compare = |axis: Axis, u: Vertex, v: Vertex| sign(self.scene, Question::Compare(axis), &[u, v]);
        // The derivative of the turn of u, v, q by the first coordinate of q is u₂ − v₂, by the second v₁ − u₁.
        let moved = |u: Vertex, v: Vertex| match turn(Plane::Yz, u, v) {
            Sign::Zero => match compare(Axis::Z, u, v) {
                Sign::Zero => compare(Axis::Y, v, u),
                by_first => by_first,
            },
            turn => turn,
        };
        let turns = [moved(a, b), moved(b, c), moved(c, a)];
        if turns[0] == Sign::Zero || turns[0] != turns[1] || turns[1] != turns[2] || side != turns[0] {
            return Meeting::Missed;
        }
        Meeting::Passed(side == Sign::Positive)
    }

    /// The meeting of a triangle with a ray in a direction: q + t d = a + v (b − a) + w (c − a), by Cramer's rule.
    fn along(&self, triangle: [Vertex; 3], q: &[Rational; 3], direction: &[Rational; 3]) -> Option<Meeting> {
        let point = |v: Vertex| self.scene.point3(v).map(rational);
        let less = |p: &[Rational; 3], q: &[Rational; 3]| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
        let [a, b, c] = triangle.map(point);
        let (ab, ac, aq) = (less(&b, &a), less(&c, &a), less(q, &a));
        let normal = cross(&ab, &ac);
        if normal.iter().all(|x| x.cmp0().is_eq()) {
            // The corners are collinear: the triangle is the path from the first over the second to the third corner. A
            // point can be on it, but no ray crosses it.
            let from_q = [a, b, c].map(|corner| less(&corner, q));
            let is_between = |u: usize, v: usize| {
                let is_on_line = cross(&from_q[u], &from_q[v]).iter().all(|x| x.cmp0().is_eq());
                is_on_line && dot(&from_q[u], &from_q[v]).cmp0().is_le()
            };
            let is_on = is_between(0, 1) || is_between(1, 2);
            return Some(if is_on { Meeting::On } else { Meeting::Missed });
        }
        let determinant = dot(direction, &normal);
        let height = dot(&aq, &normal);
        if determinant.cmp0().is_eq() {
            // The plane is parallel to the ray, which misses it unless the point is in the plane.
            return height.cmp0().is_ne().then_some(Meeting::Missed);
        }
        let t = Rational::from(-&height) / &determinant;
        let turned = cross(&aq, direction);
        let v = -dot(&ac, &turned) / &determinant;
        let w = dot(&ab, &turned) / &determinant;
        let u = Rational::from(1) - &v - &w;
        let coordinates = [u.cmp0(), v.cmp0(), w.cmp0()];
        if t.cmp0().is_lt() || coordinates.iter().any(|coordinate| coordinate.is_lt()) {
            return Some(Meeting::Missed);
        }
        if t.cmp0().is_eq() {
            return Some(Meeting::On);
        }
        // The normal points to the front: behind the triangle the height is negative.
        coordinates.iter().all(|coordinate| coordinate.is_gt()).then(|| Meeting::Passed(height.cmp0().is_lt()))
    }
}

fn cross(p: &[Rational; 3], q: &[Rational; 3]) -> [Rational; 3] {
    [0, 1, 2].map(|i: usize| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        Rational::from(&p[j] * &q[k]) - Rational::from(&p[k] * &q[j])
    })
}

fn dot(p: &[Rational; 3], q: &[Rational; 3]) -> Rational {
    (0..3).map(|i| Rational::from(&p[i] * &q[i])).sum()
}
