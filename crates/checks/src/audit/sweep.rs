//! Pairs of simplices whose boxes are near: a sweep along x, which has nothing
//! in common with the broad phase of the driver under audit.

use predicament_arithmetic::difference_up;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Axis, Dimension, Scene};

struct Boxed {
    simplex: Simplex,
    /// Low and high along each axis.
    extent: Vec<[f64; 2]>,
}

/// The pairs of these ranks whose boxes are within `reach` along every axis,
/// sorted.
///
/// Where `reach` is not zero, sums with it are rounded: a pair at just that
/// distance may be left out, which is no loss as nothing promises to register it.
pub(super) fn near(scene: &Scene, [a, b]: [&Complex; 2], ranks: [u8; 2], reach: f64) -> Vec<[Simplex; 2]> {
    let [first, second] = [boxes(scene, a, ranks[0]), boxes(scene, b, ranks[1])];
    let widest = second.iter().map(|t| difference_up(t.extent[0][1], t.extent[0][0])).fold(0.0, f64::max);
    let mut pairs = Vec::new();
    for s in &first {
        let [low, high] = s.extent[0];
        // Boxes are sorted by where they start; one that starts before this has ended.
        let ended = ((low - reach).next_down() - widest).next_down();
        let begin = second.partition_point(|t| t.extent[0][0] < ended);
        for t in second[begin..].iter().take_while(|t| t.extent[0][0] <= high + reach) {
            let mut axes = s.extent.iter().zip(&t.extent);
            if axes.all(|(s, t)| t[0] <= s[1] + reach && s[0] <= t[1] + reach) {
                pairs.push([s.simplex, t.simplex]);
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

fn boxes(scene: &Scene, complex: &Complex, rank: u8) -> Vec<Boxed> {
    let count = match rank {
        0 => complex.vertices().len(),
        1 => complex.edges().len(),
        2 => complex.triangles().len(),
        _ => complex.tetrahedra().len(),
    };
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let boxed = |index: usize| {
        let simplex = Simplex { rank, index: u32::try_from(index).expect("a complex holds 2^32 at most") };
        let along = |&axis: &Axis| {
            let coordinates = || complex.vertices_of(simplex).iter().map(|&v| scene.coordinate(axis, v));
            [coordinates().fold(f64::INFINITY, f64::min), coordinates().fold(f64::NEG_INFINITY, f64::max)]
        };
        Boxed { simplex, extent: axes.iter().map(along).collect() }
    };
    let mut boxes: Vec<Boxed> = (0..count).map(boxed).collect();
    boxes.sort_by(|s, t| s.extent[0][0].total_cmp(&t.extent[0][0]));
    boxes
}
