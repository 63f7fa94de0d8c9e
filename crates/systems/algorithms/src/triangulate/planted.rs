//! Faults planted in triangulating. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// Three vertices in line are cut off like a convex corner.
    const CUTS_FLAT_CORNERS: bool = false;
    /// A split vertex is joined to the lower end of the chain, not to its last vertex.
    const JOINS_SPLITS_TO_THE_LEFT: bool = false;
    /// Ears are cut off without a look at what is in them.
    const LOOKS_INTO_NO_EAR: bool = false;
    /// The last triangle is not handed over.
    const DROPS_A_TRIANGLE: bool = false;
}

impl Planted for Honest {}

/// Corners that are flat are cut off.
#[derive(Clone, Copy, Debug)]
pub struct FlatCorners;

impl Fault for FlatCorners {
    const NAME: &'static str = "flat-corners";
    const WHAT: &'static str = "three vertices in line are cut off as a triangle";
}

impl Planted for FlatCorners {
    const CUTS_FLAT_CORNERS: bool = true;
}

/// Holes are joined to what may be hidden from them.
#[derive(Clone, Copy, Debug)]
pub struct HiddenHelper;

impl Fault for HiddenHelper {
    const NAME: &'static str = "hidden-helper";
    const WHAT: &'static str = "a split vertex is joined to the left end of the lower edge, which it may not see";
}

impl Planted for HiddenHelper {
    const JOINS_SPLITS_TO_THE_LEFT: bool = true;
}

/// Ears that other vertices are in.
#[derive(Clone, Copy, Debug)]
pub struct BlindEars;

impl Fault for BlindEars {
    const NAME: &'static str = "blind-ears";
    const WHAT: &'static str = "ears are cut off whether there are vertices in them or not";
}

impl Planted for BlindEars {
    const LOOKS_INTO_NO_EAR: bool = true;
}

/// A triangle that is missing.
#[derive(Clone, Copy, Debug)]
pub struct DroppedTriangle;

impl Fault for DroppedTriangle {
    const NAME: &'static str = "dropped-triangle";
    const WHAT: &'static str = "the last triangle is missing";
}

impl Planted for DroppedTriangle {
    const DROPS_A_TRIANGLE: bool = true;
}
