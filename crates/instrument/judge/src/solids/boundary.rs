//! Location of points relative to solids with rational corners, such as the results of operations that construct
//! vertices.

use std::cmp::Ordering;
use std::sync::OnceLock;

use rug::{Integer, Rational};

use crate::integers::over_one_denominator;
use crate::row::Row;

type Point = [Rational; 3];

/// A closed surface whose triangles are counterclockwise as seen from outside.
pub struct Boundary {
    points: Vec<Point>,
    /// The points over one denominator each, made when they are first needed.
    rows: Vec<OnceLock<Row>>,
    triangles: Vec<[u32; 3]>,
    /// A box of doubles around each triangle: the least and the largest of each coordinate, rounded outwards.
    boxes: Vec<[[f64; 2]; 3]>,
}

impl Boundary {
    /// The surface with these triangles, as indices of points.
    ///
    /// # Panics
    /// If a point does not exist.
    #[must_use]
    pub fn new(points: Vec<Point>, triangles: Vec<[u32; 3]>) -> Boundary {
        let rounded: Vec<[f64; 3]> = points.iter().map(|point| point.each_ref().map(Rational::to_f64)).collect();
        let around = |triangle: &[u32; 3]| {
            let corners = triangle.map(|corner| rounded[corner as usize]);
            [0, 1, 2].map(|axis: usize| {
                let along = corners.map(|corner| corner[axis]);
                // The conversion rounds toward zero, by less than one step between doubles.
                let low = along.iter().fold(f64::INFINITY, |low, &x| low.min(x)).next_down();
                let high = along.iter().fold(f64::NEG_INFINITY, |high, &x| high.max(x)).next_up();
                [low, high]
            })
        };
        let boxes = triangles.iter().map(around).collect();
        let rows = points.iter().map(|_| OnceLock::new()).collect();
        Boundary { points, rows, triangles, boxes }
    }

    fn corners(&self, triangle: [u32; 3]) -> [&Point; 3] {
        triangle.map(|corner| &self.points[corner as usize])
    }

    fn row(&self, corner: u32) -> &Row {
        self.rows[corner as usize].get_or_init(|| {
            let point = &self.points[corner as usize];
            let weight = point.iter().fold(Integer::from(1), |all, x| all.lcm(x.denom()));
            let coordinates = point.iter().map(|x| Integer::from(&weight / x.denom()) * x.numer()).collect();
            Row { coordinates, weight }
        })
    }

    /// The winding number of the surface around a point, by a ray to larger x: 1 inside of a solid, 0 outside.
    ///
    /// Returns `None` if the ray touches the border of a triangle, or the point is on a triangle.
    #[must_use]
    pub fn winding(&self, q: [f64; 3]) -> Option<i64> {
        let (coordinates, weight) = over_one_denominator(&q);
        let exact = Row { coordinates, weight };
        let mut winding = 0;
        for (&triangle, [along_x, beside @ ..]) in self.triangles.iter().zip(&self.boxes) {
            let is_beside = beside.iter().zip(&q[1..]).any(|([low, high], x)| x < low || high < x);
            if is_beside || along_x[1] < q[0] {
                continue;
            }
            winding += passed(triangle.map(|corner| self.row(corner)), &exact)?;
        }
        Some(winding)
    }

    /// True if a triangle whose box, enlarged by `distance`, holds the point has its plane within `distance` of the
    /// point.
    ///
    /// It is true for every point within `distance` of the surface.
    #[must_use]
    pub fn is_near(&self, q: [f64; 3], distance: f64) -> bool {
        let exact = q.map(crate::rational);
        let squared = crate::rational(distance).square();
        self.triangles.iter().zip(&self.boxes).any(|(&triangle, bounds)| {
            let is_in = bounds
                .iter()
                .zip(q)
                .all(|([low, high], x)| (low - distance).next_down() <= x && x <= (high + distance).next_up());
            if !is_in {
                return false;
            }
            let [a, b, c] = self.corners(triangle);
            let minus = |p: &Point, q: &Point| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
            let [u, v, w] = [minus(b, a), minus(c, a), minus(&exact, a)];
            let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
            let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
            let along: Rational = normal.iter().zip(&w).map(|(x, y)| Rational::from(x * y)).sum();
            let length: Rational = normal.iter().map(|x| Rational::from(x * x)).sum();
            along.square() <= length * &squared
        })
    }
}

/// The crossing of the ray with a triangle: 1 if it leaves the solid, −1 if it enters, 0 if it misses.
///
/// Returns `None` if the crossing is degenerate. Only signs matter: differences to q are multiplied by both weights,
/// which are positive, so that no fraction is reduced. Each turn has the weights of two corners, and its product with
/// the third corner has all three.
fn passed([a, b, c]: [&Row; 3], q: &Row) -> Option<i64> {
    let less = |p: &Row| {
        [0, 1, 2].map(|i: usize| Integer::from(&p.coordinates[i] * &q.weight) - &q.coordinates[i] * &p.weight)
    };
    let [a, b, c] = [less(a), less(b), less(c)];
    let turn = |u: &[Integer; 3], v: &[Integer; 3]| Integer::from(&u[1] * &v[2]) - &u[2] * &v[1];
    let turns = [turn(&b, &c), turn(&c, &a), turn(&a, &b)];
    let signs = turns.each_ref().map(Integer::cmp0);
    if signs.contains(&Ordering::Less) && signs.contains(&Ordering::Greater) {
        return Some(0);
    }
    if signs.contains(&Ordering::Equal) {
        return None;
    }
    // At the point where the ray meets the plane, x is the mean of the corners' x, weighted by `turns`, which have one
    // sign.
    let [u, v, w] = &turns;
    let along = Integer::from(u * &a[0]) + v * &b[0] + w * &c[0];
    let ahead = if signs[0] == Ordering::Greater { along.cmp0() } else { along.cmp0().reverse() };
    match ahead {
        Ordering::Less => Some(0),
        Ordering::Equal => None,
        // Counterclockwise in y and z: the normal has a positive x, and the ray leaves.
        Ordering::Greater => Some(if signs[0] == Ordering::Greater { 1 } else { -1 }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tetrahedra with rational corners, and points inside or outside by the signs of four determinants.
    #[test]
    fn tetrahedra_wind_once_around_their_inside() {
        let mut state = 17_u64;
        let mut next = |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u32::try_from(state >> 33).expect("31 bits") % bound
        };
        let mut counts = [0; 2];
        for _ in 0..3000 {
            let mut corners: Vec<Point> =
                (0..4).map(|_| [0, 1, 2].map(|_| Rational::from((next(90), next(9) + 1)))).collect();
            let side = |[a, b, c]: [&Point; 3], p: &Point| {
                let row = |q: &Point| (0..3).map(|i| Rational::from(&q[i] - &p[i])).collect();
                crate::determinant(&[row(a), row(b), row(c)]).cmp0()
            };
            // The last corner is behind the first three.
            if side([&corners[0], &corners[1], &corners[2]], &corners[3]).is_lt() {
                corners.swap(0, 1);
            }
            let triangles = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
            let boundary = Boundary::new(corners.clone(), triangles.clone());
            let q = [0, 1, 2].map(|_| f64::from(next(400)) / 16.0);
            let exact = q.map(crate::rational);
            let sides = triangles.iter().map(|t| side(t.map(|p: u32| &corners[p as usize]), &exact));
            let sides: Vec<Ordering> = sides.collect();
            if sides.contains(&Ordering::Equal) {
                continue;
            }
            let is_inside = sides.iter().all(|side| side.is_gt());
            if let Some(winding) = boundary.winding(q) {
                assert_eq!(winding, i64::from(is_inside), "{corners:?} {q:?}");
                counts[usize::from(is_inside)] += 1;
            }
        }
        assert!(counts.iter().all(|&count| count > 50), "{counts:?}");
    }
}
