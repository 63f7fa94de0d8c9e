//! The checks that a judge can report, declared: each has a class, a name and a meaning.
//!
//! A task lists its own in [`Task::checks`](crate::Task::checks); what can happen to any scene on any backend is in
//! [`ON_EVERY_TASK`]. A finding that no list has is a mistake in the judge: `selftest` and `gate` are red then. The
//! other way round each check has to be needed by a planted fault, or it would not be known whether it works.

use crate::{AnyTask, Class};

/// A check: two that are equal are one, whatever tasks declare it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Check {
    /// The class of its findings.
    pub class: Class,
    /// Its name, as findings have it.
    pub name: &'static str,
    /// What holds where it finds nothing, in one line.
    pub means: &'static str,
    /// Whether it is one of the relations that are tried with plenty of time only: see
    /// [`Budget::thorough`](crate::Budget::thorough).
    pub thorough: bool,
    /// The names that findings have instead of this one: the statements that an algorithm found violated.
    pub rules: &'static [&'static [&'static str]],
}

impl Check {
    /// A check with a name of its own.
    #[must_use]
    pub const fn new(class: Class, name: &'static str, means: &'static str) -> Check {
        Check { class, name, means, thorough: false, rules: &[] }
    }

    /// One of what holds of a whole scene.
    #[must_use]
    pub const fn topology(name: &'static str, means: &'static str) -> Check {
        Check::new(Class::Topology, name, means)
    }

    /// A metric law that is violated by the rounding of vertices alone; what is violated by more is
    /// [`topology`](Check::topology) of the same name.
    #[must_use]
    pub const fn rounded(name: &'static str, means: &'static str) -> Check {
        Check::new(Class::Rounded, name, means)
    }

    /// The statements that an algorithm looks after itself: where signs contradict each other it stops and says which does
    /// not hold, and that is the name of the finding.
    #[must_use]
    pub const fn invariants(means: &'static str, rules: &'static [&'static [&'static str]]) -> Check {
        Check { rules, ..Check::topology("invariant", means) }
    }

    /// The same, for plenty of time only.
    #[must_use]
    pub const fn with_time(self) -> Check {
        Check { thorough: true, ..self }
    }

    /// Whether a finding of this class and check is one of its own.
    #[must_use]
    pub fn has(&self, class: Class, check: &str) -> bool {
        let is_rule = || self.rules.iter().any(|rules| rules.contains(&check));
        self.class == class && (if self.rules.is_empty() { self.name == check } else { is_rule() })
    }
}

/// `class (name)`.
impl std::fmt::Display for Check {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.class.name(), self.name)
    }
}

/// What can happen to a scene whatever its task is: a refusal, or the end of the backend.
pub const ON_EVERY_TASK: &[Check] = &[
    Check::new(Class::Panic, "panic", "the backend does not panic"),
    Check::new(Class::Panic, "crashed", "its process ends when it is told to, and not before"),
    Check::new(Class::Panic, "out of memory", "its process has memory enough"),
    Check::new(Class::Panic, "start", "an engine can be started"),
    Check::new(Class::Panic, "protocol", "an engine keeps to the protocol"),
    Check::new(Class::Panic, "engine error", "an engine reports no error"),
    Check::new(Class::Timeout, "time limit", "it answers within the time limit"),
    Check::new(Class::Timeout, "silence", "an engine is not silent for longer than it may be"),
    Check::new(Class::Declined, "prepare", "it takes the scene"),
    Check::new(Class::Declined, "supports", "it has the predicates that the task asks"),
    Check::new(Class::Declined, "construct", "it constructs the vertices that come up"),
    Check::new(Class::Declined, "batch", "an engine answers each batch"),
    Check::new(Class::Declined, "query", "an engine answers each query"),
    Check::new(Class::Declined, "certificate", "a library is certain of its answer"),
    Check::new(Class::Declined, "coordinates", "a library takes the coordinates"),
];

/// Whether a finding of this class and name is one that a task declares, or one of every task. A task without a list
/// declares nothing, and is not held to it.
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
