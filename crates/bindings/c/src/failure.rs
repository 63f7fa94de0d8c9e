//! Result codes, and the reason and place of a failure.

// Names are those of the header, so that a search finds both.
#![allow(non_camel_case_types)]

use predicament_predicates::{ConstructionError, DefinitionError, Refused};

/// The result of a call. Every function that returns one writes its outputs only if it returns PREDICAMENT_OK, unless
/// its comment says otherwise.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum predicament_result {
    /// The call has done what it says.
    PREDICAMENT_OK = 0,
    /// A pointer is NULL that must not be NULL.
    PREDICAMENT_NULL = 1,
    /// A pointer to indices, definitions or vertices is not a multiple of four.
    PREDICAMENT_MISALIGNED = 2,
    /// A coordinate is NaN or infinite.
    PREDICAMENT_NOT_FINITE = 3,
    /// An index is not below the number of points, or names a constructed vertex that does not exist.
    PREDICAMENT_INDEX = 4,
    /// An axis, a plane, a dimension, a backend or a stride is not one that the function takes.
    PREDICAMENT_ARGUMENT = 5,
    /// A size is larger than the address space, or a scene has more than 2^31 points or constructed vertices.
    PREDICAMENT_TOO_MANY = 6,
    /// The scene does not answer this predicate or take this vertex: its dimension is another one, or its backend
    /// refuses.
    PREDICAMENT_UNSUPPORTED = 7,
    /// A definition names a vertex twice in one line or plane.
    PREDICAMENT_REPEATED = 8,
    /// The lines and planes of a definition do not meet in a single point.
    PREDICAMENT_NO_POINT = 9,
    /// An internal error. The library has a defect; please report it. A scene that was being changed answers nothing
    /// any more and can only be freed.
    PREDICAMENT_INTERNAL = 10,
    /// The 64-bit integers along one axis of a scene span more than 2^54 times the largest power of two that divides
    /// all their differences.
    PREDICAMENT_RANGE = 11,
}

impl predicament_result {
    /// All results, in the order of their numbers.
    pub(crate) const ALL: [predicament_result; 12] = {
        use predicament_result::*;
        [
            PREDICAMENT_OK,
            PREDICAMENT_NULL,
            PREDICAMENT_MISALIGNED,
            PREDICAMENT_NOT_FINITE,
            PREDICAMENT_INDEX,
            PREDICAMENT_ARGUMENT,
            PREDICAMENT_TOO_MANY,
            PREDICAMENT_UNSUPPORTED,
            PREDICAMENT_REPEATED,
            PREDICAMENT_NO_POINT,
            PREDICAMENT_INTERNAL,
            PREDICAMENT_RANGE,
        ]
    };

    /// The meaning of the result, in a few words.
    pub(crate) const fn text(self) -> &'static std::ffi::CStr {
        use predicament_result::*;
        match self {
            PREDICAMENT_OK => c"ok",
            PREDICAMENT_NULL => c"a pointer is NULL",
            PREDICAMENT_MISALIGNED => c"a pointer to 32-bit numbers is not aligned",
            PREDICAMENT_NOT_FINITE => c"a coordinate is NaN or infinite",
            PREDICAMENT_INDEX => c"an index is out of range",
            PREDICAMENT_ARGUMENT => c"an axis, plane, dimension, backend or stride is not valid",
            PREDICAMENT_TOO_MANY => c"there are too many points, queries or definitions",
            PREDICAMENT_UNSUPPORTED => c"the scene does not answer this predicate or take this vertex",
            PREDICAMENT_REPEATED => c"a definition names a vertex twice in one line or plane",
            PREDICAMENT_NO_POINT => c"the lines and planes of a definition do not meet in a single point",
            PREDICAMENT_INTERNAL => c"internal error",
            PREDICAMENT_RANGE => c"integers along one axis span too many bits",
        }
    }
}

/// A result that is not PREDICAMENT_OK, and the index of the bad item; 0 if the items are not at fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Failure {
    pub code: predicament_result,
    pub at: usize,
}

impl Failure {
    /// A failure of the item with this index.
    pub const fn at(code: predicament_result, at: usize) -> Failure {
        Failure { code, at }
    }
}

/// A failure of the whole call.
impl From<predicament_result> for Failure {
    fn from(code: predicament_result) -> Failure {
        Failure { code, at: 0 }
    }
}

impl From<Refused> for Failure {
    fn from(refused: Refused) -> Failure {
        match refused {
            Refused::Session { .. } => predicament_result::PREDICAMENT_UNSUPPORTED.into(),
            Refused::Definition { index, reason, .. } => Failure::at(code_of(&reason), index),
        }
    }
}

fn code_of(reason: &DefinitionError) -> predicament_result {
    use predicament_result::*;
    match reason {
        DefinitionError::Scene(ConstructionError::Missing { .. }) => PREDICAMENT_INDEX,
        DefinitionError::Scene(ConstructionError::Repeated { .. }) => PREDICAMENT_REPEATED,
        DefinitionError::Scene(ConstructionError::TooMany) => PREDICAMENT_TOO_MANY,
        DefinitionError::NoPoint(_) => PREDICAMENT_NO_POINT,
        _ => PREDICAMENT_UNSUPPORTED,
    }
}
