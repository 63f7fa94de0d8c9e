//! The outer faces of a solid in rationals: where they meet, and on which side of them the solid is.

use std::cmp::Ordering;

use predicament_mesh::{MaterialMesh, OUTSIDE};
use rug::Rational;

use super::Point;

/// Directions of rays; usually at least one misses all edges.
const DIRECTIONS: [[i32; 3]; 6] =
    [[83, 31, 17], [-29, 71, 43], [13, -47, 97], [-61, -7, 89], [101, 53, -67], [-37, 113, -19]];

pub(super) fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i: usize| Rational::from(&a[i] - &b[i]))
}

pub(super) fn dot(a: &Point, b: &Point) -> Rational {
    (0..3).map(|i| Rational::from(&a[i] * &b[i])).sum()
}

pub(super) fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| Rational::from(&a[i] * &b[j]) - Rational::from(&a[j] * &b[i]))
}

/// The point at a multiple of a direction from a point.
pub(super) fn moved(p: &Point, way: &Point, by: &Rational) -> Point {
    [0, 1, 2].map(|i: usize| Rational::from(&way[i] * by) + &p[i])
}

pub(super) fn is_null(p: &Point) -> bool {
    p.iter().all(Rational::is_zero)
}

/// A triangle with the outside on one side and the solid on the other.
pub(super) struct Face {
    /// Its index in the mesh.
    pub at: u32,
    pub corners: [Point; 3],
    /// Its normal, away from the side on which its corners are clockwise.
    pub normal: Point,
    /// The height of its plane along the normal.
    height: Rational,
    /// True if the solid is on the side of the normal.
    pub is_inward: bool,
    /// Its box.
    bounds: [[Rational; 2]; 3],
}

impl Face {
    /// The outer faces of a mesh over these points.
    pub fn all(points: &[Point], mesh: &MaterialMesh) -> Vec<Face> {
        let each = mesh.triangles().iter().zip(mesh.sides()).zip(0..);
        let face = |((triangle, sides), at): ((&[predicament_predicates::Vertex; 3], &[u32; 2]), u32)| {
            let is_inside = sides.map(|region| region != OUTSIDE);
            let corners = triangle.map(|v| points[v.index()].clone());
            let [a, b, c] = &corners;
            let normal = cross(&minus(b, a), &minus(c, a));
            let height = dot(&normal, a);
            let bounds = bounds(&corners);
            (is_inside[0] != is_inside[1]).then(|| Face {
                at,
                corners,
                normal,
                height,
                is_inward: is_inside[0],
                bounds,
            })
        };
        each.filter_map(face).collect()
    }

    /// The height of a point above the plane.
    pub fn above(&self, p: &Point) -> Rational {
        dot(&self.normal, p) - &self.height
    }

    /// The corners of each edge.
    pub fn edges(&self) -> [[&Point; 2]; 3] {
        let [a, b, c] = &self.corners;
        [[a, b], [b, c], [c, a]]
    }

    /// For an edge, the position of a point across it: positive on the side of the triangle.
    pub fn across(&self, [a, b]: [&Point; 2], p: &Point) -> Rational {
        dot(&cross(&self.normal, &minus(b, a)), &minus(p, a))
    }

    /// True if the boxes of a polygon and of the face meet.
    pub fn is_near(&self, others: &[[Rational; 2]; 3]) -> bool {
        self.bounds.iter().zip(others).all(|([low, high], [from, to])| low <= to && from <= high)
    }

    /// True if the closed triangle contains a point.
    pub fn contains(&self, p: &Point) -> bool {
        self.bounds.iter().zip(p).all(|([low, high], x)| low <= x && x <= high)
            && self.above(p).is_zero()
            && self.edges().iter().all(|&edge| self.across(edge, p) >= 0)
    }

    /// The intersection of two closed triangles: nothing, a point, a segment, or the corners of a polygon in order.
    pub fn common(&self, other: &Face) -> Vec<Point> {
        if !self.is_near(&other.bounds) {
            return Vec::new();
        }
        let mut polygon = clipped(&self.corners, &|p| other.above(p));
        polygon = clipped(&polygon, &|p| -other.above(p));
        for edge in other.edges() {
            polygon = clipped(&polygon, &|p| other.across(edge, p));
        }
        let is_flat = polygon.iter().skip(2).all(|p| {
            let [first, second] = [&polygon[0], &polygon[1]];
            is_null(&cross(&minus(second, first), &minus(p, first)))
        });
        if is_flat && polygon.len() > 1 {
            // Points of one line are in the order of their coordinates.
            polygon.sort();
            polygon.dedup();
            let last = polygon.pop();
            polygon.truncate(1);
            polygon.extend(last);
        }
        polygon
    }
}

/// The box of points.
pub(super) fn bounds(points: &[Point]) -> [[Rational; 2]; 3] {
    [0, 1, 2].map(|axis: usize| {
        let along = || points.iter().map(|p| &p[axis]);
        [along().min(), along().max()].map(|x| x.cloned().unwrap_or_default())
    })
}

/// The part of a convex polygon, which may be a segment or a point, where a linear value is not negative.
fn clipped(polygon: &[Point], value: &dyn Fn(&Point) -> Rational) -> Vec<Point> {
    let values: Vec<Rational> = polygon.iter().map(value).collect();
    let mut all: Vec<Point> = Vec::new();
    for at in 0..polygon.len() {
        let next = (at + 1) % polygon.len();
        if values[at] >= 0 {
            all.push(polygon[at].clone());
        }
        if values[at].cmp0() != Ordering::Equal && values[at].cmp0() == values[next].cmp0().reverse() {
            let part = &values[at] / Rational::from(&values[at] - &values[next]);
            all.push(moved(&polygon[at], &minus(&polygon[next], &polygon[at]), &part));
        }
    }
    all.dedup();
    if all.len() > 1 && all.first() == all.last() {
        all.pop();
    }
    all
}

/// True if a point that is on no face of a solid is inside of it; `None` if each ray meets an edge.
pub(super) fn is_inside(faces: &[Face], p: &Point) -> Option<bool> {
    let along = |direction: &Point| -> Option<i64> {
        let mut winding = 0;
        for face in faces {
            let slope = dot(&face.normal, direction);
            if slope.is_zero() {
                continue;
            }
            let part = -face.above(p) / &slope;
            if part < 0 {
                continue;
            }
            let there = moved(p, direction, &part);
            let across = face.edges().map(|edge| face.across(edge, &there).cmp0());
            if across.contains(&Ordering::Less) {
                continue;
            }
            if across.contains(&Ordering::Equal) {
                return None;
            }
            winding += if face.is_inward == (slope > 0) { -1 } else { 1 };
        }
        Some(winding)
    };
    DIRECTIONS.iter().find_map(|way| along(&way.map(Rational::from))).map(|winding| winding == 1)
}
