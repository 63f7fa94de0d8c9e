//! Estimates of the memory of work on segments, before it runs.
//!
//! n segments can cross in n²/2 places. The number of crossings is estimated from an even sample, in plain floating
//! point; an error of a few percent does not matter.

use predicament_predicates::{Plane, Scene, Vertex};

/// The number of segments that are sampled.
const SAMPLE: usize = 2048;
/// The fewest crossings in the sample that say something about the whole.
const FEWEST: u64 = 16;

/// Bytes of memory, as measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bytes {
    /// For each segment, with a crossing of its own.
    pub segment: u64,
    /// For each further crossing.
    pub crossing: u64,
}

/// The approximate memory for segments and their crossings, in bytes.
#[must_use]
pub fn estimate(scene: &Scene, segments: &[[Vertex; 2]], bytes: Bytes) -> u64 {
    let count = segments.len() as u64;
    let further = crossings(scene, segments).saturating_sub(count);
    count.saturating_mul(bytes.segment).saturating_add(further.saturating_mul(bytes.crossing))
}

/// The approximate number of crossings; 0 if the sample has too few.
fn crossings(scene: &Scene, segments: &[[Vertex; 2]]) -> u64 {
    // An odd step: similar segments often come in pairs and fours.
    let step = segments.len().div_ceil(SAMPLE) | 1;
    let sample: Vec<[[f64; 2]; 2]> =
        segments.iter().step_by(step).map(|ends| ends.map(|v| scene.point2(Plane::Xy, v))).collect();
    let crossed =
        |(at, one): (usize, &[[f64; 2]; 2])| sample[at + 1..].iter().filter(|other| cross(one, other)).count();
    let found: usize = sample.iter().enumerate().map(crossed).sum();
    let (found, step) = (found as u64, step as u64);
    if step > 1 && found < FEWEST { 0 } else { found.saturating_mul(step).saturating_mul(step) }
}

/// True if two segments cross, in floating point.
fn cross([a, b]: &[[f64; 2]; 2], [c, d]: &[[f64; 2]; 2]) -> bool {
    let beside =
        |axis: usize| a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis]);
    let turn =
        |p: &[f64; 2], q: &[f64; 2], r: &[f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0;
    !beside(0) && !beside(1) && turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b)
}
