//! Guards pass on the tool, and each planted fault is detected by the guards listed for it.

use std::collections::BTreeSet;

use predicament_oracle::faults::Area;
use predicament_oracle::guards::{Held, faults, guards, honest};

#[test]
fn what_is_right_is_right_by_all_guards() {
    for area in [Area::Oracle, Area::Readers] {
        let held = honest(area);
        let names: Vec<&str> = guards().filter(|guard| guard.area == area).map(|guard| guard.name).collect();
        assert_eq!(held.iter().map(|held| held.guard).collect::<Vec<_>>(), names);
        for Held { guard, facts, broken } in held {
            assert_eq!(broken, None, "{guard}");
            assert!(facts > 1, "{guard} looks at {facts} facts");
        }
    }
}

#[test]
fn each_fault_is_found_by_the_guards_that_are_named_for_it() {
    let mut needed: BTreeSet<&str> = BTreeSet::new();
    let mut names = BTreeSet::new();
    for fault in faults() {
        let found: Vec<&str> = fault.run().iter().filter(|held| held.broken.is_some()).map(|held| held.guard).collect();
        let missed: Vec<&&str> = fault.caught_by.iter().filter(|name| !found.contains(name)).collect();
        assert!(missed.is_empty(), "{}: missed by {missed:?}, found by {found:?}", fault.name);
        assert!(!fault.caught_by.is_empty() && names.insert(fault.name), "{}", fault.name);
        needed.extend(fault.caught_by.iter().copied());
    }
    for guard in guards() {
        assert!(needed.contains(guard.name), "no fault needs `{}`", guard.name);
    }
}
