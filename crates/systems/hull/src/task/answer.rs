//! The two tasks of hulls, and the answer of each.

use predicament_tasks::{Answer, digest};

use crate::algorithm::{Contradiction, Hull2, Hull3};

/// The task `hull2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hull2d;

/// The answer to `hull2d`: a hull in the plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Polygon(pub Hull2);

impl Answer for Polygon {
    fn digest(&self) -> u64 {
        let broken = self.0.broken.map_or("", Contradiction::rule);
        digest(self.0.vertices.iter().flat_map(|v| v.index().to_le_bytes()).chain(broken.bytes()))
    }
}

/// The task `hull3d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hull3d;

/// The answer to `hull3d`: a hull in space.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Surface(pub Hull3);

impl Answer for Surface {
    fn digest(&self) -> u64 {
        let broken = self.0.broken.map_or("", Contradiction::rule);
        let faces = self.0.faces.iter().flat_map(|face| face.iter().map(|v| v.index()).chain([usize::MAX]));
        let vertices = self.0.vertices.iter().map(|v| v.index());
        digest(vertices.chain([usize::MAX]).chain(faces).flat_map(usize::to_le_bytes).chain(broken.bytes()))
    }
}
