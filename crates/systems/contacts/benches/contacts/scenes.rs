//! Scenes of any size: two complexes that meet in many places.

// Numbers of parts are small and positive, noise has 53 bits, and coordinates are rounded to single precision on
// purpose.
#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]

use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Scene, Vertex};

/// A scene and two complexes in it.
pub struct Pair {
    pub scene: Scene,
    pub a: Complex,
    pub b: Complex,
}

impl Pair {
    fn new(scene: Scene, [a, b]: [Simplices; 2]) -> Pair {
        let [a, b] = [a, b].map(|given| Complex::new(&scene, &given).expect("simplices of the scene"));
        let lengths = [&a, &b].map(|complex| complex.primitive_length(&scene));
        Pair { scene: scene.with_primitive_lengths(lengths), a, b }
    }
}

/// A pseudorandom number in [0, 1): splitmix64.
fn noise(seed: u64) -> f64 {
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ z >> 31) >> 11) as f64 / (1_u64 << 53) as f64
}

fn turn(part: usize, of: usize) -> f64 {
    std::f64::consts::TAU * part as f64 / of as f64
}

/// A scene of about `edges` edges, with single-precision coordinates.
///
/// Half of the edges are in a field of star-shaped polygons of 20 edges, half in another such field, shifted by a
/// fraction of a polygon.
pub fn polygons(edges: usize) -> Pair {
    const CORNERS: usize = 20;
    let side = ((edges / (2 * CORNERS)) as f64).sqrt().ceil().max(1.0) as usize;
    let mut points: Vec<[f64; 2]> = Vec::new();
    let field = [0, 1].map(|which| {
        let mut given = Simplices::default();
        for polygon in 0..side * side {
            let first = points.len();
            for corner in 0..CORNERS {
                let seed = points.len() as u64;
                let (radius, angle) = (0.25 + 0.25 * noise(seed), turn(corner, CORNERS));
                let shift = 0.37 * f64::from(which);
                let x = (polygon % side) as f64 + shift + radius * angle.cos();
                let y = (polygon / side) as f64 + shift + radius * angle.sin();
                points.push([x, y].map(|c| f64::from(c as f32)));
                given.edges.push([first + corner, first + (corner + 1) % CORNERS].map(Vertex::input));
            }
        }
        given
    });
    Pair::new(Scene::from_points2(&points).expect("finite"), field)
}

/// A scene of about `triangles` triangles, with single-precision coordinates: two tori that intersect.
pub fn tori(triangles: usize) -> Pair {
    let around = ((triangles / 4) as f64 * 3.0).sqrt().ceil().max(3.0) as usize;
    let across = (around / 3).max(3);
    let mut points: Vec<[f64; 3]> = Vec::new();
    let tori = [0, 1].map(|which| {
        let mut given = Simplices::default();
        let first = points.len();
        for i in 0..around {
            for j in 0..across {
                let (u, v) = (turn(i, around), turn(j, across));
                let ring = 3.0 + v.cos();
                let at = [ring * u.cos(), ring * u.sin(), v.sin()];
                // the second lies across the first
                let at = if which == 0 { at } else { [at[0] + 1.9, at[2] + 0.1, at[1] + 0.07] };
                points.push(at.map(|c| f64::from(c as f32)));
                let corner = |i: usize, j: usize| Vertex::input(first + i % around * across + j % across);
                given.triangles.push([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)]);
                given.triangles.push([corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)]);
            }
        }
        given
    });
    Pair::new(Scene::from_points3(&points).expect("finite"), tori)
}
