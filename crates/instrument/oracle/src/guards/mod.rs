//! Guards: checks of the tool itself, for faults that no answer of a backend shows.
//!
//! A backend is judged by truth, classes and expectations, and is asked about points that a reader has read. If one of
//! these is wrong, judging shows nothing, or nonsense. A guard holds a part of the tool to facts that are known
//! without it: tables written out by hand, files written by a few lines that share nothing with the readers. Each
//! part is a trait that stands for the real functions; a fault replaces one of them, and the guards that are named
//! for it have to fail.
//!
//! * [`judging`]: truth, classes, statuses and ids.
//! * [`readers`]: coordinates, points, meshes, rings, lines and content ids.

pub mod judging;
pub mod readers;

use crate::faults::Area;

/// A check of a part of the tool.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Guard {
    /// The part: [`Area::Oracle`] or [`Area::Readers`].
    pub area: Area,
    /// Its name.
    pub name: &'static str,
    /// What it knows, in one line.
    pub means: &'static str,
}

/// A fault in a part of the tool.
pub struct Guarded {
    /// The part.
    pub area: Area,
    /// The name of the fault, after that of its part and a colon.
    pub name: &'static str,
    /// What is wrong, in one line.
    pub what: &'static str,
    /// The guards that have to find it, by name.
    pub caught_by: &'static [&'static str],
    run: fn() -> Vec<Held>,
}

/// What a guard found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Held {
    /// The guard's name.
    pub guard: &'static str,
    /// How many facts it looked at: up to the first that does not hold, if there is one.
    pub facts: u64,
    /// The first fact that does not hold.
    pub broken: Option<String>,
}

impl Guarded {
    /// What each guard of the part finds where this is wrong.
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

/// What the guards of a part find where nothing is wrong.
#[must_use]
pub fn honest(area: Area) -> Vec<Held> {
    match area {
        Area::Oracle => judging::held(&judging::Real),
        Area::Readers => readers::held(&readers::Real),
        _ => Vec::new(),
    }
}

/// Facts that a guard looks at, one by one.
#[derive(Default)]
struct Facts {
    count: u64,
    broken: Option<String>,
}

impl Facts {
    /// Looks at a fact; those after the first that does not hold are not counted.
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
