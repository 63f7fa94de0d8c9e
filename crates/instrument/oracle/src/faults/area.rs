//! The parts of the tool in which faults are planted.

/// A part of the tool.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Area {
    /// Numbers: integers, expansions, rounding.
    Arithmetic,
    /// Bounds of floating-point filters, and their conditions.
    Filters,
    /// Simulation of Simplicity: terms, parities, identities.
    Sos,
    /// Bands, and the contacts that use distances.
    Tolerance,
    /// Contacts that a backend registers, and right answers that are corrupted before they are judged.
    Answers,
    /// The judging of answers: a disabled check.
    Checks,
    /// Truth, classes, expectations, ids.
    Oracle,
    /// The readers of files.
    Readers,
}

impl Area {
    /// All areas.
    pub const ALL: [Area; 8] = [
        Area::Arithmetic,
        Area::Filters,
        Area::Sos,
        Area::Tolerance,
        Area::Answers,
        Area::Checks,
        Area::Oracle,
        Area::Readers,
    ];

    /// The area's name in tables and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Area::Arithmetic => "arithmetic",
            Area::Filters => "filters",
            Area::Sos => "sos",
            Area::Tolerance => "tolerance",
            Area::Answers => "answers",
            Area::Checks => "checks",
            Area::Oracle => "oracle",
            Area::Readers => "readers",
        }
    }
}
