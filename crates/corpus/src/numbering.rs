//! Vertex numbers for probes, alternately before and after the points that they are located among.
//!
//! Under Simulation of Simplicity a vertex moves further the smaller its number
//! is. Were all probes numbered after what they are located in, each would move
//! less than what it touches, and ties would always be broken in the same simple
//! way. So probes are numbered before and after it in turn.

use predicament_predicates::Vertex;

/// Points with places to probe: the even places first, then the points, then
/// the odd places; and the vertex of each place. The points move up by half
/// the number of places, rounded up.
#[must_use]
pub fn numbered<P: Copy>(points: Vec<P>, places: &[P]) -> (Vec<P>, Vec<Vertex>) {
    let behind = places.len().div_ceil(2) + points.len();
    let number = |at: usize| at / 2 + if at.is_multiple_of(2) { 0 } else { behind };
    let vertices = (0..places.len()).map(|at| Vertex::input(number(at))).collect();
    let every_other = |from: usize| places.iter().skip(from).step_by(2).copied();
    (every_other(0).chain(points).chain(every_other(1)).collect(), vertices)
}
