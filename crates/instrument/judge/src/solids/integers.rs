//! Rational points in multi-material meshes: signs of determinants of integers.
//!
//! The middle of a piece of a triangle has denominators of hundreds of digits, and rationals spend their time on common
//! factors. Here a point is three integers over a common weight. Only signs are computed, and nothing is divided. A ray
//! misses most triangles by far, which doubles show (`missed.rs`).

use rug::{Integer, Rational};

use super::missed::Ray;
use super::{Materials, Meeting, Place};
use crate::rational;

type Space = [Integer; 3];

/// A mesh as integer coordinates of its triangles, all scaled by one power of two.
pub struct InIntegers<'m> {
    materials: &'m Materials<'m>,
    scale: Integer,
    corners: Vec<[Space; 3]>,
    /// The normals of the triangles, twice as long as the areas.
    normals: Vec<Space>,
}

impl<'m> InIntegers<'m> {
    pub(super) fn new(materials: &'m Materials<'m>) -> InIntegers<'m> {
        let exact: Vec<[[Rational; 3]; 3]> =
            materials.triangles.iter().map(|t| t.map(|v| materials.scene.point3(v).map(rational))).collect();
        // Denominators are powers of two: the largest is a multiple of all.
        let scale = exact.as_flattened().as_flattened().iter().map(Rational::denom).max().cloned();
        let scale = scale.unwrap_or_else(|| Integer::from(1));
        let whole = |x: &Rational| Integer::from(x.numer() * &scale) / x.denom();
        let corners: Vec<[Space; 3]> = exact.iter().map(|t| t.each_ref().map(|p| p.each_ref().map(whole))).collect();
        let normals = corners.iter().map(|[a, b, c]| cross(&less(b, a), &less(c, a))).collect();
        InIntegers { materials, scale, corners, normals }
    }

    /// The place of a point, by a ray in this direction.
    ///
    /// Returns `None` if the ray touches the border of a triangle or runs in its plane, or if a triangle has no area.
    ///
    /// # Panics
    /// If the direction is zero.
    #[must_use]
    pub fn winding(&self, q: &[Rational; 3], direction: [i32; 3]) -> Option<Place> {
        self.but_for(&[], q, direction)
    }

    /// The place next to a point of these triangles, a small step ahead in this direction; true if the step leaves the
    /// first triangle by its front.
    ///
    /// Returns `None` if the ray runs in the plane of one of these triangles, touches the border of another triangle,
    /// or runs in the plane of another triangle.
    ///
    /// # Panics
    /// If the direction is zero, or a triangle does not exist.
    #[must_use]
    pub fn beside(&self, triangles: &[u32], q: &[Rational; 3], direction: [i32; 3]) -> Option<(bool, Place)> {
        let towards = direction.map(Integer::from);
        let ahead = |&at: &u32| dot(&towards, &self.normals[at as usize]).cmp0();
        // The point can be where two triangles cross: a step within one of them is on a face, not beside it.
        let sides: Vec<_> = triangles.iter().map(ahead).collect();
        let is_front = sides.first()?.is_gt();
        if sides.iter().any(|side| side.is_eq()) {
            return None;
        }
        Some((is_front, self.but_for(triangles, q, direction)?))
    }

    fn but_for(&self, left_out: &[u32], q: &[Rational; 3], direction: [i32; 3]) -> Option<Place> {
        assert_ne!(direction, [0; 3], "a ray has a direction");
        let ray = Ray { from: q.each_ref().map(Rational::to_f64), direction: direction.map(f64::from) };
        let direction = direction.map(Integer::from);
        let weight = q.iter().fold(Integer::from(1), |weight, x| weight.lcm(x.denom()));
        let q = q.each_ref().map(|x| Integer::from(x.numer() * &weight) / x.denom() * &self.scale);
        let meet = |at: usize| {
            let is_missed = || ray.misses(self.materials.triangles[at].map(|v| self.materials.scene.point3(v)));
            // Triangles without area are refused.
            if self.normals[at].iter().any(|x| !x.is_zero()) && is_missed() {
                return Some(Meeting::Missed);
            }
            along(&self.corners[at], &self.normals[at], &q, &weight, &direction)
        };
        let is_left_out = |at: usize| left_out.iter().any(|&other| other as usize == at);
        self.materials.place(|at, _| if is_left_out(at) { Some(Meeting::Missed) } else { meet(at) })
    }
}

/// The meeting with a ray from q over its weight: q + t d = a + v (b - a) + w (c - a), by Cramer's rule.
fn along([a, b, c]: &[Space; 3], normal: &Space, q: &Space, weight: &Integer, direction: &Space) -> Option<Meeting> {
    let determinant = dot(direction, normal);
    let aq = [0, 1, 2].map(|i: usize| &q[i] - Integer::from(&a[i] * weight));
    let height = dot(&aq, normal);
    if determinant.is_zero() {
        // Parallel to the ray: it is missed, unless the point is in its plane.
        return height.cmp0().is_ne().then_some(Meeting::Missed);
    }
    let (ab, ac, turned) = (less(b, a), less(c, a), cross(&aq, direction));
    let (v, w) = (-dot(&ac, &turned), dot(&ab, &turned));
    let u = Integer::from(&determinant * weight) - &v - &w;
    let is_reversed = determinant.cmp0().is_lt();
    let coordinates = [u, v, w].map(|x| if is_reversed { x.cmp0().reverse() } else { x.cmp0() });
    // t has the sign of -height over the determinant.
    let t = if is_reversed { height.cmp0() } else { height.cmp0().reverse() };
    if t.is_lt() || coordinates.iter().any(|coordinate| coordinate.is_lt()) {
        return Some(Meeting::Missed);
    }
    if t.is_eq() {
        return Some(Meeting::On);
    }
    coordinates.iter().all(|coordinate| coordinate.is_gt()).then(|| Meeting::Passed(height.cmp0().is_lt()))
}

fn less(p: &Space, q: &Space) -> Space {
    [0, 1, 2].map(|i: usize| Integer::from(&p[i] - &q[i]))
}

fn cross(p: &Space, q: &Space) -> Space {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k): (usize, usize)| Integer::from(&p[j] * &q[k]) - Integer::from(&p[k] * &q[j]))
}

fn dot(p: &Space, q: &Space) -> Integer {
    (0..3).map(|i| Integer::from(&p[i] * &q[i])).sum()
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Scene, Vertex};

    use super::*;

    #[test]
    fn a_triangle_without_area_is_refused_wherever_the_ray_goes() {
        let corners = [[0.0; 3], [1.0; 3], [3.0; 3], [0.0, 1.0, 0.0]];
        let scene = Scene::from_points3(&corners).expect("finite points");
        for (last, is_refused) in [(2, true), (3, false)] {
            let triangle = [[0, 1, last].map(Vertex::input)];
            let materials = Materials::new(&scene, &triangle, &[[0, 1]]);
            let place = materials.in_integers().winding(&[5, 2, 9].map(Rational::from), [1, 0, 0]);
            assert_eq!(place, (!is_refused).then_some(Place::In(0)));
        }
    }
}
