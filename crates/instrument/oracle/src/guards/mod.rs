//! Guards: checks of the tool itself, for faults that no backend's answer shows.
//!
//! Truth, classes and expectations judge a backend, with points from a reader. If one of these is wrong, judging shows
//! nothing, or nonsense. A guard compares a part of the tool with independently known facts: handwritten tables, or
//! files written by a few lines that share nothing with the readers. Each part is a trait that stands for the real
//! functions. A fault replaces one of them, and the guards listed for the fault must fail.
//!
//! * [`judging`]: truth, classes, statuses and ids.
//! * [`readers`]: coordinates, points, meshes, rings, lines and content ids.

pub mod judging;
pub mod readers;

use crate::faults::Area;

/// A check of a part of the tool.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Guard {
    /// The guarded part: [`Area::Oracle`] or [`Area::Readers`].
    pub area: Area,
    /// The name of the guard.
    pub name: &'static str,
    /// A one-line description of the known facts.
    pub means: &'static str,
}

/// A fault in a part of the tool.
pub struct Guarded {
    /// The part with the fault.
    pub area: Area,
    /// The name of the fault, after the name of its part and a colon.
    pub name: &'static str,
    /// A one-line description of the fault.
    pub what: &'static str,
    /// The names of the guards that must detect the fault.
    pub caught_by: &'static [&'static str],
    run: fn() -> Vec<Held>,
}

/// The result of a guard.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Held {
    /// The guard's name.
    pub guard: &'static str,
    /// The number of facts checked, up to the first that does not hold.
    pub facts: u64,
    /// The first fact that does not hold.
    pub broken: Option<String>,
}

impl Guarded {
    /// The results of the part's guards with this fault.
    #[must_use]
    pub fn run(&self) -> Vec<Held> {
        (self.run)()
    }
}

/// All guards.
pub fn guards() -> impl Iterator<Item = Guard> {
    judging::GUARDS.iter().chain(readers::GUARDS).copied()
}

/// All faults in parts of the tool.
pub fn faults() -> impl Iterator<Item = &'static Guarded> {
    judging::FAULTS.iter().chain(readers::FAULTS)
}

/// The results of a part's guards without a fault.
#[must_use]
pub fn honest(area: Area) -> Vec<Held> {
    match area {
        Area::Oracle => judging::held(&judging::Real),
        Area::Readers => readers::held(&readers::Real),
        _ => Vec::new(),
    }
}

/// The facts that a guard checks, one by one.
#[derive(Default)]
struct Facts {
    count: u64,
    broken: Option<String>,
}

impl Facts {
    /// Checks a fact; facts after the first that does not hold are not counted.
    fn hold(&mut self, holds: bool, what: impl FnOnce() -> String) {
        if self.broken.is_none() {
            self.count += 1;
            self.broken = (!holds).then(what);
        }
    }

    fn held(self, guard: &'static str) -> Held {
        Held { guard, facts: self.count, broken: self.broken }
    }
}
