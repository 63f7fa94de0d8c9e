//! Closed triangulated surfaces.

use std::collections::BTreeMap;

use predicament_mesh::Simplices;
use predicament_predicates::Vertex;

use super::Shape;
use predicament_corpus::Random;
use predicament_formats::bits::integer;

fn count(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

/// A randomly rotated, bumpy sphere around (1/2, 1/2, 1/2).
///
/// Its vertices are inside or outside the sphere by a random part of its edge length, so two such spheres cross each
/// other everywhere. It is star-shaped, hence embedded.
///
/// It is an octahedron with divided faces, projected to the sphere: only square roots and divisions, which round the
/// same on every platform.
pub(super) fn lumpy(n: usize, rng: &mut Random) -> Shape {
    let parts = count((n / 8).isqrt()).max(2);
    let depth = (0.5 / integer(parts)).min(0.2);
    let turn = rotation(rng);
    let mut numbers: BTreeMap<[i64; 3], Vertex> = BTreeMap::new();
    let mut coordinates = Vec::new();
    let mut triangles = Vec::new();
    for octant in 0..8 {
        let signs: [i64; 3] = std::array::from_fn(|axis| if octant >> axis & 1 == 0 { 1 } else { -1 });
        let mut vertex = |i: i64, j: i64| {
            let place = [i * signs[0], j * signs[1], (parts - i - j) * signs[2]];
            *numbers.entry(place).or_insert_with(|| {
                let radius = 0.375 + depth * (rng.unit() - 0.5);
                let [x, y, z] = place.map(integer);
                let length = (x * x + y * y + z * z).sqrt();
                coordinates.extend(turn.map(|[a, b, c]| 0.5 + radius * ((a * x + b * y + c * z) / length)));
                Vertex::input(coordinates.len() / 3 - 1)
            })
        };
        for i in 0..parts {
            for j in 0..parts - i {
                triangles.push([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < parts {
                    triangles.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
    }
    Shape { coordinates, simplices: Simplices { triangles, ..Simplices::default() } }
}

/// A surface close to another surface, with a vertex for each of the other's vertices.
///
/// Along each axis, a vertex is at most 2σ from the other's vertex, or from a point of an edge or a triangle there, or
/// exactly there up to rounding.
///
/// Such points are nearer to the vertex than to any other corner. If neighbours move towards each other, or triangles
/// are folded by σ, the surface can cross itself: no law about its contacts excludes that.
pub(super) fn near(other: &Shape, sigma: f64, rng: &mut Random) -> Shape {
    let around = other.coordinates.as_chunks::<3>().0;
    let mut corners: Vec<[usize; 3]> = vec![[0; 3]; around.len()];
    for triangle in &other.simplices.triangles {
        let [a, b, c] = triangle.map(Vertex::index);
        for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
            corners[p] = [p, q, r];
        }
    }
    let coordinates = corners.into_iter().flat_map(|corners| {
        let [p, q, r] = corners.map(|at| around[at]);
        let (s, t) = match rng.integer(0, 3) {
            0 | 1 => (0.0, 0.0),
            2 => (rng.between(0.1, 0.4), 0.0),
            _ => (rng.between(0.1, 0.25), rng.between(0.1, 0.25)),
        };
        let reach = if rng.one_in(4) { 0.0 } else { 2.0 };
        let beside: [f64; 3] =
            std::array::from_fn(|i| p[i] + s * (q[i] - p[i]) + t * (r[i] - p[i]) + rng.between(-reach, reach) * sigma);
        beside
    });
    Shape { coordinates: coordinates.collect(), simplices: other.simplices.clone() }
}

/// The rows of a random rotation matrix, up to rounding.
fn rotation(rng: &mut Random) -> [[f64; 3]; 3] {
    loop {
        let [a, b, c, d] = std::array::from_fn(|_| rng.between(-1.0, 1.0));
        let square = a * a + b * b + c * c + d * d;
        if (0.0625..=1.0).contains(&square) {
            let rows = [
                [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
                [2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)],
                [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d],
            ];
            return rows.map(|row| row.map(|x| x / square));
        }
    }
}

/// Boxes on integer coordinates, one in each cell of a lattice.
///
/// A box has a corner anywhere from 0 to 2 and edges of 1 or 2. Cell by cell, the boxes of two such sets share corners,
/// edges, parts of faces, or all of these, or cross.
pub(super) fn boxes(n: usize, rng: &mut Random) -> Shape {
    const TRIANGLES: usize = 12;
    const PITCH: i64 = 5;
    let cells = count(n / TRIANGLES).max(1);
    let mut side = 1;
    while side * side * side < cells {
        side += 1;
    }
    let mut coordinates = Vec::new();
    let mut triangles = Vec::new();
    for cell in 0..cells {
        let first = coordinates.len() / 3;
        let lattice = [cell % side, cell / side % side, cell / side / side];
        let low = lattice.map(|place| place * PITCH + rng.integer(0, 2));
        let size = [0; 3].map(|_: i64| rng.integer(1, 2));
        for corner in 0..8 {
            coordinates.extend((0..3).map(|axis| integer(low[axis] + (corner >> axis & 1) * size[axis])));
        }
        for (axis, high) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)] {
            // The corners around a face; either diagonal may divide the face.
            let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            let around = [0, u, u | v, v].map(|corner| Vertex::input(first + (corner | high << axis)));
            let start = usize::from(rng.one_in(2));
            let at = |k: usize| around[(start + k) % 4];
            triangles.extend([[at(0), at(1), at(2)], [at(0), at(2), at(3)]]);
        }
    }
    Shape { coordinates, simplices: Simplices { triangles, ..Simplices::default() } }
}
