//! What backends do with vertices that are constructed while they run, and why
//! they refuse one.
//!
//! Overlays and cascades of operations find new vertices as they go. A backend
//! that rounds them answers about other points from then on; one that keeps
//! them does not. Which of the two it is belongs to its promise.

use std::borrow::Cow;

use crate::{Construction, ConstructionError, Declined};

/// What a backend does with vertices that its sessions are asked to
/// [construct](crate::Predicates::construct).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Constructs {
    /// Answers are about the very point, also where constructed vertices
    /// define it. Definitions that are of no single point are refused.
    Keeps,
    /// The same for vertices that input vertices define; others are refused.
    KeepsFirst,
    /// The point is computed in floating point, from coordinates that may be
    /// rounded already, and is a vertex like the others from then on. Where a
    /// definition is of no point, its coordinates are infinite or NaN.
    Rounds,
    /// None is constructed.
    Declines,
}

/// Why a session constructed nothing. The session is as it was.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refused {
    /// The session constructs no vertices, whatever defines them.
    Session {
        /// Why, in one line.
        reason: String,
    },
    /// One of the definitions: the first that the session does not take.
    Definition {
        /// Its place among those asked for.
        index: usize,
        /// The definition, as asked for.
        definition: Construction,
        /// Why the session does not take it.
        reason: DefinitionError,
    },
}

impl Refused {
    /// The session constructs no vertices.
    #[must_use]
    pub fn session(reason: impl Into<String>) -> Refused {
        Refused::Session { reason: reason.into() }
    }

    /// The place of the definition that was refused; none where all are.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match self {
            Refused::Session { .. } => None,
            Refused::Definition { index, .. } => Some(*index),
        }
    }
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Refused::Session { reason } => write!(f, "no vertex is constructed: {reason}"),
            Refused::Definition { index, definition, reason } => {
                write!(f, "definition {index}, {definition}, is refused: {reason}")
            }
        }
    }
}

impl std::error::Error for Refused {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Refused::Session { .. } => None,
            Refused::Definition { reason, .. } => Some(reason),
        }
    }
}

/// Why a session does not take one definition.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DefinitionError {
    /// The scene does not take it.
    Scene(ConstructionError),
    /// It defines no single point.
    NoPoint(NoPoint),
    /// Constructed vertices define it, and the backend constructs only what input vertices define
    /// ([`Constructs::KeepsFirst`]).
    OfConstructed {
        /// Why, in one line.
        reason: &'static str,
    },
    /// The session has a condition of its own.
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

impl std::fmt::Display for DefinitionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            DefinitionError::Scene(error) => error.fmt(f),
            DefinitionError::NoPoint(error) => error.fmt(f),
            DefinitionError::OfConstructed { reason } => f.write_str(reason),
            DefinitionError::Other(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for DefinitionError {}

/// Why the lines and planes of a construction do not meet in a single point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum NoPoint {
    /// The two ends of a segment in the plane coincide.
    SegmentEnds,
    /// The two vertices of a line in space coincide.
    LineEnds,
    /// The three vertices of a plane are collinear.
    CollinearPlane,
    /// Two lines are parallel, or the same.
    ParallelLines,
    /// The line is parallel to the plane, or in it.
    ParallelToPlane,
    /// Three planes share no point, or more than one.
    Planes,
    /// The backend does not say which of these it is.
    Unspecified,
}

impl std::fmt::Display for NoPoint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            NoPoint::SegmentEnds => "the ends of a segment coincide",
            NoPoint::LineEnds => "the two vertices of the line coincide",
            NoPoint::CollinearPlane => "the three vertices of a plane are collinear",
            NoPoint::ParallelLines => "the lines are parallel",
            NoPoint::ParallelToPlane => "the line is parallel to the plane",
            NoPoint::Planes => "the planes share no point, or more than one",
            NoPoint::Unspecified => "its lines and planes meet in no single point",
        })
    }
}

impl std::error::Error for NoPoint {}

/// For algorithms that cannot do without: the backend declines the scene.
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
