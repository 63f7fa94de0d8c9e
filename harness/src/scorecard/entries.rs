//! All entries of `selftest`: honest backends, and faults in backends, in answers and in parts of the tool.

use std::collections::{BTreeMap, BTreeSet};

use predicament_oracle::faults::{Area, Fault};
use predicament_oracle::guards::{self, Guarded};
use predicament_tasks::{AnyTask, Contestant, Outcome};

use super::declared::Declarations;
use crate::shrinking::Measure;
use crate::tool::Tool;

/// The honest backends, which must have only expected findings.
const CLEAN: [&str; 5] = ["exact", "sos", "sos:edelsbrunner-mucke", TWO_MESHES, "tolerance"];

/// The honest backend for scenes with two meshes.
pub const TWO_MESHES: &str = "sos:per-mesh";

/// The kind of an entry.
#[derive(Clone, Copy)]
pub enum Kind {
    /// A backend without a fault.
    Honest,
    /// A fault in a backend.
    Backend(Fault),
    /// A fault in right answers of a task, and of the tasks that share these answers.
    Answer,
    /// A part of the tool without a fault.
    HonestPart(Area),
    /// A fault in a part of the tool.
    Part(&'static Guarded),
}

/// An entry: the planted fault, if any, and what was found.
pub struct Entry {
    pub name: String,
    pub what: &'static str,
    pub area: Option<Area>,
    pub kind: Kind,
    /// The indices of the declared checks that have to find the fault.
    pub wants: Vec<usize>,
    pub record: Record,
}

/// The findings of an entry.
#[derive(Clone, Default, Debug)]
pub struct Record {
    /// The first find of each check, by the check's index.
    pub found: BTreeMap<usize, Find>,
    /// Findings that no task declares, in words.
    pub undeclared: BTreeSet<String>,
    /// The number of scenes, or parts of the tool, that the entry was run on.
    pub scenes: u64,
    /// The number of queries, or facts, in them.
    pub queries: u64,
    /// The size of the smallest scene that shows the fault to the first of its checks.
    pub shrunk: Option<Measure>,
}

/// The work until a check found something.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Find {
    pub scenes: u64,
    pub queries: u64,
}

impl Entry {
    fn new(name: String, what: &'static str, area: Option<Area>, kind: Kind, wants: Vec<usize>) -> Entry {
        Entry { name, what, area, kind, wants, record: Record::default() }
    }

    pub fn is_fault(&self) -> bool {
        !matches!(self.kind, Kind::Honest | Kind::HonestPart(_))
    }

    /// True if the entry is a backend, with or without a fault.
    pub fn is_backend(&self) -> bool {
        matches!(self.kind, Kind::Honest | Kind::Backend(_))
    }

    pub fn missed(&self) -> impl Iterator<Item = usize> {
        self.wants.iter().copied().filter(|check| !self.record.found.contains_key(check))
    }

    /// True if the entry is a fault that is run on the next scene, because not all its checks have found it.
    pub fn is_open(&self) -> bool {
        self.is_fault() && (self.record.found.is_empty() || self.missed().next().is_some())
    }

    /// True if the entry is a faulty backend that is run on the next scene of this task.
    pub fn is_open_in(&self, task: &str) -> bool {
        matches!(self.kind, Kind::Backend(fault) if fault.shows_in(task)) && self.is_open()
    }

    /// The work until all checks that have to find the fault had found it.
    pub fn until_caught(&self) -> Find {
        let finds = self.wants.iter().filter_map(|check| self.record.found.get(check));
        let most = finds.max_by_key(|find| find.scenes).copied();
        most.unwrap_or(Find { scenes: self.record.scenes, queries: self.record.queries })
    }

    /// Records what checks have found in the last scene or part.
    pub fn note(&mut self, checks: impl IntoIterator<Item = usize>) {
        let Record { scenes, queries, .. } = self.record;
        for check in checks {
            self.record.found.entry(check).or_insert(Find { scenes, queries });
        }
    }
}

/// The name of an entry for a fault in an answer.
pub fn answer(fault: &str) -> String {
    format!("answer:{fault}")
}

/// The checks of all findings except refusals, and the undeclared findings in words.
pub fn caught(checks: &Declarations, task: &str, outcome: &Outcome) -> (BTreeSet<usize>, BTreeSet<String>) {
    let (mut found, mut undeclared) = (BTreeSet::new(), BTreeSet::new());
    for finding in outcome.findings.iter().filter(|finding| finding.class != predicament_tasks::Class::Declined) {
        match checks.find(task, finding.class, &finding.check) {
            Some(check) => {
                found.insert(check);
            }
            None => {
                undeclared.insert(format!("{task}: {} ({})", finding.class.name(), finding.check));
            }
        }
    }
    (found, undeclared)
}

/// The entries: honest backends, faulty backends, spoiled answers and parts of the tool, in this order.
///
/// # Errors
/// One line, if a fault names a check that is not declared.
pub fn entries(tool: &Tool, checks: &Declarations) -> Result<Vec<Entry>, String> {
    let nothing = "nothing is wrong";
    let honest = CLEAN.iter().map(|name| Entry::new((*name).to_owned(), nothing, None, Kind::Honest, Vec::new()));
    let mut entries: Vec<Entry> = honest.collect();
    for fault in Fault::planted() {
        let wants = fault.caught_by().iter().map(|&catch| checks.named(catch, fault.caught_in(catch)));
        let name = format!("fault:{}", fault.name());
        let wants = wants.collect::<Result<_, _>>().map_err(|why| format!("{name}: {why}"))?;
        entries.push(Entry::new(name, fault.what(), Some(fault.area()), Kind::Backend(fault), wants));
    }
    for &task in tool.tasks() {
        for spoiled in task.spoiled_answers() {
            let name = answer(spoiled.name());
            // Tasks of one family share their answers, and so the faults in them.
            if entries.iter().any(|entry| entry.name == name) {
                continue;
            }
            // A check has to be declared by only one of these tasks.
            let has_it =
                |task: &&&dyn AnyTask| task.spoiled_answers().iter().any(|other| other.name() == spoiled.name());
            let tasks: Vec<&str> = tool.tasks().iter().filter(has_it).map(|task| task.name()).collect();
            let wants = spoiled.caught_by().iter().map(|&catch| checks.named_by(&tasks, catch));
            let wants = wants.collect::<Result<_, _>>().map_err(|why| format!("{name}: {why}"))?;
            entries.push(Entry::new(name, spoiled.what(), Some(Area::Answers), Kind::Answer, wants));
        }
    }
    for area in [Area::Oracle, Area::Readers] {
        let name = area.name();
        entries.push(Entry::new(name.to_owned(), nothing, Some(area), Kind::HonestPart(area), Vec::new()));
        for fault in guards::faults().filter(|fault| fault.area == area) {
            let wants = fault.caught_by.iter().map(|guard| {
                checks.guard(guard).ok_or_else(|| format!("{name}:{}: no guard is called `{guard}`", fault.name))
            });
            let of = format!("{name}:{}", fault.name);
            entries.push(Entry::new(of, fault.what, Some(area), Kind::Part(fault), wants.collect::<Result<_, _>>()?));
        }
    }
    Ok(entries)
}

/// The entries with these names, all honest backends, and the honest parts of the tool for the named faults.
///
/// # Errors
/// The first name that does not exist.
pub fn only(mut entries: Vec<Entry>, names: &[String]) -> Result<Vec<Entry>, String> {
    if let Some(unknown) = names.iter().find(|name| entries.iter().all(|entry| entry.name != **name)) {
        return Err(format!(
            "no fault is called `{unknown}`; `{} setup selftest --list` names them",
            crate::out::program()
        ));
    }
    let parts: Vec<Area> = entries
        .iter()
        .filter(|entry| matches!(entry.kind, Kind::Part(_)) && names.contains(&entry.name))
        .filter_map(|entry| entry.area)
        .collect();
    entries.retain(|entry| match entry.kind {
        Kind::Honest => true,
        Kind::HonestPart(area) => parts.contains(&area) || names.contains(&entry.name),
        Kind::Backend(_) | Kind::Answer | Kind::Part(_) => names.contains(&entry.name),
    });
    Ok(entries)
}

/// The honest backend with this name.
pub fn honest<'c>(contestants: &'c [Box<dyn Contestant>], name: &str) -> &'c dyn Contestant {
    let honest = contestants.iter().find(|contestant| contestant.name() == name);
    honest.unwrap_or_else(|| panic!("no honest backend is called {name}")).as_ref()
}
