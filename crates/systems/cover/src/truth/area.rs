//! Areas of triangles on a loop, as integers.
//!
//! Coordinates become integers over one denominator. The cross product of two edges is then a vector of integers, and
//! twice the area is its length. Areas are these lengths with 64 more bits, rounded down: their relative error is below
//! 2^-64, since lengths that are not zero are at least 1.

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use rug::{Integer, Rational};

use super::Corners;

/// The bits of an area behind the point.
const BITS: u32 = 64;

/// The areas of the triangles on a loop.
#[derive(Debug)]
pub struct Areas {
    points: Vec<[Integer; 3]>,
    /// At `place`, twice the area of each triangle.
    twice: Vec<Integer>,
    /// The least sum of areas of the polygon beyond the edge from place i to place k, at i·n + k.
    least: Vec<Integer>,
}

impl Areas {
    /// Computes the areas of all triangles on a loop.
    #[must_use]
    pub fn new(scene: &Scene, around: &[Vertex]) -> Areas {
        let exact: Vec<[Rational; 3]> = around.iter().map(|&v| scene.point3(v).map(rational)).collect();
        let mut denominator = Integer::from(1);
        exact.as_flattened().iter().for_each(|x| denominator.lcm_mut(x.denom()));
        let whole = |x: &Rational| Integer::from(&denominator / x.denom()) * x.numer();
        let points: Vec<[Integer; 3]> = exact.iter().map(|p| [0, 1, 2].map(|axis| whole(&p[axis]))).collect();
        let n = points.len();
        let mut areas = Areas { points, twice: Vec::with_capacity(n * n * n / 6), least: Vec::new() };
        for c in 0..n {
            for b in 0..c {
                for a in 0..b {
                    let length = areas.normal([a, b, c]).iter().map(|x| Integer::from(x * x)).sum::<Integer>();
                    areas.twice.push((length << (2 * BITS)).sqrt());
                }
            }
        }
        areas.fill();
        areas
    }

    /// The number of points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// Twice the area of a triangle.
    #[must_use]
    pub fn twice(&self, [a, b, c]: Corners) -> &Integer {
        &self.twice[c * c.saturating_sub(1) * c.saturating_sub(2) / 6 + b * b.saturating_sub(1) / 2 + a]
    }

    /// The least area of the polygon beyond the edge from place i to place k, of all its triangulations.
    #[must_use]
    pub fn least(&self, [i, k]: [usize; 2]) -> &Integer {
        &self.least[i * self.count() + k]
    }

    /// The difference that rounding can make between covers that an algorithm of doubles takes for equal, in the unit
    /// of areas: twice the error bound of `algorithm/area.rs`, which is 2(n − 2)(n + 4)·2^-53·D² for the largest
    /// distance D of two points.
    #[must_use]
    pub fn slack(&self) -> Integer {
        let n = self.count() as u64;
        let square = |p: &[Integer; 3], q: &[Integer; 3]| -> Integer {
            p.iter().zip(q).map(|(x, y)| Integer::from(x - y).square()).sum()
        };
        let pairs = self.points.iter().flat_map(|p| self.points.iter().map(move |q| square(p, q)));
        let largest = pairs.max().unwrap_or_default();
        // Each of the n − 2 areas here is rounded down by less than one.
        ((largest * (4 * (n - 2) * (n + 4))) << (BITS - 53)) + n
    }

    fn normal(&self, [a, b, c]: Corners) -> [Integer; 3] {
        let edge = |to: usize| [0, 1, 2].map(|axis| Integer::from(&self.points[to][axis] - &self.points[a][axis]));
        let [u, v] = [edge(b), edge(c)];
        [[1, 2], [2, 0], [0, 1]].map(|[i, j]: [usize; 2]| Integer::from(&u[i] * &v[j]) - Integer::from(&u[j] * &v[i]))
    }

    /// Fills `least`, from the last place backwards.
    fn fill(&mut self) {
        let n = self.count();
        self.least = vec![Integer::new(); n * n];
        for i in (0..n).rev() {
            for k in i + 2..n {
                let cut = |j: usize| Integer::from(self.least([i, j]) + self.least([j, k])) + self.twice([i, j, k]);
                self.least[i * n + k] = (i + 1..k).map(cut).min().unwrap_or_default();
            }
        }
    }
}
