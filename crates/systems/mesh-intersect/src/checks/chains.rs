//! Sums of oriented triangles and of segments, compared in rationals.
//!
//! Two lists of triangles are the same surface, however each divides it, if and only if the sum of one less the other
//! is zero: in each plane every point is covered as often from one side as from the other. A sum of triangles in a
//! plane is zero if and only if its border is, because it is bounded; the border is a sum of segments. A sum of
//! segments in a line is zero if and only if its ends cancel. So each triangle adds 1 at the end and −1 at the start of
//! each of its edges, for its plane and the edge's line, and all of these sums have to be zero. It takes neither
//! intersections nor areas.

use std::collections::BTreeMap;

use rug::Rational;

use super::Point;
use crate::truth::contacts::line;

/// A plane: the axis along which its normal's component is one, the other two components, and the height.
type Plane = (usize, Point);
type Line = (usize, Point, Point);

/// The plane of a triangle; `None` if it has no area.
pub(super) fn plane([a, b, c]: [&Point; 3]) -> Option<(Plane, Rational)> {
    let minus = |p: &Point| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &a[i]));
    let [u, v] = [minus(b), minus(c)];
    let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
    let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
    let axis = normal.iter().position(|x| !x.is_zero())?;
    let area = normal[axis].clone();
    let mut plane = normal.map(|x| x / &area);
    let height = plane.iter().zip(a).map(|(x, y)| Rational::from(x * y)).sum();
    // Its component along the axis is one.
    plane[axis] = height;
    Some(((axis, plane), area))
}

/// The corners of a triangle in ascending order, and true if this turns the triangle over.
pub(super) fn ascending<T: Ord + Copy>(mut corners: [T; 3]) -> ([T; 3], bool) {
    let least = (0..3).min_by_key(|&at| corners[at]).unwrap_or_default();
    corners.rotate_left(least);
    let is_turned = corners[1] > corners[2];
    if is_turned {
        corners.swap(1, 2);
    }
    (corners, is_turned)
}

/// A sum of oriented triangles.
#[derive(Clone, Default, Debug)]
pub struct Chain {
    numbers: BTreeMap<Point, usize>,
    /// For corners in ascending order, the number of triangles with this orientation less those with the other.
    triangles: BTreeMap<[usize; 3], i64>,
}

impl Chain {
    /// Adds a triangle so many times.
    pub fn add(&mut self, corners: [&Point; 3], times: i64) {
        let numbers = corners.map(|p| {
            let next = self.numbers.len();
            if let Some(&known) = self.numbers.get(p) { known } else { *self.numbers.entry(p.clone()).or_insert(next) }
        });
        let (numbers, is_turned) = ascending(numbers);
        *self.triangles.entry(numbers).or_default() += if is_turned { -times } else { times };
    }

    /// A point at the border of a place where the sum is not zero; `None` if the sum is zero.
    #[must_use]
    pub fn rest(&self) -> Option<[f64; 3]> {
        let mut points: Vec<(usize, &Point)> = self.numbers.iter().map(|(point, &number)| (number, point)).collect();
        points.sort_unstable_by_key(|(number, _)| *number);
        let points: Vec<&Point> = points.into_iter().map(|(_, point)| point).collect();
        let mut ends: BTreeMap<(Plane, Line, usize), i64> = BTreeMap::new();
        for (&[a, b, c], &times) in self.triangles.iter().filter(|(_, times)| **times != 0) {
            let Some((plane, _)) = plane([a, b, c].map(|at| points[at])) else { continue };
            for [from, to] in [[a, b], [b, c], [c, a]] {
                let line = line([points[from], points[to]]);
                *ends.entry((plane.clone(), line.clone(), to)).or_default() += times;
                *ends.entry((plane.clone(), line, from)).or_default() -= times;
            }
        }
        let (&(.., at), _) = ends.iter().find(|(_, sum)| **sum != 0)?;
        Some(points[at].each_ref().map(Rational::to_f64))
    }
}

/// A sum of segments without orientation.
#[derive(Clone, Default, Debug)]
pub struct Segments(BTreeMap<(Line, Point), i64>);

impl Segments {
    /// Adds a segment so many times; a segment of one point adds nothing.
    pub fn add(&mut self, ends: [&Point; 2], times: i64) {
        let [low, high] = if ends[0] <= ends[1] { ends } else { [ends[1], ends[0]] };
        if low != high {
            let line = line([low, high]);
            *self.0.entry((line.clone(), high.clone())).or_default() += times;
            *self.0.entry((line, low.clone())).or_default() -= times;
        }
    }

    /// An end of a place where the sum is not zero; `None` if the sum is zero.
    #[must_use]
    pub fn rest(&self) -> Option<[f64; 3]> {
        let ((_, at), _) = self.0.iter().find(|(_, sum)| **sum != 0)?;
        Some(at.each_ref().map(Rational::to_f64))
    }
}
