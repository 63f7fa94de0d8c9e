//! Faults planted in the overlay of meshes.

use crate::planted::{Fault, Honest, fault};

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
    /// What is in front of a piece is said to be behind it.
    SwapsSides,
    /// A registered contact is lost.
    LosesAContact,
    /// Of what both meshes have, no vertex is asked whether it is clear.
    TakesVerticesForClear,
    /// Of what both meshes have, no triangles are looked at whether they are apart.
    TakesTrianglesForApart,
}

/// A fault of an overlay.
pub trait Planted: Fault {
    /// What goes wrong.
    const WRONG: Wrong;
}

impl Planted for Honest {
    const WRONG: Wrong = Wrong::Nothing;
}

fault!(
    LooksAtTwoSides,
    "Edges that pass beside a triangle.",
    "mesh-overlay-two-sides",
    "the third edge of a triangle is not looked at",
    WRONG: Wrong = Wrong::LooksAtTwoSides
);
fault!(
    SortsPointsBackwards,
    "Points on an edge in the wrong order.",
    "mesh-overlay-backwards",
    "points on an edge are sorted backwards",
    WRONG: Wrong = Wrong::SortsPointsBackwards
);
fault!(
    DropsAPiece,
    "A piece that is lost.",
    "mesh-overlay-drops-a-piece",
    "a cut triangle loses a piece",
    WRONG: Wrong = Wrong::DropsAPiece
);
fault!(
    TakesComponentsForOutside,
    "A component in the wrong region.",
    "mesh-overlay-components",
    "a component without cuts is taken to be outside",
    WRONG: Wrong = Wrong::TakesComponentsForOutside
);
fault!(
    ForgetsToTurn,
    "Pieces that are inside out.",
    "mesh-overlay-turns",
    "pieces of the second mesh are not turned over in a difference",
    WRONG: Wrong = Wrong::ForgetsToTurn
);
fault!(
    SwapsSides,
    "Regions on the wrong sides.",
    "mesh-overlay-sides",
    "what is in front of a piece is said to be behind it",
    WRONG: Wrong = Wrong::SwapsSides
);
fault!(
    LosesAContact,
    "A contact that is lost.",
    "mesh-overlay-loses-a-contact",
    "of the registered contacts of edges of the first mesh the last one is lost",
    WRONG: Wrong = Wrong::LosesAContact
);
fault!(
    TakesVerticesForClear,
    "Edges and triangles around a vertex that pass through each other, set aside.",
    "mesh-overlay-clear",
    "what both meshes have is set aside wherever it is",
    WRONG: Wrong = Wrong::TakesVerticesForClear
);
fault!(
    TakesTrianglesForApart,
    "Edges and triangles that touch in a mesh, set aside.",
    "mesh-overlay-apart",
    "what both meshes have is set aside although it touches itself",
    WRONG: Wrong = Wrong::TakesTrianglesForApart
);
