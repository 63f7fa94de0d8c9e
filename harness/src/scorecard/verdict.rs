//! Verdicts on entries, with all checks on or with some switched off.
//!
//! A verdict is computed from the records. Switching a check off means ignoring its findings, so no scene is run again.

use std::collections::BTreeSet;

use super::declared::{Declarations, not_needed};
use super::entries::Entry;

/// The verdict on an entry.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Verdict {
    Clean,
    NotClean,
    Caught,
    NotCaught,
    /// Found, but not by these checks, which have to find it.
    Missed(Vec<usize>),
}

impl Verdict {
    pub fn name(&self) -> &'static str {
        match self {
            Verdict::Clean => "clean",
            Verdict::NotClean => "NOT CLEAN",
            Verdict::Caught => "caught",
            Verdict::NotCaught => "NOT CAUGHT",
            Verdict::Missed(_) => "MISSED BY",
        }
    }

    pub fn is_good(&self) -> bool {
        matches!(self, Verdict::Clean | Verdict::Caught)
    }
}

/// The verdict on an entry, without the checks that are off. If not all scenes were run, any finding catches a fault.
pub fn verdict(entry: &Entry, off: &BTreeSet<usize>, is_whole: bool) -> Verdict {
    let mut found = entry.record.found.keys().filter(|check| !off.contains(check));
    let is_found = found.next().is_some();
    match (entry.is_fault(), is_found) {
        (false, false) => Verdict::Clean,
        (false, true) => Verdict::NotClean,
        (true, false) => Verdict::NotCaught,
        (true, true) => {
            let is_missed = |check: &usize| off.contains(check) || !entry.record.found.contains_key(check);
            let missed: Vec<usize> = entry.wants.iter().copied().filter(is_missed).collect();
            if missed.is_empty() || !is_whole { Verdict::Caught } else { Verdict::Missed(missed) }
        }
    }
}

/// The faults that are caught with all checks on, but not without this check.
pub fn needed_by(entries: &[Entry], check: usize) -> Vec<&Entry> {
    let (none, one) = (BTreeSet::new(), BTreeSet::from([check]));
    let needs = |entry: &&Entry| {
        entry.is_fault() && verdict(entry, &none, true).is_good() && !verdict(entry, &one, true).is_good()
    };
    entries.iter().filter(needs).collect()
}

/// The checks that no fault needs, although a fault has to need them.
pub fn idle(checks: &Declarations, entries: &[Entry]) -> Vec<usize> {
    let is_idle = |&at: &usize| not_needed(&checks.0[at]).is_none() && needed_by(entries, at).is_empty();
    (0..checks.0.len()).filter(is_idle).collect()
}

#[cfg(test)]
mod tests {
    use super::super::entries::{entries, only};
    use super::*;
    use crate::tool::Tool;

    /// All faults, as if each check that has to find them had; `selftest` shows that they do.
    fn recorded() -> (Declarations, Vec<Entry>) {
        let tool = Tool::new((), &predicament_bundle::Systems, crate::tool::Guests::default());
        let checks = Declarations::of(&tool);
        let mut all = entries(&tool, &checks).unwrap();
        for entry in &mut all {
            entry.record.scenes = 1;
            entry.note(entry.wants.clone());
        }
        (checks, all)
    }

    #[test]
    fn every_check_is_needed_by_some_fault_or_it_is_said_why_not() {
        let (checks, entries) = recorded();
        let none = BTreeSet::new();
        assert!(entries.iter().all(|entry| verdict(entry, &none, true).is_good()));
        for (at, check) in checks.0.iter().enumerate() {
            let needed = needed_by(&entries, at);
            match not_needed(check) {
                None => assert!(!needed.is_empty(), "no fault needs {check} of {}", check.place()),
                Some(why) => assert!(needed.is_empty(), "{check} needs no fault ({why}), and {} does", needed[0].name),
            }
        }
        assert!(idle(&checks, &entries).is_empty());
    }

    #[test]
    fn a_check_that_is_switched_off_turns_the_card_red() {
        let (checks, entries) = recorded();
        for at in (0..checks.0.len()).filter(|&at| not_needed(&checks.0[at]).is_none()) {
            let off = BTreeSet::from([at]);
            let red = entries.iter().filter(|entry| !verdict(entry, &off, true).is_good());
            assert!(red.count() > 0, "{} of {} is off, and nothing is missed", checks.0[at], checks.0[at].place());
        }
    }

    #[test]
    fn every_area_has_three_faults_and_all_have_forty() {
        let (_, entries) = recorded();
        let faults: Vec<&Entry> = entries.iter().filter(|entry| entry.is_fault()).collect();
        assert!(faults.len() >= 40 && faults.iter().all(|entry| !entry.wants.is_empty()));
        for area in predicament_oracle::faults::Area::ALL {
            // Switching off a check is a fault of its area.
            let count = faults.iter().filter(|entry| entry.area == Some(area)).count();
            assert!(count >= 3 || area == predicament_oracle::faults::Area::Checks, "{}: {count}", area.name());
        }
    }

    #[test]
    fn a_fault_without_a_finding_and_an_honest_backend_with_one_are_red() {
        let (_, mut entries) = recorded();
        let none = BTreeSet::new();
        entries[0].note([0]);
        assert_eq!(verdict(&entries[0], &none, true), Verdict::NotClean);
        let fault = entries.iter_mut().find(|entry| entry.wants.len() > 1).unwrap();
        let first = fault.wants[0];
        fault.record.found.remove(&first);
        assert_eq!(verdict(fault, &none, true), Verdict::Missed(vec![first]));
        assert_eq!(verdict(fault, &none, false), Verdict::Caught);
        fault.record.found.clear();
        assert_eq!(verdict(fault, &none, false), Verdict::NotCaught);
    }

    #[test]
    fn a_part_of_the_card_has_its_honest_ones() {
        let (_, entries) = recorded();
        let names = ["readers:swaps-axes".to_owned(), "fault:exact-flushed".to_owned()];
        let some: Vec<String> = only(entries, &names).unwrap().into_iter().map(|entry| entry.name).collect();
        assert_eq!(some[5..], ["fault:exact-flushed", "readers", "readers:swaps-axes"]);
        let none = only(Vec::new(), &names).err().unwrap();
        assert!(none.starts_with("no fault is called `readers:swaps-axes`"), "{none}");
    }
}
