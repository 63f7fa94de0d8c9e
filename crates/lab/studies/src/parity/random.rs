//! Random pairs of simple polygons with features as small as the tolerances.
//!
//! Tolerances are √ε of the primitives' size, so a polygon with corners within tolerances of each other needs long
//! edges too: each polygon has some corners near the origin and one or two far away, at some 2²⁵. With two such
//! polygons L is about 2²⁶ and √ε L about one: near coordinates, multiples of 1/8, are in units of it. In single
//! precision √ε is 2^-11.5 and the far distance is 2^10.5. All coordinates have so few bits that either precision can
//! represent them.

use predicament_corpus::Random;

use super::PolygonPair;
use crate::Precision;

type Point = [f64; 2];
type Polygon = Vec<Point>;

/// The way in which the second polygon is made from the first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Recipe {
    /// A copy with its corners moved, some dropped, some added.
    Copy,
    /// The second polygon has corners planted beside corners and edges of the first.
    Plant,
    /// The second polygon is drawn like the first, and independent of it.
    Free,
}

impl Recipe {
    /// All recipes, in the order of reports.
    pub const ALL: [Recipe; 3] = [Recipe::Copy, Recipe::Plant, Recipe::Free];

    /// The recipe's name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Recipe::Copy => "copy",
            Recipe::Plant => "plant",
            Recipe::Free => "free",
        }
    }
}

/// The largest distance of near corners from the origin, in units of √ε L.
const NEAR: i64 = 20;
/// The denominator of near coordinates.
const PARTS: i64 = 8;
/// The distance of far corners: for L = 2·FAR, √ε L is one, in single precision nearly.
const fn far_away(precision: Precision) -> i64 {
    match precision {
        Precision::Double => 1 << 25,
        Precision::Single => 1448,
    }
}

/// The pair with this number, of the stream of this seed, and the number of refused draws before it.
///
/// A draw is refused if a polygon is not simple. The pairs are nearly degenerate for tolerances in this precision.
#[must_use]
pub fn random_pair(recipe: Recipe, precision: Precision, seed: u64, number: u64) -> (PolygonPair, usize) {
    let stream = match precision {
        Precision::Double => "parity",
        Precision::Single => "parity:f32",
    };
    let rng = Random::new(&format!("{stream}/{}/{number}", recipe.name()), "contacts2d", seed);
    let mut draw = Draw { rng, far: far_away(precision) };
    let mut refused = 0;
    loop {
        let first = draw.polygon();
        let second = match recipe {
            Recipe::Copy => draw.copy(&first),
            Recipe::Plant => draw.plant(&first),
            Recipe::Free => draw.polygon(),
        };
        let pair = PolygonPair { polygons: [first, second] };
        if pair.is_simple() {
            return (pair, refused);
        }
        refused += 1;
    }
}

/// A stream of random corners.
struct Draw {
    rng: Random,
    /// The distance of far corners.
    far: i64,
}

impl Draw {
    fn polygon(&mut self) -> Polygon {
        let near = self.rng.integer(2, 4);
        let far = self.rng.integer(1, 2);
        let mut corners: Polygon = (0..near).map(|_| self.near_point()).collect();
        for _ in 0..far {
            corners.push(self.far_point());
        }
        self.shuffle(&mut corners);
        corners
    }

    fn copy(&mut self, first: &[Point]) -> Polygon {
        let mut corners: Polygon = Vec::new();
        for &corner in first {
            if !self.rng.one_in(6) {
                corners.push(self.beside(corner));
            }
            if self.rng.one_in(5) {
                corners.push(self.near_point());
            }
        }
        while corners.len() < 3 {
            corners.push(self.far_point());
        }
        corners
    }

    fn plant(&mut self, first: &[Point]) -> Polygon {
        let mut corners: Polygon = (0..self.rng.integer(2, 4))
            .map(|_| {
                let at = self.pick(first.len());
                let [from, to] = [first[at], first[(at + 1) % first.len()]];
                let near = if self.rng.one_in(2) { from } else { self.along(from, to) };
                self.beside(near)
            })
            .collect();
        let far = if self.rng.one_in(2) {
            self.far_point()
        } else {
            let at = self.pick(first.len());
            self.beside(first[at])
        };
        corners.push(far);
        self.shuffle(&mut corners);
        corners
    }

    /// A point of an edge not far from its first end, up to rounding to an eighth.
    fn along(&mut self, from: Point, to: Point) -> Point {
        let u = [to[0] - from[0], to[1] - from[1]];
        let largest = u[0].abs().max(u[1].abs()).max(1.0);
        let fraction = (self.rng.between(0.0, 40.0) / largest).min(1.0);
        [0, 1].map(|axis| eighths(from[axis] + fraction * u[axis]))
    }

    /// The same point, or one within 1.5 σ of it in each coordinate.
    fn beside(&mut self, p: Point) -> Point {
        if self.rng.one_in(5) {
            return p;
        }
        let reach = 10 * PARTS;
        p.map(|x| x + parts(self.rng.integer(-reach, reach)))
    }

    fn near_point(&mut self) -> Point {
        [0; 2].map(|_| parts(self.rng.integer(-NEAR * PARTS, NEAR * PARTS)))
    }

    /// A random point on the border of a square around the origin.
    ///
    /// Small slopes of its direction are as likely as large ones.
    fn far_point(&mut self) -> Point {
        let far = parts(self.far * PARTS);
        let along = if self.rng.one_in(2) {
            self.near_point()[0]
        } else {
            parts(self.rng.integer(-self.far, self.far) * PARTS)
        };
        let far = if self.rng.one_in(2) { far } else { -far };
        if self.rng.one_in(2) { [far, along] } else { [along, far] }
    }

    fn pick(&mut self, count: usize) -> usize {
        let last = i64::try_from(count).expect("few corners") - 1;
        usize::try_from(self.rng.integer(0, last)).expect("not negative")
    }

    fn shuffle(&mut self, corners: &mut [Point]) {
        for at in (1..corners.len()).rev() {
            corners.swap(at, self.pick(at + 1));
        }
    }
}

/// A number of eighths; exact for all numbers used here.
fn parts(count: i64) -> f64 {
    #[allow(clippy::cast_precision_loss)] // at most 2^29
    let (count, parts) = (count as f64, PARTS as f64);
    count / parts
}

fn eighths(x: f64) -> f64 {
    (x * 8.0).round() / 8.0
}
