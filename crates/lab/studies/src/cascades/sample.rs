//! The measurements after a step, in rationals.

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
    /// The number of corners whose turn the rounding of this step has changed; `None` if nothing is rounded.
    pub turned: Option<usize>,
    /// The number of probes on the wrong side of the result.
    pub lost: usize,
    /// The largest bit length of a coordinate: of numerator and denominator without factors of two.
    pub bits: u32,
    /// The number of crossings constructed so far, in all steps.
    pub constructed: usize,
    /// The number of loops and vertices that have collapsed so far.
    pub collapsed: usize,
    /// The number of vertices that the method stores.
    pub held: usize,
    /// The largest radius of a thick primitive.
    pub thickness: f64,
    /// Nanoseconds per step, since the sample before; it differs from run to run.
    pub nanoseconds: f64,
}

/// A point that is located, and its side after each step.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Probe {
    pub at: Point,
    /// True if the point is inside, for each step; `None` if it is on an edge of an operand.
    pub inside: Option<Vec<bool>>,
}

/// The number of probes that the shape after a step, numbered from 1, has on the wrong side.
pub(super) fn lost(shape: &Shape, probes: &[Probe], step: usize) -> usize {
    let is_lost = |probe: &&Probe| {
        let Some(inside) = &probe.inside else { return false };
        // A result winds around a point once or not at all; a point of its boundary is on no operand's boundary.
        shape.winding(&probe.at) != Some(i32::from(inside[step - 1]))
    };
    probes.iter().filter(is_lost).count()
}

/// The largest bit length of a coordinate.
pub(super) fn bits(shape: &Shape) -> u32 {
    let of = |x: &Rational| significant(x.numer()) + significant(x.denom());
    shape.edges().flat_map(|[from, _]| from).map(of).max().unwrap_or(0)
}

/// The bits of an integer from its highest to its lowest set bit.
///
/// Zero for 1, which is not written.
fn significant(x: &Integer) -> u32 {
    let bits = x.significant_bits() - x.find_one(0).unwrap_or(0);
    if bits == 1 { 0 } else { bits }
}
