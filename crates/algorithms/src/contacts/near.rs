//! The broad phase: which pairs are near enough to be asked about.
//!
//! Two surfaces meet along curves, and most simplices are nowhere near the
//! other complex. The boxes of two simplices that are near each other lie in
//! those of two maximal ones, which are near each other too. So maximal
//! simplices come first, and after them only simplices all of whose vertices
//! belong to a maximal one that has found another are looked at again.

use std::sync::atomic::{AtomicBool, Ordering};

use predicament_grid::{Bounds, BoxIndex};
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Axis, Scene, Vertex};
use rayon::prelude::*;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// So many simplices make a piece of work.
pub(super) const PIECE: usize = 512;

/// The simplices that can have near ones in the other complex, and the boxes
/// of the second complex' in an index for each rank.
pub(super) struct Near<'a, const D: usize> {
    scene: &'a Scene,
    a: [Vec<u32>; 4],
    b: [(Vec<u32>, BoxIndex<D>); 4],
    reach: f64,
}

impl<'a, const D: usize> Near<'a, D> {
    pub(super) fn new(scene: &'a Scene, [a, b]: [&Complex; 2], reach: f64) -> Near<'a, D> {
        let [of_a, of_b] = touched::<D>(scene, [a, b], reach);
        let indexed = |rank: u8| {
            let places = within(b, rank, &of_b);
            let boxes = places.par_iter().with_min_len(PIECE);
            let boxes = boxes.map(|&index| bounds(scene, b.vertices_of(Simplex { rank, index })));
            let index = BoxIndex::new(boxes.collect());
            (places, index)
        };
        Near { scene, a: [0, 1, 2, 3].map(|rank| within(a, rank, &of_a)), b: [0, 1, 2, 3].map(indexed), reach }
    }

    /// The places of the first complex' simplices of this rank that can have near ones.
    pub(super) fn firsts(&self, rank: u8) -> &[u32] {
        &self.a[rank as usize]
    }

    /// The places of the second complex' simplices of this rank whose boxes
    /// are within reach of the box of a simplex of the first, in ascending order.
    pub(super) fn to(&self, vertices: &[Vertex], rank: u8, found: &mut Vec<u32>) {
        let (places, index) = &self.b[rank as usize];
        index.near(&bounds(self.scene, vertices), self.reach, found);
        for place in found {
            *place = places[*place as usize];
        }
    }
}

/// For each complex the vertices of those maximal simplices that have near ones.
fn touched<const D: usize>(scene: &Scene, [a, b]: [&Complex; 2], reach: f64) -> [Vec<AtomicBool>; 2] {
    let none = || (0..scene.len()).map(|_| AtomicBool::new(false)).collect();
    let of: [Vec<AtomicBool>; 2] = [none(), none()];
    let touch = |which: usize, vertices: &[Vertex]| {
        vertices.iter().for_each(|v| of[which][v.index()].store(true, Ordering::Relaxed));
    };
    let boxes = b.maximal().par_iter().with_min_len(PIECE);
    let index = BoxIndex::new(boxes.map(|&t| bounds::<D>(scene, b.vertices_of(t))).collect());
    a.maximal().par_chunks(PIECE).for_each(|piece| {
        let mut found = Vec::new();
        for &s in piece {
            let vertices = a.vertices_of(s);
            index.near(&bounds(scene, vertices), reach, &mut found);
            if !found.is_empty() {
                touch(0, vertices);
            }
            found.iter().for_each(|&t| touch(1, b.vertices_of(b.maximal()[t as usize])));
        }
    });
    of
}

/// The places of the simplices of this rank all of whose vertices are touched.
fn within(complex: &Complex, rank: u8, touched: &[AtomicBool]) -> Vec<u32> {
    let count = match rank {
        0 => complex.vertices().len(),
        1 => complex.edges().len(),
        2 => complex.triangles().len(),
        _ => complex.tetrahedra().len(),
    };
    let count = u32::try_from(count).expect("a complex holds 2^32 at most");
    let is_touched = |v: &Vertex| touched[v.index()].load(Ordering::Relaxed);
    let all = |index: &u32| complex.vertices_of(Simplex { rank, index: *index }).iter().all(is_touched);
    (0..count).into_par_iter().with_min_len(PIECE).filter(all).collect()
}

fn bounds<const D: usize>(scene: &Scene, vertices: &[Vertex]) -> Bounds<D> {
    Bounds::of(vertices.iter().map(|&v| std::array::from_fn(|axis| scene.coordinate(AXES[axis], v))))
}
