//! Vertex numbers for probes, alternately before and after the points among which they are located.
//!
//! Under Simulation of Simplicity a vertex moves further the smaller its number is. If all probes were numbered after
//! these points, each probe would move less than everything it touches, and ties would always be broken in the same
//! simple way. So probes are numbered alternately before and after the points.

use predicament_predicates::{Scene, Vertex};

/// Numbers points and places to probe: the even places first, then the points, then the odd places. Returns the
/// coordinates in this order and the vertex of each place. The points move up by half the number of places, rounded up.
#[must_use]
pub fn numbered<P: Copy>(points: Vec<P>, places: &[P]) -> (Vec<P>, Vec<Vertex>) {
    let behind = places.len().div_ceil(2) + points.len();
    let number = |at: usize| at / 2 + if at.is_multiple_of(2) { 0 } else { behind };
    let vertices = (0..places.len()).map(|at| Vertex::input(number(at))).collect();
    let every_other = |from: usize| places.iter().skip(from).step_by(2).copied();
    (every_other(0).chain(points).chain(every_other(1)).collect(), vertices)
}

/// Points separated from the probed places, which reverses [`numbered`].
#[derive(Clone, PartialEq, Debug)]
pub struct Unnumbered {
    /// The points that are not probes, in their order.
    pub points: Vec<Vec<f64>>,
    /// The places, in the order of the probes.
    pub places: Vec<Vec<f64>>,
    /// The index in `points` of each vertex of the scene that is not a probe.
    numbers: Vec<usize>,
}

/// Separates a scene into its points and the places of its probes.
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
    /// The vertex number among `points` of a scene's vertex that is not a probe.
    #[must_use]
    pub fn vertex(&self, v: Vertex) -> Vertex {
        Vertex::input(self.numbers[v.index()])
    }
}
