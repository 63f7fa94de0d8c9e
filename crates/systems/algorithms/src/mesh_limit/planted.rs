//! Faults planted in the limit of a result.

use crate::planted::{Fault, Honest, fault};

/// What a limit gets wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wrong {
    /// Nothing.
    Nothing,
    /// Vertices at one place stay apart.
    KeepsVertices,
    /// What faces each other in one plane stays.
    KeepsSheets,
    /// Vertices on edges stay there.
    KeepsJoints,
}

/// A fault of a limit.
pub trait Planted: Fault {
    /// What goes wrong.
    const WRONG: Wrong;
}

impl Planted for Honest {
    const WRONG: Wrong = Wrong::Nothing;
}

fault!(
    KeepsVertices,
    "Vertices at one place that stay apart.",
    "mesh-limit-vertices",
    "vertices at one place stay apart",
    WRONG: Wrong = Wrong::KeepsVertices
);

fault!(
    KeepsSheets,
    "Sheets that stay.",
    "mesh-limit-sheets",
    "what faces each other in one plane stays",
    WRONG: Wrong = Wrong::KeepsSheets
);

fault!(
    KeepsJoints,
    "Vertices on edges that stay there.",
    "mesh-limit-joints",
    "edges are not divided at vertices on them",
    WRONG: Wrong = Wrong::KeepsJoints
);
