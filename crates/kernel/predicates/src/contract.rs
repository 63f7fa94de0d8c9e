//! A backend's promise about its answers, and the way it declines.

use crate::PredicateKind;
use alloc::string::String;

/// The meaning of an answer of zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ZeroMeaning {
    /// Zero means zero: the answer is the sign of the real determinant.
    Exact,
    /// Ties are broken: the backend never answers zero for distinct vertices.
    Never,
    /// Zero is a band: the backend registers values within a tolerance as degenerate.
    Band,
}

/// A backend's promise about one predicate.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Contract {
    /// The meaning of zero.
    pub zero: ZeroMeaning,
    /// True if the promise is proved for every finite input.
    ///
    /// Controls declare the same contract without guaranteeing it; they say `false`.
    pub proved: bool,
}

/// The tolerance band of one predicate in one scene, in units of its determinant.
///
/// Let d be the exact determinant. |d| ≤ `lower` is registered as zero, and |d| > `upper` is never registered. In
/// between, both answers are legal (eq. 1 of Wang, Jiang, Schroeder and Teran).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Band {
    /// T₋: every |d| up to this value is registered.
    pub lower: f64,
    /// T: the threshold of the floating-point test.
    pub width: f64,
    /// T₊: no |d| beyond this value is registered.
    pub upper: f64,
}

/// The reason why a backend declines a scene or a predicate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Declined {
    /// The declined predicate; `None` if the backend declines the whole scene.
    pub predicate: Option<PredicateKind>,
    /// The reason, in one line.
    pub reason: String,
}

impl Declined {
    /// Declines the whole scene.
    #[must_use]
    pub fn scene(reason: impl Into<String>) -> Declined {
        Declined { predicate: None, reason: reason.into() }
    }

    /// Declines one predicate.
    #[must_use]
    pub fn predicate(kind: PredicateKind, reason: impl Into<String>) -> Declined {
        Declined { predicate: Some(kind), reason: reason.into() }
    }
}

impl core::fmt::Display for Declined {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.predicate {
            Some(kind) => write!(f, "{kind} declined: {}", self.reason),
            None => write!(f, "scene declined: {}", self.reason),
        }
    }
}

impl core::error::Error for Declined {}
