//! A fault planted in the index that locates points in maps. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// The cells of the broad phase lack an edge.
    const SKIPS_AN_EDGE: bool = false;
}

impl Planted for Honest {}

/// A map one edge of which is in no cell of the grid.
#[derive(Clone, Copy, Debug)]
pub struct SkippedEdge;

impl Fault for SkippedEdge {
    const NAME: &'static str = "skipped-edge";
    const WHAT: &'static str = "the grid skips an edge in the middle of the map";
}

impl Planted for SkippedEdge {
    const SKIPS_AN_EDGE: bool = true;
}
