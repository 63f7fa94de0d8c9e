//! The distances by which rounding can move a vertex of an answer.
//!
//! A library that computes in doubles cannot put the crossing of two edges at its exact place. [`Bound::class`] sorts
//! the distance of the farthest vertex from where it belongs:
//!
//! * up to [`NEAREST`] units: the answer is as good as doubles allow;
//! * up to [`COARSEST`] of the extent of the smallest operand: the answer is *rounded*, with a known distance.
//!   Libraries that compute on an integer grid are here;
//! * farther: the vertex is wrong.
//!
//! Points on the wrong side of a result's boundary are sorted by their distance from the operands in the same way.
//!
//! The unit is the unit in the last place of the largest coordinate of the scene. In the first case the judge tests the
//! rest of the answer at the distance of [`NEAREST`] units, in the second case at the distance of the vertex, so that
//! an answer is judged by its own precision.

use predicament_predicates::{Dimension, Scene, Vertex};

use crate::Class;
use crate::rounding::{BOUND, last_place};

/// The largest distance of a vertex that counts as the nearest double, in units along each axis.
pub const NEAREST: u32 = BOUND;

/// The largest distance of a rounded vertex, as a part of the extent of the smallest operand: 2^-20, about one
/// millionth.
pub const COARSEST: f64 = 1.0 / 1_048_576.0;

/// The units of a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bound {
    /// The unit in the last place of the largest coordinate.
    pub unit: f64,
    /// The largest edge of the bounding box of all points: L.
    pub extent: f64,
    /// The largest distance of an answer that is only rounded.
    pub coarsest: f64,
    /// The distance of a vertex that is [`NEAREST`] units off along each axis.
    pub nearest: f64,
}

/// The largest edge of the bounding box of vertices; zero for none.
fn extent(scene: &Scene, of: &[Vertex]) -> f64 {
    let dimension = if scene.dimension() == Dimension::Two { 2 } else { 3 };
    let along = |axis: usize| {
        let all = of.iter().map(|&v| scene.point(v)[axis]);
        let [low, high] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        // Half of each, since the difference can be beyond all doubles.
        (high / 2.0 - low / 2.0).clamp(0.0, f64::MAX / 4.0) * 2.0
    };
    (0..dimension).map(along).fold(0.0, f64::max)
}

/// A distance, and its class.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Far {
    /// The distance of the farthest vertex.
    pub distance: f64,
    /// [`Class::Agree`], [`Class::Rounded`] or [`Class::Topology`].
    pub class: Class,
    /// The distance at which the rest of the answer is tested.
    pub within: f64,
}

impl Bound {
    /// The units of a scene with operands, each given by its vertices.
    #[must_use]
    pub fn of(scene: &Scene, operands: [&[Vertex]; 2]) -> Bound {
        let all: Vec<Vertex> = scene.vertices().collect();
        let extent = extent(scene, &all);
        let smallest = operands.map(|operand| self::extent(scene, operand)).into_iter().filter(|of| *of > 0.0);
        let smallest = smallest.fold(extent, f64::min);
        let largest = scene.coordinates().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let unit = last_place(largest);
        // (The square root of the dimension is at most 1.75.)
        Bound { unit, extent, coarsest: COARSEST * smallest, nearest: 1.75 * f64::from(NEAREST) * unit }
    }

    /// The class of the farthest vertex's distance.
    #[must_use]
    pub fn class(&self, distance: f64) -> Far {
        let class = if distance <= self.nearest {
            Class::Agree
        } else if distance <= self.coarsest {
            Class::Rounded
        } else {
            Class::Topology
        };
        // The distance itself is rounded.
        let within = (distance * (1.0 + 1e-12)).max(self.nearest);
        Far { distance, class, within }
    }

    /// The class of a violation that a distance from the operands explains, and that distance in words. Without a
    /// distance, the answer is wrong.
    #[must_use]
    pub fn violated(&self, distance: Option<f64>) -> (Class, String) {
        match distance {
            None => (Class::Topology, String::new()),
            Some(distance) => {
                let class = if distance <= self.coarsest { Class::Rounded } else { Class::Topology };
                (class, format!("; up to {} from the operands", self.told(distance)))
            }
        }
    }

    /// A distance in words: as a number, in units in the last place, and as a part of L.
    #[must_use]
    pub fn told(&self, distance: f64) -> String {
        format!("{distance:.3e} ({:.3} ulp, {:.3e} L)", distance / self.unit, distance / self.extent)
    }
}
