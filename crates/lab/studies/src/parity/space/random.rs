//! Random pairs of closed surfaces that come near contact.
//!
//! Edges have lengths of about one and σ = 6.5·ε^¼·L: a thousandth in double precision, a quarter in single.
//! Coordinates have 24 bits, which either precision can represent, and are much finer than σ.

use predicament_corpus::Random;

use super::shapes::{Point, cuboid, eighths, pick, rotation, star};
use super::{Surface, SurfacePair};
use crate::Precision;

/// The recipe of a pair.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Recipe {
    /// Tetrahedra and octahedra of random shape, near each other.
    Uniform,
    /// Vertices within two σ of vertices, edges and triangles of the first surface.
    ///
    /// They are of a copy, or of a tetrahedron planted there.
    Near,
    /// Surfaces squashed to a thickness of a few σ.
    Slivers,
    /// Boxes with two faces about a tolerance apart, turned at random.
    Sheets,
}

impl Recipe {
    /// All recipes, in the order of reports.
    pub const ALL: [Recipe; 4] = [Recipe::Uniform, Recipe::Near, Recipe::Slivers, Recipe::Sheets];

    /// The recipe's name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Recipe::Uniform => "uniform",
            Recipe::Near => "near",
            Recipe::Slivers => "slivers",
            Recipe::Sheets => "sheets",
        }
    }
}

/// The pair with this number, of the stream of this seed, and the number of refused draws before it.
///
/// A draw is refused if a surface is not embedded. The pairs are nearly degenerate for tolerances in this precision.
#[must_use]
pub fn random_surfaces(recipe: Recipe, precision: Precision, seed: u64, number: u64) -> (SurfacePair, usize) {
    let name = format!("parity-space/{}/{}/{number}", precision.name(), recipe.name());
    let mut rng = Random::new(&name, "contacts3d", seed);
    let mut refused = 0;
    loop {
        let surfaces = match recipe {
            Recipe::Uniform => uniform(&mut rng),
            Recipe::Near => near(precision, &mut rng),
            Recipe::Slivers => slivers(precision, &mut rng),
            Recipe::Sheets => sheets(precision, &mut rng),
        };
        let pair = SurfacePair { surfaces: surfaces.map(Surface::short) };
        if pair.is_embedded() {
            return (pair, refused);
        }
        refused += 1;
    }
}

/// The tolerance σ of two surfaces with primitives of these sizes.
fn sigma(precision: Precision, [a, b]: [f64; 2]) -> f64 {
    let root = match precision {
        Precision::Double => f64::EPSILON,
        Precision::Single => f64::from(f32::EPSILON),
    };
    6.5 * root.sqrt().sqrt() * (a + b)
}

fn uniform(rng: &mut Random) -> [Surface; 2] {
    let first = star(rng);
    let aside = [(); 3].map(|()| rng.between(-0.75, 0.75));
    let second = star(rng).moved(|p| [0, 1, 2].map(|axis| p[axis] + aside[axis]));
    [first, second]
}

fn near(precision: Precision, rng: &mut Random) -> [Surface; 2] {
    let first = star(rng);
    let reach = 2.0 * sigma(precision, [first.primitive(); 2]);
    if rng.one_in(2) {
        let beside = |p: Point, rng: &mut Random| p.map(|x| x + rng.between(-reach, reach));
        let second = first.clone().moved(|p| if rng.one_in(5) { p } else { beside(p, rng) });
        return [first, second];
    }
    let free = [(); 3].map(|()| rng.between(-1.5, 1.5));
    let mut points = [(); 4].map(|()| first.beside(reach, rng));
    if rng.one_in(2) {
        points[pick(4, rng)] = free;
    }
    let triangles = vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    [first, Surface { points: points.to_vec(), triangles }]
}

fn slivers(precision: Precision, rng: &mut Random) -> [Surface; 2] {
    let thick = sigma(precision, [1.0, 1.0]);
    let mut turn = rotation(rng);
    [(); 2].map(|()| {
        let factor = thick * rng.between(0.25, 4.0);
        let aside = [0.5, 0.5, 2.0 * thick].map(|reach| rng.between(-reach, reach));
        let flat = star(rng).moved(|[x, y, z]| [x + aside[0], y + aside[1], z * factor + aside[2]]);
        // Half of them are in one plane except for their thickness, the others cross.
        let own = turn;
        if rng.one_in(2) {
            turn = rotation(rng);
        }
        flat.turned(own)
    })
}

fn sheets(precision: Precision, rng: &mut Random) -> [Surface; 2] {
    let unit = sigma(precision, [1.0, 1.0]);
    let gap = unit * rng.between(-1.5, 1.5);
    let corner = |rng: &mut Random| [eighths(0, 1, rng), eighths(0, 1, rng)];
    let ([a, b], [c, d]) = ([corner(rng), corner(rng)], [corner(rng), corner(rng)]);
    let between = |[x, y]: [f64; 2], [u, v]: [f64; 2], low: f64, rng: &mut Random| {
        let size = |from: f64, to: f64| (to - from).abs().max(0.5);
        cuboid([x, y, low], [x + size(x, u), y + size(y, v), low + 1.0], rng)
    };
    let first = between(a, b, -1.0, rng);
    let tilt = if rng.one_in(2) { 0.0 } else { unit };
    let second = between(c, d, gap, rng).moved(|[x, y, z]| [x, y, z + rng.between(-tilt, tilt)]);
    let turn = rotation(rng);
    [first, second].map(|surface| surface.turned(turn))
}
