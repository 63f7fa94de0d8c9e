//! A mesh with a grid over its triangles, and the regions of empty cells.

use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_grid::two_level::{EmptyRegions, Sizes, Slot, TwoLevel};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::{Predicates, Scene, Vertex};
use rayon::prelude::*;

use super::{Location, Scratch};

/// The number of triangles in one thread's work item.
const PART: usize = 4096;

/// A mesh with a broad phase over it. It depends on raw coordinates only, not on a backend.
#[derive(Clone, Debug)]
pub struct MeshIndex {
    mesh: Arc<MaterialMesh>,
    grid: TwoLevel,
    empty: EmptyRegions,
    shadows: Vec<Shadow>,
}

/// The box of a triangle as seen from above, rounded outward to 16 bytes; the corners take 84 bytes at four addresses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shadow {
    low: [f32; 2],
    high: [f32; 2],
}

impl Shadow {
    fn of(bounds: &Bounds<3>) -> Shadow {
        // Rounded to the nearest float, then outward if that was inward; on overflow the bound is infinite or the
        // largest float.
        #[allow(clippy::cast_possible_truncation)]
        let down = |x: f64| if f64::from(x as f32) > x { (x as f32).next_down() } else { x as f32 };
        #[allow(clippy::cast_possible_truncation)]
        let up = |x: f64| if f64::from(x as f32) < x { (x as f32).next_up() } else { x as f32 };
        let ([lx, ly, _], [hx, hy, _]) = (bounds.low, bounds.high);
        Shadow { low: [down(lx), down(ly)], high: [up(hx), up(hy)] }
    }

    /// True if the vertical line through (x, y) meets the box.
    #[inline(always)]
    pub(super) fn has(&self, x: f64, y: f64) -> bool {
        let ([lx, ly], [hx, hy]) = (self.low, self.high);
        (f64::from(lx) <= x) & (x <= f64::from(hx)) & (f64::from(ly) <= y) & (y <= f64::from(hy))
    }
}

/// The regions of the cells without triangles, found with a session.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Labels {
    /// The region of each cell, or [`UNKNOWN`].
    of_slot: Vec<u32>,
}

/// The label of a cell whose region is not known.
const UNKNOWN: u32 = u32::MAX;

impl Labels {
    /// The region that contains a whole cell, if there are labels and the region is known.
    pub(super) fn get(&self, slot: Slot) -> Option<u32> {
        self.of_slot.get(slot.index()).copied().filter(|&region| region != UNKNOWN)
    }

    /// The region that contains a whole cell, if it is known.
    #[inline]
    pub(super) fn of(&self, slot: Slot) -> Option<u32> {
        let region = self.of_slot[slot.index()];
        (region != UNKNOWN).then_some(region)
    }

    /// The memory of the labels, in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * self.of_slot.len()
    }
}

impl MeshIndex {
    /// Builds the index of a mesh, with a grid of the sizes [`Sizes::of`].
    ///
    /// # Panics
    /// If the mesh has vertices that the scene lacks, or the scene is planar.
    #[must_use]
    pub fn new(mesh: impl Into<Arc<MaterialMesh>>, scene: &Scene) -> MeshIndex {
        MeshIndex::with_sizes(mesh, scene, None)
    }

    /// Builds the index like [`MeshIndex::new`], with a grid of the given sizes.
    ///
    /// # Panics
    /// As [`MeshIndex::new`].
    #[must_use]
    pub fn with_sizes(mesh: impl Into<Arc<MaterialMesh>>, scene: &Scene, sizes: Option<Sizes>) -> MeshIndex {
        let mesh: Arc<MaterialMesh> = mesh.into();
        let of_triangle = |corners: &[Vertex; 3]| Bounds::of(corners.map(|v| scene.point3(v)));
        let boxes: Vec<Bounds<3>> = mesh.triangles().par_iter().with_min_len(PART).map(of_triangle).collect();
        let grid = TwoLevel::new(&boxes, sizes.unwrap_or_else(|| Sizes::of(&boxes)));
        let shadows = boxes.par_iter().with_min_len(PART).map(Shadow::of).collect();
        drop(boxes);
        let empty = grid.empty_regions();
        MeshIndex { mesh, grid, empty, shadows }
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &MaterialMesh {
        &self.mesh
    }

    /// The grid over the triangles' boxes.
    #[must_use]
    pub fn grid(&self) -> &TwoLevel {
        &self.grid
    }

    /// The memory of the grid, its regions and the triangles' boxes, in bytes, without the mesh.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.grid.bytes() + self.empty.bytes() + size_of_val(&self.shadows[..])
    }

    #[inline(always)]
    pub(super) fn shadows(&self) -> &[Shadow] {
        &self.shadows
    }

    /// One point in each region of empty cells whose mesh region does not follow from the grid's border.
    #[must_use]
    pub fn references(&self) -> Vec<[f64; 3]> {
        let slots = self.empty.first().iter().enumerate().filter(|&(region, _)| !self.empty.is_open(region));
        slots.filter_map(|(_, &slot)| self.grid.middle(slot)).collect()
    }

    /// Finds the regions of empty cells, by one ray for each set of connected cells. The ray starts at the first of the
    /// given vertices in the set. A set without a vertex has no label; points in it are located by their own rays.
    ///
    /// Vertices can be the queries themselves, or those of [`references`](MeshIndex::references).
    ///
    /// # Panics
    /// If the session's scene lacks one of the vertices.
    pub fn labels<P: Predicates + ?Sized>(&self, session: &P, vertices: &[Vertex]) -> Labels {
        let scene = session.scene();
        let mut first: Vec<Option<Vertex>> = vec![None; self.empty.len()];
        for &v in vertices {
            if let Some(region) = self.empty.of(self.grid.at(scene.point3(v))) {
                first[region].get_or_insert(v);
            }
        }
        let none = Labels { of_slot: Vec::new() };
        let is_labelled = session.allows("empty-cells");
        let of_region = |region: usize| {
            if !is_labelled {
                return UNKNOWN;
            }
            if self.empty.is_open(region) {
                return OUTSIDE;
            }
            let Some(v) = first[region] else { return UNKNOWN };
            match self.by_ray(session, &none, v, &mut Scratch::new()) {
                Location::In(region) => region,
                // A point in an empty cell is on no triangle. If the session contradicts that, it is queried for each
                // point.
                Location::On(_) | Location::Contradiction | Location::Undecided => UNKNOWN,
            }
        };
        let of_region = predicament_grid::parallel::each(self.empty.len(), &of_region);
        let of_slot = |slot: usize| self.empty.of_index(slot).map_or(UNKNOWN, |region| of_region[region]);
        Labels { of_slot: (0..self.grid.slots()).into_par_iter().with_min_len(PART).map(of_slot).collect() }
    }
}
