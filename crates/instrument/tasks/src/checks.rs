//! Declarations of the checks that a judge can report: each has a class, a name and a meaning.
//!
//! A task lists its own checks in [`Task::checks`](crate::Task::checks); [`ON_EVERY_TASK`] lists those that can occur
//! for any scene on any backend. A finding that no list declares is a mistake in the judge: `selftest` and `gate` fail
//! then. Conversely, a planted fault must need each check; otherwise nobody knows if the check works.

use crate::replies::{ACCEPTED, ANSWER, REFUSED};
use crate::{AnyTask, Class};

/// A check; equal checks of different tasks are one check.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Check {
    /// The class of its findings.
    pub class: Class,
    /// Its name in findings.
    pub name: &'static str,
    /// The property that the check tests, in one line.
    pub means: &'static str,
    /// True if it runs only with plenty of time: see [`Budget::thorough`](crate::Budget::thorough).
    pub thorough: bool,
    /// The names that findings have instead of this one: the invariants that an algorithm can find violated.
    pub rules: &'static [&'static [&'static str]],
}

impl Check {
    /// A check with its own name.
    #[must_use]
    pub const fn new(class: Class, name: &'static str, means: &'static str) -> Check {
        Check { class, name, means, thorough: false, rules: &[] }
    }

    /// A check of a property of a whole scene.
    #[must_use]
    pub const fn topology(name: &'static str, means: &'static str) -> Check {
        Check::new(Class::Topology, name, means)
    }

    /// A metric law that rounding of vertices alone violates; larger violations belong to [`topology`](Check::topology)
    /// of the same name.
    #[must_use]
    pub const fn rounded(name: &'static str, means: &'static str) -> Check {
        Check::new(Class::Rounded, name, means)
    }

    /// The invariants that an algorithm checks during its run: if signs contradict each other it stops and names the
    /// violated invariant, which becomes the name of the finding.
    #[must_use]
    pub const fn invariants(means: &'static str, rules: &'static [&'static [&'static str]]) -> Check {
        Check { rules, ..Check::topology("invariant", means) }
    }

    /// The check, restricted to runs with plenty of time.
    #[must_use]
    pub const fn with_time(self) -> Check {
        Check { thorough: true, ..self }
    }

    /// True if a finding of this class and check name belongs to the check.
    #[must_use]
    pub fn has(&self, class: Class, check: &str) -> bool {
        let is_rule = || self.rules.iter().any(|rules| rules.contains(&check));
        self.class == class && (if self.rules.is_empty() { self.name == check } else { is_rule() })
    }
}

/// Formats the check as `class (name)`.
impl std::fmt::Display for Check {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.class.name(), self.name)
    }
}

/// Checks of every task: a refusal, or the end of the backend.
pub const ON_EVERY_TASK: &[Check] = &[
    Check::new(Class::Panic, "panic", "the backend does not panic"),
    Check::new(Class::Panic, "crashed", "its process ends when the tool ends it, not before"),
    Check::new(Class::Panic, "out of memory", "its process has enough memory"),
    Check::new(Class::Panic, "start", "an engine can be started"),
    Check::new(Class::Panic, "protocol", "an engine follows the protocol"),
    Check::new(Class::Panic, "engine error", "an engine reports no error for a batch of queries"),
    Check::new(Class::Timeout, "time limit", "it answers within the time limit"),
    Check::new(Class::Timeout, "silence", "an engine answers within its silence limit"),
    Check::new(Class::Declined, "prepare", "it accepts the scene"),
    Check::new(Class::Declined, "supports", "it offers the predicates that the task uses"),
    Check::new(Class::Declined, "construct", "it constructs the vertices that the task needs"),
    Check::new(Class::Declined, "batch", "an engine answers each batch"),
    Check::new(Class::Declined, "query", "an engine answers each query"),
    Check::new(Class::Declined, "certificate", "a library is certain of its answer"),
    Check::new(Class::Declined, "coordinates", "a library accepts the coordinates"),
    Check::new(Class::Declined, ANSWER, "a program answers each scene"),
    Check::new(Class::Refused, REFUSED, "a program reports no error for valid input"),
    Check::new(Class::Accepted, ACCEPTED, "a program reports an error for invalid input, or declines it"),
];

/// True if the task, or the list for every task, declares a finding of this class and name. A task without a list
/// declares nothing, and every finding counts as declared.
#[must_use]
pub fn is_declared(task: &dyn AnyTask, class: Class, check: &str) -> bool {
    let own = task.declared_checks();
    own.is_empty() || own.iter().chain(ON_EVERY_TASK).any(|declared| declared.has(class, check))
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: Check = Check::invariants("what a sweep relies on", &[&["events come in order"], &["a loop ends"]]);

    #[test]
    fn a_check_has_its_own_findings_and_no_others() {
        let sign = Check::new(Class::SignFlip, "sign", "each sign is right");
        assert!(sign.has(Class::SignFlip, "sign"));
        assert!(!sign.has(Class::Overreach, "sign") && !sign.has(Class::SignFlip, "perturbed sign"));
        assert!(RULE.has(Class::Topology, "a loop ends") && RULE.has(Class::Topology, "events come in order"));
        assert!(!RULE.has(Class::Topology, "invariant") && !RULE.has(Class::Topology, "euler"));
        assert_eq!(RULE.to_string(), "topology (invariant)");
    }
}
