//! Faults planted in the location of points in meshes. See [`crate::planted`].

use crate::planted::{Fault, Honest, fault};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// The grid lists a triangle in one of its cells only.
    const SKIPS_A_TRIANGLE: bool = false;
    /// Cells inside of a region are taken for those outside.
    const MISTAKES_A_CAVITY: bool = false;
    /// Of two triangles above a point the farther is taken.
    const TAKES_THE_FARTHER: bool = false;
}

impl Planted for Honest {}

fault!(
    SkippedTriangle,
    "A triangle that most cells of the grid do not know.",
    "skipped-triangle",
    "the grid lists a triangle in the cell of one corner only",
    SKIPS_A_TRIANGLE
);
fault!(
    MistakenCavity,
    "A cavity with the label of the outside.",
    "mistaken-cavity",
    "a set of empty cells inside of a region is taken for the outside",
    MISTAKES_A_CAVITY
);
fault!(
    FartherTriangle,
    "Rays that end at a triangle behind another.",
    "farther-triangle",
    "of two triangles above a point the farther is taken",
    TAKES_THE_FARTHER
);
