//! Determinants of rational points, by integers: each point has one denominator, which is a row's weight.
//!
//! A determinant of rows with positive weights has the sign of the determinant of points, and its value is that of the
//! rows over the product of the weights. Integers need no greatest common divisors, on which rationals spend most of
//! their time: only a value is reduced, once.

use std::cell::OnceCell;
use std::cmp::Ordering;

use rug::{Integer, Rational};

use super::exact::Point;

/// A point (x/w, y/w, z/w) with w > 0, as x, y, z, w.
type Row = [Integer; 4];

/// Points over one denominator each, made when they are first needed.
pub struct Rows<'p> {
    points: Vec<&'p Point>,
    rows: Vec<OnceCell<Row>>,
}

fn row(point: &Point) -> Row {
    let weight = point.iter().skip(1).fold(point[0].denom().clone(), |all, x| all.lcm(x.denom()));
    let [x, y, z] = [0, 1, 2].map(|i| Integer::from(&weight / point[i].denom()) * point[i].numer());
    [x, y, z, weight]
}

/// The determinant of two rows, in these columns.
fn two([b, c]: [&Row; 2], i: usize, j: usize) -> Integer {
    Integer::from(&b[i] * &c[j]) - Integer::from(&b[j] * &c[i])
}

/// The determinant of three rows, in these columns.
fn minor([a, b, c]: [&Row; 3], [i, j, k]: [usize; 3]) -> Integer {
    two([b, c], j, k) * &a[i] - two([b, c], i, k) * &a[j] + two([b, c], i, j) * &a[k]
}

/// The plane through three points: the side of a point is the sign of the sum of products with its row.
///
/// Over the product of the weights, the first three components are twice the area vector of the triangle, and the last
/// one is minus six times its volume with the origin.
pub(super) struct Plane(Row);

impl<'p> Rows<'p> {
    /// Points, whose places number the corners of triangles.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = &'p Point>) -> Rows<'p> {
        let points: Vec<&Point> = points.into_iter().collect();
        Rows { rows: points.iter().map(|_| OnceCell::new()).collect(), points }
    }

    fn at(&self, place: u32) -> &Row {
        self.rows[place as usize].get_or_init(|| row(self.points[place as usize]))
    }

    /// The product of the weights of three points.
    fn weight(&self, triangle: [u32; 3]) -> Integer {
        let [a, b, c] = triangle.map(|p| &self.at(p)[3]);
        Integer::from(a * b) * c
    }

    fn component(&self, triangle: [u32; 3], axis: usize) -> Integer {
        minor(triangle.map(|p| self.at(p)), [(axis + 1) % 3, (axis + 2) % 3, 3])
    }

    /// The sign of one component of the area vector of a triangle.
    pub(super) fn area(&self, triangle: [u32; 3], axis: usize) -> Ordering {
        self.component(triangle, axis).cmp0()
    }

    /// One component of twice the area vector of a triangle.
    pub(super) fn area_value(&self, triangle: [u32; 3], axis: usize) -> Rational {
        Rational::from((self.component(triangle, axis), self.weight(triangle)))
    }

    /// Six times the volume of the tetrahedron of a triangle and the origin.
    #[must_use]
    pub fn volume(&self, triangle: [u32; 3]) -> Rational {
        Rational::from((minor(triangle.map(|p| self.at(p)), [0, 1, 2]), self.weight(triangle)))
    }

    /// Three components of twice the area vector of a triangle, and six times its volume with the origin.
    #[must_use]
    pub fn measure(&self, triangle: [u32; 3]) -> [Rational; 4] {
        let Plane([x, y, z, height]) = self.plane(triangle);
        let weight = self.weight(triangle);
        [x, y, z, -height].map(|value| Rational::from((value, weight.clone())))
    }

    pub(super) fn plane(&self, corners: [u32; 3]) -> Plane {
        let [a, b, c] = corners.map(|p| self.at(p));
        let [xy, xz, xw, yz, yw, zw] =
            [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)].map(|(i, j): (usize, usize)| two([b, c], i, j));
        let sum = |x: &Integer, y: &Integer, z: &Integer, [i, j, k]: [usize; 3]| {
            Integer::from(x * &a[i]) - Integer::from(y * &a[j]) + Integer::from(z * &a[k])
        };
        Plane([
            sum(&zw, &yw, &yz, [1, 2, 3]),
            -sum(&zw, &xw, &xz, [0, 2, 3]),
            sum(&yw, &xw, &xy, [0, 1, 3]),
            -sum(&yz, &xz, &xy, [0, 1, 2]),
        ])
    }

    /// The side of a point on a plane: `Greater` in the direction of the normal.
    pub(super) fn side(&self, plane: &Plane, p: u32) -> Ordering {
        let mut sum = Integer::new();
        plane.0.iter().zip(self.at(p)).for_each(|(x, y)| sum += x * y);
        sum.cmp0()
    }
}

impl Plane {
    /// An axis along which the normal is not zero.
    pub(super) fn axis(&self) -> Option<usize> {
        self.0[..3].iter().position(|x| !x.is_zero())
    }

    /// `Greater` if the normals make an acute angle, `Less` for an obtuse one.
    pub(super) fn along(&self, other: &Plane) -> Ordering {
        let mut sum = Integer::new();
        self.0[..3].iter().zip(&other.0).for_each(|(x, y)| sum += x * y);
        sum.cmp0()
    }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::super::exact;
    use super::*;

    /// Points of a small lattice with mixed denominators, so that many are in a plane or on a line, and points that are
    /// a little off: signs are those of rationals.
    #[test]
    fn signs_are_those_of_rationals() {
        let mut state = 11_u64;
        let mut next = |bound: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % bound
        };
        let mut counts = [[0; 3]; 2];
        let place = |sign: Ordering| usize::from(sign.is_ge()) + usize::from(sign.is_gt());
        for _ in 0..3000 {
            let off = Rational::from((next(2), 1_u64 << 60));
            let points: Vec<Point> = (0..4)
                .map(|_| [0, 1, 2].map(|_| Rational::from((next(5), next(2) + 2)) - Rational::from(1) + &off))
                .collect();
            let rows = Rows::of(&points);
            let of_corners = exact::Plane::of([0, 1, 2].map(|at: usize| &points[at]));
            let plane = rows.plane([0, 1, 2]);
            assert_eq!(plane.axis(), of_corners.normal.iter().position(|x| !x.is_zero()));
            let side = rows.side(&plane, 3);
            assert_eq!(side, of_corners.side(&points[3]), "{points:?}");
            counts[0][place(side)] += 1;
            let corners = [1, 2, 3].map(|at: usize| &points[at]);
            let (normal, six) = (exact::normal(corners), exact::volume(corners));
            let along = exact::dot(&normal, &of_corners.normal).cmp0();
            assert_eq!(rows.plane([1, 2, 3]).along(&plane), along, "{points:?}");
            assert_eq!(rows.volume([1, 2, 3]), six, "{points:?}");
            for (axis, value) in normal.iter().enumerate() {
                let sign = rows.area([1, 2, 3], axis);
                assert_eq!((sign, &rows.area_value([1, 2, 3], axis)), (value.cmp0(), value), "{points:?}");
                counts[1][place(sign)] += 1;
            }
            let [x, y, z] = normal;
            assert_eq!(rows.measure([1, 2, 3]), [x, y, z, six], "{points:?}");
        }
        assert!(counts.as_flattened().iter().all(|&count| count > 100), "{counts:?}");
    }
}
