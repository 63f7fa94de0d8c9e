//! Signs of determinants of rational points, by integers: each point has one denominator, which is a row's weight.
//!
//! A determinant of rows with positive weights has the sign of the determinant of points. Integers need no greatest
//! common divisors, on which rationals spend most of their time.

use std::cell::OnceCell;
use std::cmp::Ordering;

use rug::Integer;

use super::exact::Point;

/// A point (x/w, y/w, z/w) with w > 0, as x, y, z, w.
type Row = [Integer; 4];

/// Points as rows, each made when it is first needed.
pub(super) struct Rows<'p> {
    points: &'p [Point],
    rows: Vec<OnceCell<Row>>,
}

fn row(point: &Point) -> Row {
    let weight = point.iter().skip(1).fold(point[0].denom().clone(), |all, x| all.lcm(x.denom()));
    let [x, y, z] = [0, 1, 2].map(|i| Integer::from(&weight / point[i].denom()) * point[i].numer());
    [x, y, z, weight]
}

/// The determinant of three rows, in these columns.
fn minor(rows: [&Row; 3], [i, j, k]: [usize; 3]) -> Integer {
    let [a, b, c] = rows;
    let two = |i: usize, j: usize| Integer::from(&b[i] * &c[j]) - Integer::from(&b[j] * &c[i]);
    two(j, k) * &a[i] - two(i, k) * &a[j] + two(i, j) * &a[k]
}

/// The plane through three points: the side of a point is the sign of the sum of products with its row.
pub(super) struct Plane(Row);

impl<'p> Rows<'p> {
    pub(super) fn of(points: &'p [Point]) -> Rows<'p> {
        Rows { points, rows: points.iter().map(|_| OnceCell::new()).collect() }
    }

    fn at(&self, place: u32) -> &Row {
        self.rows[place as usize].get_or_init(|| row(&self.points[place as usize]))
    }

    /// The sign of one component of the area vector of a triangle.
    pub(super) fn area(&self, triangle: [u32; 3], axis: usize) -> Ordering {
        minor(triangle.map(|p| self.at(p)), [(axis + 1) % 3, (axis + 2) % 3, 3]).cmp0()
    }

    pub(super) fn plane(&self, corners: [u32; 3]) -> Plane {
        let rows = corners.map(|p| self.at(p));
        Plane([minor(rows, [1, 2, 3]), -minor(rows, [0, 2, 3]), minor(rows, [0, 1, 3]), -minor(rows, [0, 1, 2])])
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
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::super::exact::{self, area};
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
            assert_eq!(plane.axis(), of_corners.axis());
            let side = rows.side(&plane, 3);
            assert_eq!(side, of_corners.side(&points[3]), "{points:?}");
            counts[0][place(side)] += 1;
            for axis in 0..3 {
                let sign = rows.area([1, 2, 3], axis);
                assert_eq!(sign, area([1, 2, 3].map(|at: usize| &points[at]), axis).cmp0(), "{points:?}");
                counts[1][place(sign)] += 1;
            }
        }
        assert!(counts.as_flattened().iter().all(|&count| count > 100), "{counts:?}");
    }
}
