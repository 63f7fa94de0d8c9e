//! The ways in which a question is asked again.

use std::fmt;

/// A way to ask the same again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Way {
    /// In the same process, with a new session.
    Again,
    /// In a new process.
    Process,
    /// On a number of threads.
    Threads(usize),
    /// With the queries in another order.
    Order,
    /// With the vertices numbered differently; for backends whose answers depend on places only.
    Ids,
}

impl Way {
    /// All ways, in the order of tables.
    pub const ALL: [Way; 7] =
        [Way::Again, Way::Process, Way::Threads(1), Way::Threads(2), Way::Threads(8), Way::Order, Way::Ids];
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Way::Again => f.write_str("again"),
            Way::Process => f.write_str("new process"),
            Way::Threads(1) => f.write_str("1 thread"),
            Way::Threads(n) => write!(f, "{n} threads"),
            Way::Order => f.write_str("other order"),
            Way::Ids => f.write_str("other ids"),
        }
    }
}
