//! Faults planted in rounding.

use crate::planted::{Fault, Honest, fault};

/// What rounding gets wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrong {
    /// Nothing.
    Nothing,
    /// No flaws are found.
    LooksForNothing,
}

/// A fault of rounding.
pub trait Planted: Fault {
    /// What goes wrong.
    const WRONG: Wrong;
}

impl Planted for Honest {
    const WRONG: Wrong = Wrong::Nothing;
}

fault!(
    LooksForNothing,
    "Flaws that are not found.",
    "mesh-rounding-search",
    "no flaws of rounding are found",
    WRONG: Wrong = Wrong::LooksForNothing
);
