//! Faults planted in the resolution of meshes that cross themselves.

use crate::planted::{Fault, Honest, fault};

/// What a resolution gets wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrong {
    /// Nothing.
    Nothing,
    /// No triangles that meet are found.
    LooksForNothing,
    /// Triangles of one plane are cut apart from each other.
    CutsApart,
    /// Corners that touch a triangle inside are no corners of its parts.
    ForgetsPoints,
    /// Faces with the inside on both sides stay.
    KeepsInside,
}

/// A fault of a resolution.
pub trait Planted: Fault {
    /// What goes wrong.
    const WRONG: Wrong;
}

impl Planted for Honest {
    const WRONG: Wrong = Wrong::Nothing;
}

fault!(
    LooksForNothing,
    "Triangles that meet and are not found.",
    "mesh-resolve-search",
    "no triangles that meet are found",
    WRONG: Wrong = Wrong::LooksForNothing
);

fault!(
    CutsApart,
    "Triangles of one plane that are cut apart from each other.",
    "mesh-resolve-planes",
    "triangles of one plane are cut apart from each other",
    WRONG: Wrong = Wrong::CutsApart
);

fault!(
    ForgetsPoints,
    "Corners that touch a triangle and are forgotten.",
    "mesh-resolve-points",
    "corners that touch a triangle inside are no corners of its parts",
    WRONG: Wrong = Wrong::ForgetsPoints
);

fault!(
    KeepsInside,
    "Faces inside that stay.",
    "mesh-resolve-inside",
    "faces with the inside on both sides stay",
    WRONG: Wrong = Wrong::KeepsInside
);
