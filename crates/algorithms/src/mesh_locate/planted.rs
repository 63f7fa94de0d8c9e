//! Faults planted in the location of points in meshes. See [`crate::planted`].

use crate::planted::{Fault, Honest};

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

macro_rules! fault {
    ($type:ident, $name:literal, $what:literal, $constant:ident) => {
        #[doc = $what]
        #[derive(Clone, Copy, Debug)]
        pub struct $type;

        impl Fault for $type {
            const NAME: &'static str = $name;
            const WHAT: &'static str = $what;
        }

        impl Planted for $type {
            const $constant: bool = true;
        }
    };
}

fault!(
    SkippedTriangle,
    "skipped-triangle",
    "the grid lists a triangle in the cell of one corner only",
    SKIPS_A_TRIANGLE
);
fault!(
    MistakenCavity,
    "mistaken-cavity",
    "a set of empty cells inside of a region is taken for the outside",
    MISTAKES_A_CAVITY
);
fault!(FartherTriangle, "farther-triangle", "of two triangles above a point the farther is taken", TAKES_THE_FARTHER);
