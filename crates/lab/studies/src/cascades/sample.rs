//! What is measured after a step, in rationals.

use predicament_overlay::checks::overlay::{Defects, Point, Shape};
use rug::{Integer, Rational};

/// The measurements of a result after one step.
#[derive(Clone, PartialEq, Debug)]
pub struct Sample {
    /// The number of the step, from 1.
    pub step: usize,
    /// The number of regions.
    pub regions: usize,
    /// The number of edges of all loops.
    pub edges: usize,
    /// Twice the area.
    pub area: Rational,
    /// Crossing and touching edges, inverted and flat loops.
    pub defects: Defects,
    /// Corners that rounding has turned another way in this step; none where nothing is rounded.
    pub turned: Option<usize>,
    /// Probes that are inside and should not be, or the other way round.
    pub lost: usize,
    /// The most bits of a coordinate: those of numerator and denominator without factors of two.
    pub bits: u32,
    /// Crossings that were constructed so far, in all steps.
    pub constructed: usize,
    /// Loops and vertices that have collapsed so far.
    pub collapsed: usize,
    /// Vertices that the method holds.
    pub held: usize,
    /// The largest radius of a thick primitive.
    pub thickness: f64,
    /// Nanoseconds a step, since the sample before; not measured in rationals, and never the same twice.
    pub nanoseconds: f64,
}

/// A point to be located, and whether it is inside after each step.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Probe {
    pub at: Point,
    /// By steps; none where it is on an edge of an operand.
    pub inside: Option<Vec<bool>>,
}

/// Probes that the shape after a step, numbered from 1, has on the wrong side.
pub(super) fn lost(shape: &Shape, probes: &[Probe], step: usize) -> usize {
    let is_lost = |probe: &&Probe| {
        let Some(inside) = &probe.inside else { return false };
        // A result winds around a point once or not at all; a point of its boundary is of no operand's.
        shape.winding(&probe.at) != Some(i32::from(inside[step - 1]))
    };
    probes.iter().filter(is_lost).count()
}

/// The most bits of a coordinate.
pub(super) fn bits(shape: &Shape) -> u32 {
    let of = |x: &Rational| significant(x.numer()) + significant(x.denom());
    shape.edges().flat_map(|[from, _]| from).map(of).max().unwrap_or(0)
}

/// The bits of an integer from its highest to its lowest that is not zero; of 1, none: it is not written.
fn significant(x: &Integer) -> u32 {
    let bits = x.significant_bits() - x.find_one(0).unwrap_or(0);
    if bits == 1 { 0 } else { bits }
}
