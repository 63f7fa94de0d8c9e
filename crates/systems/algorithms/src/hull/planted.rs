//! Faults planted in convex hulls. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// Three vertices in one line all stay on a chain.
    const KEEPS_COLLINEAR: bool = false;
    /// The common tangent of two chains moves along the first one only.
    const TURNS_ONE_END: bool = false;
    /// Vertices outside of a face that is replaced are held against the first of the new faces only.
    const TRIES_ONE_FACE: bool = false;
    /// Faces in one plane stay apart.
    const LEAVES_COPLANAR: bool = false;
    /// A stitching face is turned against the vertices of one part only.
    const WRAPS_ONE_PART: bool = false;
}

impl Planted for Honest {}

/// Vertices in the middle of an edge that stay.
#[derive(Clone, Copy, Debug)]
pub struct CollinearKept;

impl Fault for CollinearKept {
    const NAME: &'static str = "hull-collinear-kept";
    const WHAT: &'static str = "of three vertices in one line the hull keeps the one in the middle";
}

impl Planted for CollinearKept {
    const KEEPS_COLLINEAR: bool = true;
}

/// Tangents that are found at one end only.
#[derive(Clone, Copy, Debug)]
pub struct HalfTangent;

impl Fault for HalfTangent {
    const NAME: &'static str = "hull-half-tangent";
    const WHAT: &'static str = "the common tangent of two hulls moves along the first one only";
}

impl Planted for HalfTangent {
    const TURNS_ONE_END: bool = true;
}

/// Conflicts that get lost when faces are replaced.
#[derive(Clone, Copy, Debug)]
pub struct LostConflict;

impl Fault for LostConflict {
    const NAME: &'static str = "hull-lost-conflict";
    const WHAT: &'static str = "a vertex outside of a replaced face is held against one of the new faces only";
}

impl Planted for LostConflict {
    const TRIES_ONE_FACE: bool = true;
}

/// Coplanar faces that stay apart.
#[derive(Clone, Copy, Debug)]
pub struct CoplanarLeft;

impl Fault for CoplanarLeft {
    const NAME: &'static str = "hull-coplanar-left";
    const WHAT: &'static str = "faces of the hull in one plane are not merged";
}

impl Planted for CoplanarLeft {
    const LEAVES_COPLANAR: bool = true;
}

/// Stitching faces that look at one part only.
#[derive(Clone, Copy, Debug)]
pub struct OneSidedWrap;

impl Fault for OneSidedWrap {
    const NAME: &'static str = "hull-one-sided-wrap";
    const WHAT: &'static str = "a face that joins two hulls is turned against the vertices of the first one only";
}

impl Planted for OneSidedWrap {
    const WRAPS_ONE_PART: bool = true;
}
