//! Random pairs of simple polygons with features as small as the tolerances.
//!
//! Tolerances are √ε of the primitives' size, so a polygon that is to have
//! corners within them of each other needs long edges too: each has some
//! corners near the origin and one or two far away, at some 2²⁵. With two such
//! polygons L is about 2²⁶ and √ε L about one: near coordinates, multiples of
//! 1/8, are in units of it.

use predicament_corpus::Random;

use super::PolygonPair;

type Point = [f64; 2];
type Polygon = Vec<Point>;

/// How the second polygon is made from the first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Recipe {
    /// A copy with its corners moved, some dropped, some added.
    Copy,
    /// Corners planted beside corners and edges of the first.
    Plant,
    /// On its own.
    Free,
}

impl Recipe {
    /// All three.
    pub const ALL: [Recipe; 3] = [Recipe::Copy, Recipe::Plant, Recipe::Free];

    /// The name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Recipe::Copy => "copy",
            Recipe::Plant => "plant",
            Recipe::Free => "free",
        }
    }
}

/// Where near corners are: within this of the origin, in units of √ε L.
const NEAR: i64 = 20;
/// Near coordinates are multiples of one over this.
const PARTS: i64 = 8;
/// Where far corners are.
const FAR: i64 = 1 << 25;

/// The pair with this number, of the stream of this seed, and how many draws
/// before it were refused because one of the polygons was not simple.
#[must_use]
pub fn random_pair(recipe: Recipe, seed: u64, number: u64) -> (PolygonPair, usize) {
    let mut rng = Random::new(&format!("parity/{}/{number}", recipe.name()), "contacts2d", seed);
    let mut refused = 0;
    loop {
        let first = polygon(&mut rng);
        let second = match recipe {
            Recipe::Copy => copy(&first, &mut rng),
            Recipe::Plant => plant(&first, &mut rng),
            Recipe::Free => polygon(&mut rng),
        };
        let pair = PolygonPair { polygons: [first, second] };
        if pair.is_simple() {
            return (pair, refused);
        }
        refused += 1;
    }
}

fn polygon(rng: &mut Random) -> Polygon {
    let near = rng.integer(2, 4);
    let far = rng.integer(1, 2);
    let mut corners: Polygon = (0..near).map(|_| near_point(rng)).collect();
    for _ in 0..far {
        corners.push(far_point(rng));
    }
    shuffle(&mut corners, rng);
    corners
}

fn copy(first: &[Point], rng: &mut Random) -> Polygon {
    let mut corners: Polygon = Vec::new();
    for &corner in first {
        if !rng.one_in(6) {
            corners.push(beside(corner, rng));
        }
        if rng.one_in(5) {
            corners.push(near_point(rng));
        }
    }
    while corners.len() < 3 {
        corners.push(far_point(rng));
    }
    corners
}

fn plant(first: &[Point], rng: &mut Random) -> Polygon {
    let mut corners: Polygon = (0..rng.integer(2, 4))
        .map(|_| {
            let at = pick(first.len(), rng);
            let [from, to] = [first[at], first[(at + 1) % first.len()]];
            let near = if rng.one_in(2) { from } else { along(from, to, rng) };
            beside(near, rng)
        })
        .collect();
    let far = if rng.one_in(2) { far_point(rng) } else { beside(first[pick(first.len(), rng)], rng) };
    corners.push(far);
    shuffle(&mut corners, rng);
    corners
}

/// A point of an edge not far from its first end, up to rounding to an eighth.
fn along(from: Point, to: Point, rng: &mut Random) -> Point {
    let u = [to[0] - from[0], to[1] - from[1]];
    let largest = u[0].abs().max(u[1].abs()).max(1.0);
    let fraction = (rng.between(0.0, 40.0) / largest).min(1.0);
    [0, 1].map(|axis| eighths(from[axis] + fraction * u[axis]))
}

/// The same place, or one within 1.5 σ of it in each coordinate.
fn beside(p: Point, rng: &mut Random) -> Point {
    if rng.one_in(5) {
        return p;
    }
    let reach = 10 * PARTS;
    p.map(|x| x + parts(rng.integer(-reach, reach)))
}

fn near_point(rng: &mut Random) -> Point {
    [0; 2].map(|_| parts(rng.integer(-NEAR * PARTS, NEAR * PARTS)))
}

/// On the border of a square around the origin, in a direction that is as
/// likely a small slope as a large one.
fn far_point(rng: &mut Random) -> Point {
    let far = parts(FAR * PARTS);
    let along = if rng.one_in(2) { near_point(rng)[0] } else { parts(rng.integer(-FAR, FAR) * PARTS) };
    let far = if rng.one_in(2) { far } else { -far };
    if rng.one_in(2) { [far, along] } else { [along, far] }
}

/// A number of eighths; exact for all that are used here.
fn parts(count: i64) -> f64 {
    #[allow(clippy::cast_precision_loss)] // at most 2^29
    let (count, parts) = (count as f64, PARTS as f64);
    count / parts
}

fn eighths(x: f64) -> f64 {
    (x * 8.0).round() / 8.0
}

fn pick(count: usize, rng: &mut Random) -> usize {
    let last = i64::try_from(count).expect("few corners") - 1;
    usize::try_from(rng.integer(0, last)).expect("not negative")
}

fn shuffle(corners: &mut [Point], rng: &mut Random) {
    for at in (1..corners.len()).rev() {
        corners.swap(at, pick(at + 1, rng));
    }
}
