//! Queries whose determinants are at the edges of a tolerance band.
//!
//! The tolerance scheme of Wang, Jiang, Schroeder and Teran registers determinants within thresholds that are multiples
//! of ε·L² in 2D (κ: 10, 21, 32) and ε^(3/4)·L³ in 3D (ξ and ρ: 28, 56, 83.14), with ε = 2^-52 the machine epsilon and
//! L the largest edge of the scene's bounding box. Random queries never come near the thresholds; these queries do.

use predicament_predicates::{PredicateKind, Vertex};

use super::Cloud;
use super::near::{unit2, unit3};
use crate::Random;
use crate::bits::power_of_two;

/// The thresholds T₋, T and T₊ of κ, in units of ε·L².
const PLANE: [f64; 3] = [10.0, 21.0, 32.0];
/// The thresholds T₋, T and T₊ of ξ and ρ, in units of ε^(3/4)·L³.
const SPACE: [f64; 3] = [28.0, 56.0, 83.14];

/// A scene of `n` queries between two anchors that make L exactly 1, for `orient2d` and `orient3d`.
#[must_use]
pub fn band(kind: PredicateKind, n: usize, rng: &mut Random) -> Cloud {
    let space = kind == PredicateKind::Orient3d;
    let dimension = super::native(kind);
    let mut coordinates = vec![0.0; dimension];
    coordinates.extend(vec![1.0; dimension]);
    for _ in 0..n {
        if space {
            coordinates.extend(tetrahedron(rng).as_flattened());
        } else {
            coordinates.extend(triangle(rng).as_flattened());
        }
    }
    let args = (2..2 + n * kind.arity()).map(Vertex::input).collect();
    Cloud { coordinates, args: Some(args), constructions: Vec::new() }
}

/// A signed determinant within a sixty-fourth of a threshold.
fn target(multiples: [f64; 3], unit: f64, rng: &mut Random) -> f64 {
    let [lower, width, upper] = multiples;
    let multiple = match rng.integer(0, 2) {
        0 => lower,
        1 => width,
        _ => upper,
    };
    let sign = if rng.one_in(2) { 1.0 } else { -1.0 };
    sign * multiple * unit * rng.between(1.0 - 1.0 / 64.0, 1.0 + 1.0 / 64.0)
}

/// Points a, b and a third point beside the line through them, at a distance for the target determinant. Short edges
/// are as likely as long ones; with a short edge the determinant can be set more finely.
fn triangle(rng: &mut Random) -> [[f64; 2]; 3] {
    loop {
        let a = unit2(rng);
        let size = power_of_two(-rng.integer(1, 12));
        let edge = unit2(rng).map(|x| (x - 0.5) * size);
        let b = [a[0] + edge[0], a[1] + edge[1]];
        let u = [b[0] - a[0], b[1] - a[1]];
        let square = u[0] * u[0] + u[1] * u[1];
        let lift = target(PLANE, power_of_two(-52), rng) / square;
        let t = rng.unit();
        let c = [a[0] + t * u[0] - lift * u[1], a[1] + t * u[1] + lift * u[0]];
        let points = [a, b, c];
        if square > size * size / 64.0 && inside(points.as_flattened()) {
            return points;
        }
    }
}

/// Points a, b, c and a fourth point off their plane, at a distance for the target determinant.
fn tetrahedron(rng: &mut Random) -> [[f64; 3]; 4] {
    loop {
        let [a, b, c] = [unit3(rng), unit3(rng), unit3(rng)];
        let [u, v]: [[f64; 3]; 2] = [b, c].map(|p| std::array::from_fn(|i| p[i] - a[i]));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let square: f64 = normal.iter().map(|x| x * x).sum();
        let lift = target(SPACE, power_of_two(-39), rng) / square;
        let (s, t) = (rng.unit(), rng.unit());
        let d = std::array::from_fn(|i| a[i] + s * u[i] + t * v[i] + lift * normal[i]);
        let points = [a, b, c, d];
        if square > 1.0 / 64.0 && inside(points.as_flattened()) {
            return points;
        }
    }
}

/// True if a query stays between the anchors.
fn inside(coordinates: &[f64]) -> bool {
    coordinates.iter().all(|x| (0.0..=1.0).contains(x))
}
