//! The laws of an overlay of two meshes, decided in rationals.
//!
//! Three laws suffice (`pieces.rs`, `located.rs`): pieces of each triangle cover it once; no piece passes through
//! another one; and each piece is in the region of the other mesh that contains its middle, according to the judge of
//! points in meshes. The other laws follow from these and are decided by other means: volumes and areas of results
//! (`measures.rs`), the topology of pieces (`topology.rs`), points in space in results (`located.rs`). The results
//! without the perturbation, and in doubles, are compared with these (`settled.rs`). Contacts are compared with all
//! intersections of two triangles (`contacts.rs`).

pub mod chains;
mod contacts;
mod located;
mod measures;
mod pieces;
pub mod replies;
mod settled;
pub mod shells;
mod surface;
mod topology;
mod touches;

use std::sync::Arc;

use crate::answer::{Regions, Source};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Scene, Vertex};

pub use crate::truth::Point;
pub use measures::{Corners, Measure, Parts, Sums, Together};
pub use settled::{OfSurfaces, Settled, Settlement};
pub use surface::flaw_of;

/// A violation of a law.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The name of the check.
    pub check: &'static str,
    /// The value found.
    pub got: String,
    /// The law.
    pub law: &'static str,
}

/// Violations of laws, in the order in which they were found.
pub type Violations = Vec<Violation>;

/// Records a violation of a law.
pub(crate) fn note(found: &mut Violations, check: &'static str, got: String, law: &'static str) {
    found.push(Violation { check, got, law });
}

/// An overlay of two meshes under test.
#[derive(Clone, Debug)]
pub struct Laws<'a> {
    /// The given vertices.
    pub scene: &'a Scene,
    /// The meshes.
    pub meshes: &'a [Arc<MaterialMesh>; 2],
    /// All pieces, with the regions of both meshes on either side.
    pub regions: &'a Regions,
    /// The surface of each operation, in the order of [`Operation::ALL`](predicament_overlay::answer::Operation::ALL).
    pub solids: &'a [Vec<[Vertex; 3]>; 4],
    /// For each triangle of these, its source.
    pub sources: &'a [Vec<Source>; 4],
    /// The constructions.
    pub constructions: &'a [Construction],
    /// The number of constructions that the scene had before.
    pub before: usize,
    /// The positions of all vertices: those of the scene, then the constructed ones.
    pub points: Vec<Point>,
}

impl Laws<'_> {
    fn place(&self, v: Vertex) -> usize {
        v.construction().map_or(v.index(), |index| self.scene.len() + index - self.before)
    }

    /// The places of a triangle's corners among the points.
    fn places(&self, triangle: [Vertex; 3]) -> [u32; 3] {
        triangle.map(|v| u32::try_from(self.place(v)).expect("fewer than 2^32 vertices"))
    }

    fn corners(&self, triangle: [Vertex; 3]) -> [&Point; 3] {
        triangle.map(|v| &self.points[self.place(v)])
    }
}

/// A triangle in words.
pub(crate) fn name(source: Source) -> String {
    format!("triangle {} of the {} mesh", source.triangle, ["first", "second"][usize::from(source.mesh)])
}
