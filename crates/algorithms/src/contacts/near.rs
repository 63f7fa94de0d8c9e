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
            let places = of_b.of(rank);
            let boxes = places.par_iter().with_min_len(PIECE);
            let boxes = boxes.map(|&index| bounds(scene, b.vertices_of(Simplex { rank, index })));
            let index = BoxIndex::new(boxes.collect());
            (places, index)
        };
        Near { scene, a: [0, 1, 2, 3].map(|rank| of_a.of(rank)), b: [0, 1, 2, 3].map(indexed), reach }
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

/// What of a complex is near the other one.
struct Touched<'a> {
    complex: &'a Complex,
    /// The maximal simplices that have near ones, by their places among the maximal.
    maximal: Vec<AtomicBool>,
    /// The vertices of these.
    vertices: Vec<AtomicBool>,
}

impl<'a> Touched<'a> {
    fn nothing(scene: &Scene, complex: &'a Complex) -> Touched<'a> {
        let none = |count: usize| (0..count).map(|_| AtomicBool::new(false)).collect();
        Touched { complex, maximal: none(complex.maximal().len()), vertices: none(scene.len()) }
    }

    fn touch(&self, place: usize) {
        // many threads find the same ones: what is set already is not written again
        if !self.maximal[place].load(Ordering::Relaxed) {
            self.maximal[place].store(true, Ordering::Relaxed);
            let vertices = self.complex.vertices_of(self.complex.maximal()[place]);
            vertices.iter().for_each(|v| self.vertices[v.index()].store(true, Ordering::Relaxed));
        }
    }

    /// The places of all simplices of this rank that can have near ones.
    fn of(&self, rank: u8) -> Vec<u32> {
        let complex = self.complex;
        let count = match rank {
            0 => complex.vertices().len(),
            1 => complex.edges().len(),
            2 => complex.triangles().len(),
            _ => complex.tetrahedra().len(),
        };
        let count = u32::try_from(count).expect("a complex holds 2^32 at most");
        let start = complex.maximal().partition_point(|maximal| maximal.rank < rank);
        let maximal = &complex.maximal()[start..];
        let maximal = &maximal[..maximal.partition_point(|maximal| maximal.rank == rank)];
        let can = |index: &u32| {
            let place = if maximal.len() == count as usize {
                Ok(*index as usize)
            } else {
                maximal.binary_search_by_key(index, |simplex| simplex.index)
            };
            let is_touched = |v: &Vertex| self.vertices[v.index()].load(Ordering::Relaxed);
            match place {
                Ok(place) => self.maximal[start + place].load(Ordering::Relaxed),
                Err(_) => complex.vertices_of(Simplex { rank, index: *index }).iter().all(is_touched),
            }
        };
        (0..count).into_par_iter().with_min_len(PIECE).filter(can).collect()
    }
}

/// What each of the complexes has near the other.
fn touched<'a, const D: usize>(scene: &Scene, [a, b]: [&'a Complex; 2], reach: f64) -> [Touched<'a>; 2] {
    let of = [a, b].map(|complex| Touched::nothing(scene, complex));
    let boxes = b.maximal().par_iter().with_min_len(PIECE);
    let index = BoxIndex::new(boxes.map(|&t| bounds::<D>(scene, b.vertices_of(t))).collect());
    (0..a.maximal().len()).into_par_iter().with_min_len(PIECE).for_each_init(Vec::new, |found, place| {
        index.near(&bounds(scene, a.vertices_of(a.maximal()[place])), reach, found);
        if !found.is_empty() {
            of[0].touch(place);
        }
        found.iter().for_each(|&t| of[1].touch(t as usize));
    });
    of
}

fn bounds<const D: usize>(scene: &Scene, vertices: &[Vertex]) -> Bounds<D> {
    Bounds::of(vertices.iter().map(|&v| std::array::from_fn(|axis| scene.coordinate(AXES[axis], v))))
}
