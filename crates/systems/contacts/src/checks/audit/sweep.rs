//! Pairs of simplices whose boxes are near, found by a sweep along x that shares nothing with the broad phase of the
//! audited driver.
//!
//! A plain sweep would compare all boxes with each box if one edge were very long. The sweep therefore groups boxes
//! into classes by the powers of two of their extents along x. It sweeps each class with the largest width of the
//! class.

use std::collections::BTreeMap;

use predicament_arithmetic::difference_up;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Axis, Dimension, Scene};
use rayon::prelude::*;

#[derive(Clone, Copy)]
struct Boxed {
    simplex: Simplex,
    /// Low and high along each axis; in the plane, those of z are zero.
    extent: [[f64; 2]; 3],
}

impl Boxed {
    fn width(&self) -> f64 {
        difference_up(self.extent[0][1], self.extent[0][0])
    }
}

/// Boxes of about the same extent along x, sorted by their starts.
struct Class {
    boxes: Vec<Boxed>,
    widest: f64,
}

/// The pairs of these ranks whose boxes are within `reach` along every axis, sorted.
///
/// If `reach` is not zero, sums with it are rounded: a pair at exactly that distance may be left out. This is harmless,
/// as such a pair need not be registered.
pub(super) fn near(scene: &Scene, [a, b]: [&Complex; 2], ranks: [u8; 2], reach: f64) -> Vec<[Simplex; 2]> {
    let classes = classes(boxes(scene, b, ranks[1]));
    let near = |s: Boxed| {
        let [low, high] = s.extent[0];
        classes.iter().flat_map(move |class| {
            // A box that starts before this position has ended before the query box.
            let ended = ((low - reach).next_down() - class.widest).next_down();
            let begin = class.boxes.partition_point(|t| t.extent[0][0] < ended);
            let candidates = class.boxes[begin..].iter().take_while(move |t| t.extent[0][0] <= high + reach);
            let is_near = move |t: &&Boxed| {
                let mut axes = s.extent.iter().zip(&t.extent);
                axes.all(|(s, t)| t[0] <= s[1] + reach && s[0] <= t[1] + reach)
            };
            candidates.filter(is_near).map(move |t| [s.simplex, t.simplex])
        })
    };
    let mut pairs: Vec<_> = boxes(scene, a, ranks[0]).into_par_iter().flat_map_iter(near).collect();
    pairs.par_sort_unstable();
    pairs
}

fn classes(boxes: Vec<Boxed>) -> Vec<Class> {
    let mut classes: BTreeMap<u64, Vec<Boxed>> = BTreeMap::new();
    for boxed in boxes {
        // the exponent's bits
        classes.entry(boxed.width().to_bits() >> 52).or_default().push(boxed);
    }
    let class = |mut boxes: Vec<Boxed>| {
        boxes.sort_by(|s, t| s.extent[0][0].total_cmp(&t.extent[0][0]));
        let widest = boxes.iter().map(Boxed::width).fold(0.0, f64::max);
        Class { boxes, widest }
    };
    classes.into_values().map(class).collect()
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
        let mut extent = [[0.0; 2]; 3];
        for (along, &axis) in extent.iter_mut().zip(axes) {
            let coordinates = || complex.vertices_of(simplex).iter().map(|&v| scene.coordinate(axis, v));
            *along = [coordinates().fold(f64::INFINITY, f64::min), coordinates().fold(f64::NEG_INFINITY, f64::max)];
        }
        Boxed { simplex, extent }
    };
    (0..count).map(boxed).collect()
}

#[cfg(test)]
mod tests;
