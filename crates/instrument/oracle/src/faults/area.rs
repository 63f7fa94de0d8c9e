//! The parts of the tool in which faults are planted.

/// A part of the tool.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Area {
    /// Numbers: integers, expansions, rounding.
    Arithmetic,
    /// Bounds of floating-point filters, and when they hold.
    Filters,
    /// Simulation of Simplicity: terms, parities, identities.
    Sos,
    /// Bands and the contacts that go by distances.
    Tolerance,
    /// Contacts that a backend registers, and right answers that are spoiled before they are judged.
    Answers,
    /// What judges answers: a check that is off.
    Checks,
    /// Truth, classes, expectations, ids.
    Oracle,
    /// What reads files.
    Readers,
}

impl Area {
    /// All of them.
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

    /// A word for tables and files.
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
