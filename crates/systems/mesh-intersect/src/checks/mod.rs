//! The laws that an overlay of two meshes satisfies, decided in rationals.
//!
//! Pieces of each triangle cover it once, no piece passes through another one, and each piece is in the region of the other mesh that its
//! middle is in, as the judge of points in meshes says: that is all there is to it (`pieces.rs`, `located.rs`). The rest follows from this and is decided
//! by other means: volumes and areas of results (`measures.rs`), how pieces hang together (`topology.rs`), points of space in results
//! (`located.rs`). What results are without the perturbation, and in doubles, is held against them (`settled.rs`).

mod located;
mod measures;
mod pieces;
mod settled;
mod surface;
mod topology;

use std::sync::Arc;

use crate::answer::{Regions, Source};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Scene, Vertex};

pub use crate::truth::Point;
pub use measures::{Measure, Sums, add};
pub use settled::{Settled, Settlement};
pub use surface::flaw_of;

/// What violates a law.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Violation {
    /// The name of the check.
    pub check: &'static str,
    /// What was found.
    pub got: String,
    /// What holds.
    pub law: &'static str,
}

/// What violates laws, in the order in which it was found.
pub type Violations = Vec<Violation>;

/// Notes what violates a law.
pub(crate) fn note(found: &mut Violations, check: &'static str, got: String, law: &'static str) {
    found.push(Violation { check, got, law });
}

/// An overlay of two meshes, to be held against laws.
#[derive(Clone, Debug)]
pub struct Laws<'a> {
    /// The vertices that were given.
    pub scene: &'a Scene,
    /// The meshes.
    pub meshes: &'a [Arc<MaterialMesh>; 2],
    /// All pieces, with the regions of both meshes on either side.
    pub regions: &'a Regions,
    /// The surface of each operation, in the order of [`Operation::ALL`](predicament_overlay::answer::Operation::ALL).
    pub solids: &'a [Vec<[Vertex; 3]>; 4],
    /// For each triangle of these what it is, or is a piece of.
    pub sources: &'a [Vec<Source>; 4],
    /// What was constructed.
    pub constructions: &'a [Construction],
    /// How many constructions the scene had before.
    pub before: usize,
    /// Where all vertices are: those of the scene, then the constructed ones.
    pub points: Vec<Point>,
}

impl Laws<'_> {
    fn place(&self, v: Vertex) -> usize {
        v.construction().map_or(v.index(), |index| self.scene.len() + index - self.before)
    }

    fn corners(&self, triangle: [Vertex; 3]) -> [&Point; 3] {
        triangle.map(|v| &self.points[self.place(v)])
    }
}

/// A triangle in words.
pub(crate) fn name(source: Source) -> String {
    format!("triangle {} of the {} mesh", source.triangle, ["first", "second"][usize::from(source.mesh)])
}
