//! Small closed surfaces: tetrahedra, octahedra, boxes, and moves of them.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, rounded};

use super::Surface;

pub(super) type Point = [f64; 3];

/// The number of bits of coordinates, which either precision can represent.
const BITS: u32 = 24;

/// A randomly rotated tetrahedron or octahedron around the origin.
///
/// Its corners are at distances from 1/2 to 1: star-shaped, hence embedded.
pub(super) fn star(rng: &mut Random) -> Surface {
    let (corners, triangles): (Vec<Point>, Vec<[usize; 3]>) = if rng.one_in(3) {
        let corners = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        (corners, vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])
    } else {
        let corner = |at: usize| std::array::from_fn(|axis| [0.0, [1.0, -1.0][at % 2]][usize::from(axis == at / 2)]);
        let face = |octant: usize| [0, 1, 2].map(|axis| 2 * axis + (octant >> axis & 1));
        ((0..6).map(corner).collect(), (0..8).map(face).collect())
    };
    let turn = rotation(rng);
    let points = corners.into_iter().map(|corner| {
        let [x, y, z] = corner.map(|x| x * rng.between(0.5, 1.0));
        turn.map(|[a, b, c]| a * x + b * y + c * z)
    });
    Surface { points: points.collect(), triangles }
}

/// A box of twelve triangles between two corners.
pub(super) fn cuboid(low: Point, high: Point, rng: &mut Random) -> Surface {
    let points = (0..8).map(|corner| [0, 1, 2].map(|axis| [low, high][corner >> axis & 1][axis])).collect();
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            let around = [0, u, u | v, v].map(|corner| corner | side);
            let start = usize::from(rng.one_in(2));
            let at = |k: usize| around[(start + k) % 4];
            triangles.extend([[at(0), at(1), at(2)], [at(0), at(2), at(3)]]);
        }
    }
    Surface { points, triangles }
}

/// The rows of a random rotation, from a quaternion in the unit ball.
pub(super) fn rotation(rng: &mut Random) -> [Point; 3] {
    loop {
        let [w, x, y, z] = [(); 4].map(|()| rng.between(-1.0, 1.0));
        let norm = w * w + x * x + y * y + z * z;
        if !(0.0625..=1.0).contains(&norm) {
            continue;
        }
        let twice = 2.0 / norm;
        return [
            [1.0 - twice * (y * y + z * z), twice * (x * y - w * z), twice * (x * z + w * y)],
            [twice * (x * y + w * z), 1.0 - twice * (x * x + z * z), twice * (y * z - w * x)],
            [twice * (x * z - w * y), twice * (y * z + w * x), 1.0 - twice * (x * x + y * y)],
        ];
    }
}

impl Surface {
    /// The surface with each point changed.
    pub(super) fn moved(mut self, mut change: impl FnMut(Point) -> Point) -> Surface {
        self.points.iter_mut().for_each(|point| *point = change(*point));
        self
    }

    /// The surface with coordinates rounded to few bits.
    pub(super) fn short(self) -> Surface {
        self.moved(|point| point.map(|x| rounded(x, BITS)))
    }

    /// The surface rotated around the origin.
    pub(super) fn turned(self, rows: [Point; 3]) -> Surface {
        self.moved(|[x, y, z]| rows.map(|[a, b, c]| a * x + b * y + c * z))
    }

    /// The largest edge of a triangle's bounding box.
    pub(super) fn primitive(&self) -> f64 {
        let extent = |[a, b]: [usize; 2]| (0..3).map(move |axis| (self.points[a][axis] - self.points[b][axis]).abs());
        let sides = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]];
        self.triangles.iter().flat_map(sides).flat_map(extent).fold(0.0, f64::max)
    }

    /// A point within `reach` along each axis of a vertex, an edge or a triangle, or exactly there.
    pub(super) fn beside(&self, reach: f64, rng: &mut Random) -> Point {
        let triangle = self.triangles[pick(self.triangles.len(), rng)];
        let corners = triangle.map(|at| self.points[at]);
        let weights = match rng.integer(0, 2) {
            0 => [1.0, 0.0, 0.0],
            1 => {
                let t = rng.unit();
                [t, 1.0 - t, 0.0]
            }
            _ => {
                let [s, t] = [rng.unit(), rng.unit()];
                let [s, t] = if s + t > 1.0 { [1.0 - s, 1.0 - t] } else { [s, t] };
                [s, t, 1.0 - s - t]
            }
        };
        let reach = if rng.one_in(5) { 0.0 } else { reach };
        std::array::from_fn(|axis| {
            let at: f64 = (0..3).map(|corner| weights[corner] * corners[corner][axis]).sum();
            at + rng.between(-reach, reach)
        })
    }
}

pub(super) fn pick(count: usize, rng: &mut Random) -> usize {
    let last = i64::try_from(count).expect("few points") - 1;
    usize::try_from(rng.integer(0, last)).expect("not negative")
}

/// A random multiple of 1/8 in [low, high].
pub(super) fn eighths(low: i64, high: i64, rng: &mut Random) -> f64 {
    integer(rng.integer(8 * low, 8 * high)) / 8.0
}
