//! The treatment of constructed vertices by a backend, and the reasons to refuse one.
//!
//! Overlays and cascades of operations find new vertices while they run. A backend that rounds them answers about other
//! points from then on; a backend that stores definitions does not. The backend's promise says which of the two
//! applies.

use alloc::borrow::Cow;
use alloc::string::{String, ToString};

use crate::{Construction, ConstructionError, Declined};

/// The treatment of vertices that a session is asked to [construct](crate::Predicates::construct).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Constructs {
    /// Answers are about the exact point, also if constructed vertices define it.
    ///
    /// The session refuses definitions without a unique point.
    Keeps,
    /// The same as `Keeps` for vertices that input vertices define; the session refuses others.
    KeepsFirst,
    /// The session computes the point in floating point, from coordinates that may already be rounded.
    ///
    /// From then on the point is a vertex like the others. If the definition has no point, its coordinates are infinite
    /// or NaN.
    Rounds,
    /// The session constructs no vertices.
    Declines,
}

/// The reason why a session constructed nothing; the session is unchanged.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refused {
    /// The session never constructs vertices.
    Session {
        /// The reason, in one line.
        reason: String,
    },
    /// The session does not take one definition, the first such.
    Definition {
        /// The index of the definition in the call.
        index: usize,
        /// The definition, as the caller wrote it.
        definition: Construction,
        /// The reason why the session does not take it.
        reason: DefinitionError,
    },
}

impl Refused {
    /// A refusal by a session that never constructs vertices.
    #[must_use]
    pub fn session(reason: impl Into<String>) -> Refused {
        Refused::Session { reason: reason.into() }
    }

    /// The index of the refused definition; `None` if the session refuses all.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match self {
            Refused::Session { .. } => None,
            Refused::Definition { index, .. } => Some(*index),
        }
    }
}

impl core::fmt::Display for Refused {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Refused::Session { reason } => write!(f, "no vertex is constructed: {reason}"),
            Refused::Definition { index, definition, reason } => {
                write!(f, "definition {index}, {definition}, is refused: {reason}")
            }
        }
    }
}

impl core::error::Error for Refused {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Refused::Session { .. } => None,
            Refused::Definition { reason, .. } => Some(reason),
        }
    }
}

/// The reason why a session does not take one definition.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DefinitionError {
    /// The scene does not take the definition.
    Scene(ConstructionError),
    /// The definition has no unique point.
    NoPoint(NoPoint),
    /// Constructed vertices define the vertex, and the backend constructs only from input vertices
    /// ([`Constructs::KeepsFirst`]).
    OfConstructed {
        /// The reason, in one line.
        reason: &'static str,
    },
    /// The session has another condition.
    Other(Cow<'static, str>),
}

impl From<ConstructionError> for DefinitionError {
    fn from(error: ConstructionError) -> DefinitionError {
        DefinitionError::Scene(error)
    }
}

impl From<NoPoint> for DefinitionError {
    fn from(error: NoPoint) -> DefinitionError {
        DefinitionError::NoPoint(error)
    }
}

impl core::fmt::Display for DefinitionError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            DefinitionError::Scene(error) => error.fmt(f),
            DefinitionError::NoPoint(error) => error.fmt(f),
            DefinitionError::OfConstructed { reason } => f.write_str(reason),
            DefinitionError::Other(reason) => f.write_str(reason),
        }
    }
}

impl core::error::Error for DefinitionError {}

/// The reason why the lines and planes of a construction do not meet in a unique point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum NoPoint {
    /// The two ends of a segment in the plane coincide.
    SegmentEnds,
    /// The two vertices of a line in space coincide.
    LineEnds,
    /// The three vertices of a plane are collinear.
    CollinearPlane,
    /// Two lines are parallel or identical.
    ParallelLines,
    /// The line is parallel to the plane or lies in it.
    ParallelToPlane,
    /// Three planes share no point or more than one.
    Planes,
    /// The backend does not give the reason.
    Unspecified,
}

impl core::fmt::Display for NoPoint {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            NoPoint::SegmentEnds => "the ends of a segment coincide",
            NoPoint::LineEnds => "the two vertices of the line coincide",
            NoPoint::CollinearPlane => "the three vertices of a plane are collinear",
            NoPoint::ParallelLines => "the lines are parallel",
            NoPoint::ParallelToPlane => "the line is parallel to the plane",
            NoPoint::Planes => "the planes share no point, or more than one",
            NoPoint::Unspecified => "its lines and planes do not meet in a single point",
        })
    }
}

impl core::error::Error for NoPoint {}

/// Declines the scene, for algorithms that need the constructed vertices.
impl From<Refused> for Declined {
    fn from(refused: Refused) -> Declined {
        Declined::scene(refused.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vertex;

    #[test]
    fn refusals_name_the_definition() {
        let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
        let definition = Construction::Ssi([[a, b], [c, d]]);
        let refused = Refused::Definition { index: 7, definition, reason: NoPoint::ParallelLines.into() };
        assert_eq!(refused.to_string(), "definition 7, SSI(0 1, 2 3), is refused: the lines are parallel");
        assert_eq!((refused.index(), Refused::session("no").index()), (Some(7), None));
        assert_eq!(Declined::from(refused.clone()), Declined::scene(refused.to_string()));
    }
}
