//! Vertex numbers for probes, alternately before and after the points that they are located among.
//!
//! Under Simulation of Simplicity a vertex moves further the smaller its number
//! is. Were all probes numbered after what they are located in, each would move
//! less than what it touches, and ties would always be broken in the same simple
//! way. So probes are numbered before and after it in turn.

use predicament_predicates::{Scene, Vertex};

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

/// Points without the places that are probed among them, which [`numbered`] has put there.
#[derive(Clone, PartialEq, Debug)]
pub struct Unnumbered {
    /// The points that are no probes, in their order.
    pub points: Vec<Vec<f64>>,
    /// The places, in the order of the probes.
    pub places: Vec<Vec<f64>>,
    /// For each vertex of the scene that is no probe its number among `points`.
    numbers: Vec<usize>,
}

/// The points of a scene and the places of its probes.
#[must_use]
pub fn unnumbered(scene: &Scene, probes: &[Vertex]) -> Unnumbered {
    let mut is_probe = vec![false; scene.len()];
    probes.iter().for_each(|probe| is_probe[probe.index()] = true);
    let point = |v: Vertex| scene.point(v).to_vec();
    let mut points = Vec::with_capacity(scene.len() - probes.len());
    let mut numbers = Vec::with_capacity(scene.len());
    for v in scene.vertices() {
        numbers.push(points.len());
        if !is_probe[v.index()] {
            points.push(point(v));
        }
    }
    Unnumbered { points, places: probes.iter().map(|&v| point(v)).collect(), numbers }
}

impl Unnumbered {
    /// A vertex of the scene, which is no probe, by its number among the points.
    #[must_use]
    pub fn vertex(&self, v: Vertex) -> Vertex {
        Vertex::input(self.numbers[v.index()])
    }
}
