//! A fault planted in locating points in cells of a line. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// A point at an end is inside, of both cells that meet there.
    const CLOSES_INTERVALS: bool = false;
}

impl Planted for Honest {}

/// Cells that hold both of their ends.
#[derive(Clone, Copy, Debug)]
pub struct ClosedInterval;

impl Fault for ClosedInterval {
    const NAME: &'static str = "closed-interval";
    const WHAT: &'static str = "a point at the end of a cell counts as inside";
}

impl Planted for ClosedInterval {
    const CLOSES_INTERVALS: bool = true;
}
