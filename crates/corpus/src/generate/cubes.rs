//! Congruent cubes: anywhere, on a lattice, and on top of each other.

use predicament_predicates::{Dimension, Scene};

use super::Random;
use crate::bits::{integer, power_of_two};
use crate::document::Fields;
use crate::{CorpusError, Work};

/// A way to place cubes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Cubes {
    /// Lower corners on a grid of 2^-30, so many cubes around a point on average.
    Uniform { density: f64 },
    /// A cubic lattice with its cubes in no order.
    Lattice { pitch: i64, edge: i64 },
    /// Lower corners on so few integers that faces, edges, corners and whole cubes coincide.
    Repeated { edge: i64 },
}

impl Cubes {
    /// The way with this family's name; none for other families.
    pub(super) fn read(family: &str, fields: &Fields<'_, '_>) -> Result<Option<Cubes>, CorpusError> {
        let length = |key, default| fields.integer_or(key, default, 1..=1 << 20).map(u64::cast_signed);
        Ok(Some(match family {
            "cubes-uniform" => {
                let density = fields.get("density").map_or(Ok(1.0), |field| field.positive())?;
                Cubes::Uniform { density }
            }
            "cubes-lattice" => Cubes::Lattice { pitch: length("pitch", 4)?, edge: length("edge", 4)? },
            "cubes-degen" => Cubes::Repeated { edge: length("edge", 4)? },
            _ => return Ok(None),
        }))
    }

    /// At most `n` cubes.
    pub(super) fn make(self, n: usize, rng: &mut Random) -> (Scene, Work) {
        let count = i64::try_from(n).expect("scenes are smaller than memory");
        let (lowers, edge, unit) = match self {
            Cubes::Uniform { density } => {
                let whole = 1_i64 << 30;
                // Below 2^29, so that cubes have room; rounded down.
                #[allow(clippy::cast_possible_truncation)]
                let edge =
                    (integer(whole) * cube_root(density / integer(count))).clamp(1.0, integer(whole / 2 - 1)) as i64;
                (random(n, whole - edge, rng), edge, power_of_two(-30))
            }
            Cubes::Lattice { pitch, edge } => {
                let side = (1..).find(|side| (side + 1_i64).pow(3) > count).unwrap_or(1);
                let at = |i: i64| [i % side, i / side % side, i / (side * side)].map(|c| c * pitch);
                let mut lowers: Vec<[i64; 3]> = (0..side.pow(3)).map(at).collect();
                for end in (1..lowers.len()).rev() {
                    let other = rng.integer(0, i64::try_from(end).unwrap_or(0));
                    lowers.swap(end, usize::try_from(other).unwrap_or(0));
                }
                (lowers, edge, 1.0)
            }
            Cubes::Repeated { edge } => {
                let side = (1..).find(|side| (side + 1_i64).pow(3) > count).unwrap_or(1);
                (random(n, edge * side / 2, rng), edge, 1.0)
            }
        };
        let corners = lowers.iter().flat_map(|lower| [*lower, lower.map(|c| c + edge)]);
        let coordinates: Vec<f64> = corners.flatten().map(|c| integer(c) * unit).collect();
        let scene = Scene::new(Dimension::Three, coordinates).expect("generators make finite points");
        (scene, Work::Cubes { cubes: lowers.len() })
    }
}

fn random(n: usize, end: i64, rng: &mut Random) -> Vec<[i64; 3]> {
    (0..n).map(|_| [(); 3].map(|()| rng.integer(0, end))).collect()
}

/// By bisection of doubles, which every platform rounds the same; for numbers up to 2^60.
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
