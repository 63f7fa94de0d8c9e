//! Faults planted in finding and sorting crossings. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// A segment is not looked at where it begins at the very x at which another one ends.
    const STOPS_EARLY: bool = false;
    /// Crossings stay in the order in which they were found.
    const LEAVES_UNSORTED: bool = false;
}

impl Planted for Honest {}

/// A sweep that is strict where it has to be closed: a perturbation can cross what touches.
#[derive(Clone, Copy, Debug)]
pub struct StrictSweep;

impl Fault for StrictSweep {
    const NAME: &'static str = "strict-sweep";
    const WHAT: &'static str = "segments that begin at the x at which another one ends are not looked at";
}

impl Planted for StrictSweep {
    const STOPS_EARLY: bool = true;
}

/// Crossings that are not sorted along their segment.
#[derive(Clone, Copy, Debug)]
pub struct UnsortedCrossings;

impl Fault for UnsortedCrossings {
    const NAME: &'static str = "unsorted-crossings";
    const WHAT: &'static str = "the crossings of a segment are in the order of the other segments";
}

impl Planted for UnsortedCrossings {
    const LEAVES_UNSORTED: bool = true;
}
