//! The broad phase: which pairs are near enough to be asked about.

use predicament_grid::{Bounds, BoxIndex};
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Axis, Scene, Vertex};
use rayon::prelude::*;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// How many simplices a complex has of each rank.
pub(super) fn counts(complex: &Complex) -> [usize; 4] {
    [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), complex.tetrahedra().len()]
}

/// The boxes of one complex' simplices, found by those of the other's.
pub(super) struct Near<'a, const D: usize> {
    scene: &'a Scene,
    /// An index for each rank.
    of: [BoxIndex<D>; 4],
    reach: f64,
}

impl<'a, const D: usize> Near<'a, D> {
    pub(super) fn new(scene: &'a Scene, b: &Complex, reach: f64) -> Near<'a, D> {
        let of = |rank: u8| {
            let count = u32::try_from(counts(b)[rank as usize]).expect("a complex holds 2^32 at most");
            let simplex = |index: u32| bounds(scene, b.vertices_of(Simplex { rank, index }));
            BoxIndex::new((0..count).into_par_iter().map(simplex).collect())
        };
        let ([v, e], [f, t]) = rayon::join(|| [of(0), of(1)], || [of(2), of(3)]);
        Near { scene, of: [v, e, f, t], reach }
    }

    /// The places of the second complex' simplices of this rank whose boxes
    /// are within reach of the box of a simplex of the first, in ascending order.
    pub(super) fn to(&self, vertices: &[Vertex], rank: u8, found: &mut Vec<u32>) {
        self.of[rank as usize].near(&bounds(self.scene, vertices), self.reach, found);
    }
}

fn bounds<const D: usize>(scene: &Scene, vertices: &[Vertex]) -> Bounds<D> {
    Bounds::of(vertices.iter().map(|&v| std::array::from_fn(|axis| scene.coordinate(AXES[axis], v))))
}
