//! The Boolean operations and their definitions.

/// A Boolean operation on two polygons.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Operation {
    /// The points inside the first polygon, the second or both.
    Union,
    /// The points inside both.
    Intersection,
    /// The points inside the first but not inside the second.
    Difference,
    /// The points inside exactly one.
    SymmetricDifference,
}

impl Operation {
    /// All four operations.
    pub const ALL: [Operation; 4] =
        [Operation::Union, Operation::Intersection, Operation::Difference, Operation::SymmetricDifference];

    /// The name in suites, files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Operation::Union => "union",
            Operation::Intersection => "intersection",
            Operation::Difference => "difference",
            Operation::SymmetricDifference => "symmetric-difference",
        }
    }

    /// True if a point is in the result; the argument says if it is in each operand.
    #[must_use]
    pub const fn holds(self, [a, b]: [bool; 2]) -> bool {
        match self {
            Operation::Union => a || b,
            Operation::Intersection => a && b,
            Operation::Difference => a && !b,
            Operation::SymmetricDifference => a != b,
        }
    }
}
