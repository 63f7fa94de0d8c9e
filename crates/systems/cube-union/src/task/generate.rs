//! Generators of congruent cubes: anywhere, on a lattice, and on top of each other.

use predicament_corpus::{Family, Parts, Random, Recipe};
use predicament_formats::bits::{integer, power_of_two};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Scene};

use super::Cubes;

/// A placement of cubes.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Placing {
    /// Lower corners on a grid of 2^-30, with `density` cubes around a point on average.
    Uniform { density: f64 },
    /// A cubic lattice with its cubes in random order.
    Lattice { pitch: i64, edge: i64 },
    /// Lower corners on so few integers that faces, edges, corners and whole cubes coincide.
    Repeated { edge: i64 },
}

/// The families of cubes.
pub(super) static FAMILIES: [Family; 3] = [
    Family {
        name: "cubes-uniform",
        reported_as: Some("cubes-uniform"),
        parameters: &["density"],
        about: "cubes at random places in a cube, with a given mean number of cubes around a point",
        read: |_, fields| {
            let density = fields.get("density").map_or(Ok(1.0), |field| field.positive())?;
            Ok(Placing::Uniform { density }.recipe())
        },
    },
    Family {
        name: "cubes-lattice",
        reported_as: Some("cubes-lattice"),
        parameters: &["pitch", "edge"],
        about: "a lattice of cubes in random order: apart, touching or overlapping",
        read: |_, fields| {
            Ok(Placing::Lattice { pitch: length(fields, "pitch")?, edge: length(fields, "edge")? }.recipe())
        },
    },
    Family {
        name: "cubes-degen",
        reported_as: Some("cubes-degen"),
        parameters: &["edge"],
        about: "cubes on small integers: common faces, edges, corners, and identical cubes",
        read: |_, fields| Ok(Placing::Repeated { edge: length(fields, "edge")? }.recipe()),
    },
];

/// A length in lattice units, 4 if left out.
fn length(fields: &Fields<'_, '_>, key: &'static str) -> Result<i64, CorpusError> {
    fields.integer_or(key, 4, 1..=1 << 20).map(u64::cast_signed)
}

impl Placing {
    fn recipe(self) -> Recipe {
        Recipe::new(|n| 6 * n, move |making| self.make(making.n, &mut making.random()))
    }

    /// A scene of at most `n` cubes.
    fn make(self, n: usize, rng: &mut Random) -> Parts {
        let count = i64::try_from(n).expect("scenes are smaller than memory");
        let (lowers, edge, unit) = match self {
            Placing::Uniform { density } => {
                let whole = 1_i64 << 30;
                // Below 2^29, so that cubes fit in; rounded down.
                #[allow(clippy::cast_possible_truncation)]
                let edge =
                    (integer(whole) * cube_root(density / integer(count))).clamp(1.0, integer(whole / 2 - 1)) as i64;
                (random(n, whole - edge, rng), edge, power_of_two(-30))
            }
            Placing::Lattice { pitch, edge } => {
                let side = (1..).find(|side| (side + 1_i64).pow(3) > count).unwrap_or(1);
                let at = |i: i64| [i % side, i / side % side, i / (side * side)].map(|c| c * pitch);
                let mut lowers: Vec<[i64; 3]> = (0..side.pow(3)).map(at).collect();
                for end in (1..lowers.len()).rev() {
                    let other = rng.integer(0, i64::try_from(end).unwrap_or(0));
                    lowers.swap(end, usize::try_from(other).unwrap_or(0));
                }
                (lowers, edge, 1.0)
            }
            Placing::Repeated { edge } => {
                let side = (1..).find(|side| (side + 1_i64).pow(3) > count).unwrap_or(1);
                (random(n, edge * side / 2, rng), edge, 1.0)
            }
        };
        let corners = lowers.iter().flat_map(|lower| [*lower, lower.map(|c| c + edge)]);
        let coordinates: Vec<f64> = corners.flatten().map(|c| integer(c) * unit).collect();
        let scene = Scene::new(Dimension::Three, coordinates).expect("generators make finite points");
        Parts::new(scene, Cubes { cubes: lowers.len() })
    }
}

fn random(n: usize, end: i64, rng: &mut Random) -> Vec<[i64; 3]> {
    (0..n).map(|_| [(); 3].map(|()| rng.integer(0, end))).collect()
}

/// The cube root of a number up to 2^60, by bisection of doubles, which is equal on every platform.
fn cube_root(x: f64) -> f64 {
    let [mut low, mut high] = [0.0, power_of_two(20)];
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if middle * middle * middle <= x {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}
