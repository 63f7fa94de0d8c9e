//! Simple closed polygons.

use predicament_mesh::Simplices;
use predicament_predicates::Vertex;

use super::Shape;
use predicament_corpus::Random;
use predicament_formats::bits::integer;

fn closed(points: &[[f64; 2]]) -> Shape {
    let next = |at: usize| (at + 1) % points.len();
    let edges = (0..points.len()).map(|at| [at, next(at)].map(Vertex::input)).collect();
    Shape { coordinates: points.as_flattened().to_vec(), simplices: Simplices { edges, ..Simplices::default() } }
}

fn count(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

/// A star-shaped polygon around (1/2, 1/2) whose vertices are alternately inside and outside a square, by a random part
/// of its edge length.
///
/// Two such polygons cross each other all the way round. The polygon is star-shaped, hence simple.
pub(super) fn wavy(n: usize, rng: &mut Random) -> Shape {
    let n = n.max(8);
    let depth = (2.0 / integer(count(n))).min(0.25);
    let points: Vec<[f64; 2]> = (0..n)
        .map(|at| {
            let turn = (integer(count(at)) + rng.between(0.25, 0.75)) * 4.0 / integer(count(n));
            let (quadrant, t) = (turn.floor(), turn.fract());
            let [x, y] = match quadrant {
                0.0 => [1.0 - t, t],
                1.0 => [-t, 1.0 - t],
                2.0 => [t - 1.0, -t],
                _ => [t, t - 1.0],
            };
            let radius = 0.375 + depth * (rng.unit() - 0.5);
            [0.5 + radius * x, 0.5 + radius * y]
        })
        .collect();
    closed(&points)
}

/// A polygon close to another polygon.
///
/// Along each axis, each vertex is at most 2σ from a vertex of the other or from a point of its edge, or exactly there
/// up to rounding.
pub(super) fn near(other: &Shape, sigma: f64, rng: &mut Random) -> Shape {
    let around = other.coordinates.as_chunks::<2>().0;
    let points: Vec<[f64; 2]> = (0..around.len())
        .map(|at| {
            let (p, q) = (around[at], around[(at + 1) % around.len()]);
            let t = if rng.one_in(2) { 0.0 } else { rng.between(0.25, 0.75) };
            let reach = if rng.one_in(4) { 0.0 } else { 2.0 };
            std::array::from_fn(|i| p[i] + t * (q[i] - p[i]) + rng.between(-reach, reach) * sigma)
        })
        .collect();
    closed(&points)
}

/// The outline of a skyline on integer coordinates: heights from 1 to 3 above a ground line with its own vertices. Two
/// such outlines share vertices, have vertices on each other's edges, run along each other and cross, all exactly. A
/// dense outline has a vertex in every column, others skip some columns.
pub(super) fn skyline(n: usize, dense: bool, rng: &mut Random) -> Shape {
    // With its ground line, a dense outline has 3/2 edges per column.
    let width = count(n * 2 / 3).max(4);
    let every = if dense { 2 } else { 3 };
    let mut points = Vec::new();
    for x in 0..=width {
        if dense || x == 0 || x == width || !rng.one_in(3) {
            points.push([x, rng.integer(1, 3)]);
        }
    }
    points.extend((0..=width).rev().filter(|x| x % every == 0 || *x == width).map(|x| [x, 0]));
    closed(&points.iter().map(|point| point.map(integer)).collect::<Vec<_>>())
}
