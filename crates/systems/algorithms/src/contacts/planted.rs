//! Faults planted in contacts. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// The last registration of each level but the last is dropped.
    const LOSES_SUB_PAIRS: bool = false;
    /// No pair has ever ended.
    const FORGETS_SUB_PAIRS: bool = false;
    /// Vertices are never asked about with vertices.
    const SKIPS_VERTICES: bool = false;
}

impl Planted for Honest {}

/// Contacts that lose a registration that more than ends its own pair: neither
/// reported nor remembered.
#[derive(Clone, Copy, Debug)]
pub struct LostSubPair;

impl Fault for LostSubPair {
    const NAME: &'static str = "lost-sub-pair";
    const WHAT: &'static str = "the last pair that a level below full dimension registers is lost";
}

impl Planted for LostSubPair {
    const LOSES_SUB_PAIRS: bool = true;
}

/// Contacts that ask about pairs that have ended.
///
/// With exact signs the questions themselves say no then, and nothing is
/// wrong but the counts; with a band, pairs are registered again.
#[derive(Clone, Copy, Debug)]
pub struct ForgottenSubPairs;

impl Fault for ForgottenSubPairs {
    const NAME: &'static str = "forgotten-sub-pairs";
    const WHAT: &'static str = "pairs of which a sub-pair is registered are asked about all the same";
}

impl Planted for ForgottenSubPairs {
    const FORGETS_SUB_PAIRS: bool = true;
}

/// Contacts that begin with edges and vertices: vertices are never compared.
#[derive(Clone, Copy, Debug)]
pub struct SkippedVertices;

impl Fault for SkippedVertices {
    const NAME: &'static str = "skipped-vertices";
    const WHAT: &'static str = "the hierarchy begins with edges and vertices, no two vertices are registered";
}

impl Planted for SkippedVertices {
    const SKIPS_VERTICES: bool = true;
}
