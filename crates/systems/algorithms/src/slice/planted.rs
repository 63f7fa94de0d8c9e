//! Faults planted in slicing. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What is wrong in a run.
#[derive(Clone, Copy, Debug)]
pub struct Wrong {
    pub(super) duplicates: bool,
    pub(super) one_loop: bool,
    pub(super) reverses_caps: bool,
    pub(super) wrong_side: bool,
    pub(super) unsorted: bool,
}

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// The two faces at an edge get split points of their own.
    const DUPLICATES: bool = false;
    /// Of a cap with several loops only one is covered.
    const ONE_LOOP: bool = false;
    /// Caps face into the part.
    const REVERSES_CAPS: bool = false;
    /// A face is put with the part on the other side.
    const WRONG_SIDE: bool = false;
    /// The points of a face on the plane are taken as they come.
    const UNSORTED: bool = false;
    /// All of these.
    const WRONG: Wrong = Wrong {
        duplicates: Self::DUPLICATES,
        one_loop: Self::ONE_LOOP,
        reverses_caps: Self::REVERSES_CAPS,
        wrong_side: Self::WRONG_SIDE,
        unsorted: Self::UNSORTED,
    };
}

impl Planted for Honest {}

/// Split points that each face has for itself.
#[derive(Clone, Copy, Debug)]
pub struct DuplicatedSplitPoints;

impl Fault for DuplicatedSplitPoints {
    const NAME: &'static str = "duplicated-split-points";
    const WHAT: &'static str = "each of the two faces at an edge that crosses the plane has a split point of its own";
}

impl Planted for DuplicatedSplitPoints {
    const DUPLICATES: bool = true;
}

/// Caps with holes in them that are covered over.
#[derive(Clone, Copy, Debug)]
pub struct OneLoopCapped;

impl Fault for OneLoopCapped {
    const NAME: &'static str = "one-loop-capped";
    const WHAT: &'static str = "of a cap with several loops only the first is covered";
}

impl Planted for OneLoopCapped {
    const ONE_LOOP: bool = true;
}

/// Caps that face the wrong way.
#[derive(Clone, Copy, Debug)]
pub struct ReversedCaps;

impl Fault for ReversedCaps {
    const NAME: &'static str = "reversed-caps";
    const WHAT: &'static str = "caps face into the part";
}

impl Planted for ReversedCaps {
    const REVERSES_CAPS: bool = true;
}

/// A face that went with the wrong part.
#[derive(Clone, Copy, Debug)]
pub struct WrongSide;

impl Fault for WrongSide {
    const NAME: &'static str = "wrong-side";
    const WHAT: &'static str = "a face is put with the part on the other side";
}

impl Planted for WrongSide {
    const WRONG_SIDE: bool = true;
}

/// Crossings of a concave face that are paired in the order of its edges.
#[derive(Clone, Copy, Debug)]
pub struct UnsortedSplitPoints;

impl Fault for UnsortedSplitPoints {
    const NAME: &'static str = "unsorted-split-points";
    const WHAT: &'static str = "the points of a concave face on the plane are joined in the order of its edges";
}

impl Planted for UnsortedSplitPoints {
    const UNSORTED: bool = true;
}
