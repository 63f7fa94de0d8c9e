//! Generated solids of a given size. They use only square roots and divisions, which round the same on every platform.

use std::collections::BTreeMap;

use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two};
use predicament_mesh::half_edge::IndexedFaces;

/// Points and faces; faces are counterclockwise as seen from outside.
#[derive(Default)]
pub struct Shape {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// The faces, as indices of points.
    pub faces: IndexedFaces,
}

impl Shape {
    /// The triangles of the faces, each face cut from its first corner. `corner` makes the corners from their indices.
    pub fn cut<T: Copy>(&self, corner: impl Fn(usize) -> T) -> Vec<[T; 3]> {
        let fan = |face: &[u32]| {
            let corners: Vec<T> = face.iter().map(|&at| corner(at as usize)).collect();
            (2..corners.len()).map(|at| [corners[0], corners[at - 1], corners[at]]).collect::<Vec<_>>()
        };
        self.faces.iter().flat_map(fan).collect()
    }

    fn point(&mut self, point: [f64; 3]) -> u32 {
        self.points.push(point);
        u32::try_from(self.points.len() - 1).expect("scenes are smaller than memory")
    }

    fn triangles(&mut self, [a, b, c, d]: [u32; 4]) {
        self.faces.push([a, b, c]);
        self.faces.push([a, c, d]);
    }
}

fn count(n: usize) -> i64 {
    i64::try_from(n).expect("scenes are smaller than memory")
}

/// An octahedron with subdivided faces, projected to a sphere around the origin.
pub fn sphere(n: usize, _: &mut Random) -> Shape {
    let parts = count((n / 8).isqrt()).max(1);
    let mut shape = Shape::default();
    let mut numbers: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    for octant in 0..8_u32 {
        let signs: [i64; 3] = std::array::from_fn(|axis| if octant >> axis & 1 == 0 { 1 } else { -1 });
        let turns_over = octant.count_ones() % 2 == 1;
        let mut vertex = |shape: &mut Shape, i: i64, j: i64| {
            let place = [i * signs[0], j * signs[1], (parts - i - j) * signs[2]];
            *numbers.entry(place).or_insert_with(|| {
                let place = place.map(integer);
                let length = place.iter().map(|x| x * x).sum::<f64>().sqrt();
                shape.point(place.map(|x| x / length))
            })
        };
        for i in 0..parts {
            for j in 0..parts - i {
                let [a, b, c] = [(i, j), (i + 1, j), (i, j + 1)].map(|(i, j)| vertex(&mut shape, i, j));
                shape.faces.push(if turns_over { [a, c, b] } else { [a, b, c] });
                if i + j + 1 < parts {
                    let d = vertex(&mut shape, i + 1, j + 1);
                    shape.faces.push(if turns_over { [b, c, d] } else { [b, d, c] });
                }
            }
        }
    }
    shape
}

/// Points around the unit circle.
fn circle(n: i64) -> Vec<[f64; 2]> {
    // Along a square that stands on its tip, then out to the circle.
    let at = |k: i64| {
        let (quarter, along) = (4 * k / n, integer(4 * k % n) / integer(n));
        let [x, y] = [1.0 - along, along];
        let length = (x * x + y * y).sqrt();
        let [x, y] = [x / length, y / length];
        match quarter {
            0 => [x, y],
            1 => [-y, x],
            2 => [-x, -y],
            _ => [y, -x],
        }
    };
    (0..n).map(at).collect()
}

/// A torus around the z axis.
pub fn torus(n: usize, _: &mut Random) -> Shape {
    let around = count((n / 2).isqrt()).max(4);
    let circle = circle(around);
    let mut shape = Shape::default();
    for [x, y] in &circle {
        for [out, z] in &circle {
            let radius = 1.0 + 0.375 * out;
            shape.point([radius * x, radius * y, 0.375 * z]);
        }
    }
    let at = |i: i64, j: i64| u32::try_from(i % around * around + j % around).expect("scenes are smaller than memory");
    for i in 0..around {
        for j in 0..around {
            shape.triangles([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    shape
}

/// The surface of a cube of unit cells, with a square for each.
pub fn lattice(n: usize, _: &mut Random) -> Shape {
    let side = count((n / 6).isqrt()).max(1);
    let mut shape = Shape::default();
    let mut numbers: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    for axis in 0..3 {
        for level in [0, side] {
            for i in 0..side {
                for j in 0..side {
                    let mut square = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[u, v]| {
                        let mut place = [0; 3];
                        (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (level, u, v);
                        *numbers.entry(place).or_insert_with(|| shape.point(place.map(integer)))
                    });
                    if level == 0 {
                        square.reverse();
                    }
                    shape.faces.push(square);
                }
            }
        }
    }
    shape
}

/// A prism over a polygon in the plane, one unit high.
fn prism(polygon: &[[f64; 2]]) -> Shape {
    let mut shape = Shape::default();
    let [low, high] = [0.0, 1.0].map(|z| polygon.iter().map(|&[x, y]| shape.point([x, y, z])).collect::<Vec<u32>>());
    shape.faces.push(low.iter().rev().copied());
    shape.faces.push(high.iter().copied());
    for i in 0..polygon.len() {
        let j = (i + 1) % polygon.len();
        shape.faces.push([low[i], low[j], high[j], high[i]]);
    }
    shape
}

/// A comb: teeth that end on one line, and gaps whose depth decreases a little from each to the next.
pub fn comb(n: usize, _: &mut Random) -> Shape {
    let teeth = count(n / 4).max(1);
    let mut polygon = vec![[0.0, -1.0], [integer(2 * teeth - 1), -1.0]];
    for tooth in (0..teeth).rev() {
        let depth = integer(tooth) * power_of_two(-20);
        let [left, right] = [integer(2 * tooth), integer(2 * tooth + 1)];
        polygon.extend([[right, 8.0], [left, 8.0]]);
        if tooth > 0 {
            polygon.extend([[left, depth], [left - 1.0, depth]]);
        }
    }
    prism(&polygon)
}

/// A band folded to and fro, with its creases on two lines.
pub fn fold(n: usize, _: &mut Random) -> Shape {
    let folds = count(n / 2).max(2);
    let crease = |at: i64, by: f64| [integer(at), integer(at % 2) * 16.0 + by];
    let polygon: Vec<[f64; 2]> =
        (0..folds).map(|at| crease(at, 0.0)).chain((0..folds).rev().map(|at| crease(at, 0.5))).collect();
    prism(&polygon)
}

/// Nested cubes; every second cube is a hole.
pub fn shells(n: usize, _: &mut Random) -> Shape {
    let shells = count(n / 6).max(1);
    let mut shape = Shape::default();
    for shell in 0..shells {
        let half = integer(shells - shell);
        let corner = |at: usize| [0, 1, 2].map(|axis| if at >> axis & 1 == 0 { -half } else { half });
        let corners: Vec<u32> = (0..8).map(|at| shape.point(corner(at))).collect();
        let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        for square in squares {
            let mut square = square.map(|at: usize| corners[at]);
            if shell % 2 == 1 {
                square.reverse();
            }
            shape.faces.push(square);
        }
    }
    shape
}

/// Heights over a square, in triangles.
pub fn terrain(n: usize, rng: &mut Random) -> Shape {
    let side = count((n / 2).isqrt()).max(1);
    let mut shape = Shape::default();
    for i in 0..=side {
        for j in 0..=side {
            shape.point([integer(i), integer(j), rng.unit()]);
        }
    }
    let at = |i: i64, j: i64| u32::try_from(i * (side + 1) + j).expect("scenes are smaller than memory");
    for i in 0..side {
        for j in 0..side {
            shape.triangles([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    shape
}
