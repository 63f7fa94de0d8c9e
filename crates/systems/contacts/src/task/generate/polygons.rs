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

/// A polygon around (1/2, 1/2) whose vertices lie, in turn, a random bit
/// inside or outside a square, by as much as its edges are long: two of them
/// cross each other all the way round. It is star-shaped, hence simple.
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

/// A polygon along another: each vertex at most 2σ, along each axis, beside a
/// vertex or a point of an edge of the other, or just there up to rounding.
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

/// The outline of a skyline on integer coordinates: heights from 1 to 3 above
/// a ground line with vertices of its own. Two of them share vertices, have
/// vertices on each other's edges, run along each other and cross, all exactly.
/// A dense one has a vertex in every column, others leave some out.
pub(super) fn skyline(n: usize, dense: bool, rng: &mut Random) -> Shape {
    // With its ground line a dense one has 3/2 edges a column.
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
