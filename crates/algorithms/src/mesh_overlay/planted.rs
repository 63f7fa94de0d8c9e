//! Faults planted in the overlay of meshes.

use crate::planted::{Fault, Honest};

/// What an overlay gets wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrong {
    /// Nothing.
    Nothing,
    /// The third edge of a triangle is not looked at.
    LooksAtTwoSides,
    /// Points on an edge are sorted backwards.
    SortsPointsBackwards,
    /// A cut triangle loses a piece.
    DropsAPiece,
    /// A component without cuts is taken to be outside.
    TakesComponentsForOutside,
    /// Pieces of the second mesh are not turned over in a difference.
    ForgetsToTurn,
}

/// A fault of an overlay.
pub trait Planted: Fault {
    /// What goes wrong.
    const WRONG: Wrong;
}

impl Planted for Honest {
    const WRONG: Wrong = Wrong::Nothing;
}

macro_rules! fault {
    ($fault:ident, $name:literal, $what:literal) => {
        #[doc = $what]
        #[derive(Clone, Copy, Debug)]
        pub struct $fault;

        impl Fault for $fault {
            const NAME: &'static str = $name;
            const WHAT: &'static str = $what;
        }

        impl Planted for $fault {
            const WRONG: Wrong = Wrong::$fault;
        }
    };
}

fault!(LooksAtTwoSides, "mesh-overlay-two-sides", "the third edge of a triangle is not looked at");
fault!(SortsPointsBackwards, "mesh-overlay-backwards", "points on an edge are sorted backwards");
fault!(DropsAPiece, "mesh-overlay-drops-a-piece", "a cut triangle loses a piece");
fault!(TakesComponentsForOutside, "mesh-overlay-components", "a component without cuts is taken to be outside");
fault!(ForgetsToTurn, "mesh-overlay-turns", "pieces of the second mesh are not turned over in a difference");
