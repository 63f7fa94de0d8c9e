//! What a backend promises about its answers, and how it declines.

use crate::PredicateKind;

/// What a backend means when it answers zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ZeroMeaning {
    /// Zero is zero: the answer is the sign of the real determinant.
    Exact,
    /// Ties are broken: zero is never answered for distinct vertices.
    Never,
    /// Zero is a band: what lies within a tolerance is registered as degenerate.
    Band,
}

/// A backend's promise.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Contract {
    /// What zero means.
    pub zero: ZeroMeaning,
    /// Whether the promise is proved for every finite input. Controls declare the
    /// same contract without guaranteeing it; they say `false`.
    pub proved: bool,
}

/// The tolerance band of one predicate in one scene, in units of its determinant.
///
/// With d the exact determinant: |d| ≤ `lower` is registered as zero, |d| >
/// `upper` never is, and in between both answers are legal (eq. 1 of Wang,
/// Jiang, Schroeder and Teran).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Band {
    /// T₋: everything up to here is registered.
    pub lower: f64,
    /// T: what the floating-point test compares with.
    pub width: f64,
    /// T₊: nothing beyond here is registered.
    pub upper: f64,
}

/// Why a backend declines a scene or a predicate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Declined {
    /// The predicate that is declined; none where the whole scene is.
    pub predicate: Option<PredicateKind>,
    /// Why, in one line.
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

impl std::fmt::Display for Declined {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.predicate {
            Some(kind) => write!(f, "{kind} declined: {}", self.reason),
            None => write!(f, "scene declined: {}", self.reason),
        }
    }
}

impl std::error::Error for Declined {}
