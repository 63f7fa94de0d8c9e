//! The Boolean operations: which there are, and what each holds.

/// A Boolean operation on two polygons.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Operation {
    /// What is inside of the first, of the second or of both.
    Union,
    /// What is inside of both.
    Intersection,
    /// What is inside of the first and not of the second.
    Difference,
    /// What is inside of one and not of both.
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

    /// Whether a point is in the result, by whether it is in each operand.
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
