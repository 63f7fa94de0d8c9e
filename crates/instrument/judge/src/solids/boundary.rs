//! Points in solids whose corners are rational: the results of operations, with vertices that were constructed.

use std::cmp::Ordering;

use rug::Rational;

type Point = [Rational; 3];

/// A closed surface, counterclockwise as seen from outside.
pub struct Boundary {
    triangles: Vec<[Point; 3]>,
    /// For each what doubles say for sure: the least and the largest of each coordinate, rounded away from it.
    boxes: Vec<[[f64; 2]; 3]>,
}

impl Boundary {
    /// A surface of these triangles.
    #[must_use]
    pub fn new(triangles: Vec<[Point; 3]>) -> Boundary {
        let around = |triangle: &[Point; 3]| {
            [0, 1, 2].map(|axis: usize| {
                let along = triangle.each_ref().map(|corner| corner[axis].to_f64());
                // Conversion rounds toward zero, by less than a step.
                let low = along.iter().fold(f64::INFINITY, |low, &x| low.min(x)).next_down();
                let high = along.iter().fold(f64::NEG_INFINITY, |high, &x| high.max(x)).next_up();
                [low, high]
            })
        };
        let boxes = triangles.iter().map(around).collect();
        Boundary { triangles, boxes }
    }

    /// How often the surface goes around a point, by a ray to larger x: once inside of a solid, and not at all outside. None where the
    /// ray touches the border of a triangle, or the point is on one.
    #[must_use]
    pub fn winding(&self, q: [f64; 3]) -> Option<i64> {
        let exact = q.map(crate::rational);
        let mut winding = 0;
        for (triangle, [along_x, beside @ ..]) in self.triangles.iter().zip(&self.boxes) {
            let is_beside = beside.iter().zip(&q[1..]).any(|([low, high], x)| x < low || high < x);
            if is_beside || along_x[1] < q[0] {
                continue;
            }
            winding += passed(triangle, &exact)?;
        }
        Some(winding)
    }

    /// Whether a point is at most this far from the plane of a triangle in whose box it is, the box being larger by as much: each point that is
    /// nearer to the surface is.
    #[must_use]
    pub fn is_near(&self, q: [f64; 3], distance: f64) -> bool {
        let exact = q.map(crate::rational);
        let squared = crate::rational(distance).square();
        self.triangles.iter().zip(&self.boxes).any(|([a, b, c], bounds)| {
            let is_in = bounds
                .iter()
                .zip(q)
                .all(|([low, high], x)| (low - distance).next_down() <= x && x <= (high + distance).next_up());
            if !is_in {
                return false;
            }
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

/// 1 where the ray leaves the solid here, -1 where it enters, 0 where it passes beside; none where that is not told apart.
fn passed([a, b, c]: &[Point; 3], q: &Point) -> Option<i64> {
    let less = |p: &Point| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
    let [a, b, c] = [less(a), less(b), less(c)];
    let turn = |u: &Point, v: &Point| Rational::from(&u[1] * &v[2]) - Rational::from(&u[2] * &v[1]);
    let turns = [turn(&b, &c), turn(&c, &a), turn(&a, &b)];
    let signs = turns.each_ref().map(Rational::cmp0);
    if signs.contains(&Ordering::Less) && signs.contains(&Ordering::Greater) {
        return Some(0);
    }
    if signs.contains(&Ordering::Equal) {
        return None;
    }
    // Where the ray meets the plane x is the middle of the corners' by these weights, which are of one sign.
    let [u, v, w] = &turns;
    let along = Rational::from(u * &a[0]) + Rational::from(v * &b[0]) + Rational::from(w * &c[0]);
    let ahead = if signs[0] == Ordering::Greater { along.cmp0() } else { along.cmp0().reverse() };
    match ahead {
        Ordering::Less => Some(0),
        Ordering::Equal => None,
        // Counterclockwise in y and z: the normal has a positive x, and the ray leaves.
        Ordering::Greater => Some(if signs[0] == Ordering::Greater { 1 } else { -1 }),
    }
}
