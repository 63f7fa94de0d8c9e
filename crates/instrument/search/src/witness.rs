//! The finding that a scene must show.

use predicament_corpus::LoadedScene;
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Finding, Outcome, Stop, Watch, run};

/// A wanted finding: a class, and one check or any.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Wanted {
    /// The class; `None` means any class that is a finding.
    pub class: Option<Class>,
    /// The check; `None` means any.
    pub check: Option<String>,
}

impl Wanted {
    /// The wanted finding of a class and a check.
    #[must_use]
    pub fn finding(class: Class, check: &str) -> Wanted {
        Wanted { class: Some(class), check: Some(check.to_owned()) }
    }

    /// True if a finding is wanted.
    #[must_use]
    pub fn is(&self, finding: &Finding) -> bool {
        self.class.is_none_or(|class| class == finding.class)
            && self.check.as_ref().is_none_or(|check| *check == finding.check)
    }

    /// The first wanted finding of an outcome.
    #[must_use]
    pub fn of<'o>(&self, outcome: &'o Outcome) -> Option<&'o Finding> {
        outcome.findings.iter().find(|finding| self.is(finding))
    }
}

/// The interface that decides if a scene shows the wanted finding.
pub trait Witness {
    /// The finding that the scene shows, if any.
    ///
    /// # Errors
    /// [`Stop::Interrupted`]; a scene that takes too long shows only a timeout.
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop>;
}

/// Backends in this process: some must show a finding, others must not.
pub struct Backends<'a> {
    /// The task of the scenes.
    pub task: &'a dyn AnyTask,
    /// The wanted finding.
    pub wanted: Wanted,
    /// The backends that must all show it. The returned finding is that of the first.
    pub shown_by: Vec<&'a dyn Contestant>,
    /// The backends that must not show it.
    pub not_by: Vec<&'a dyn Contestant>,
    /// The sample sizes of the judge.
    pub budget: Budget,
    /// The watch that can end the work. A time limit applies to each backend on each scene.
    pub watch: &'a Watch<'a>,
    /// The time limit of a backend on a scene; `None` means unlimited.
    pub limit: Option<std::time::Duration>,
}

impl Witness for Backends<'_> {
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop> {
        let watch = self.watch.restarted(self.limit);
        let case = match self.task.case(loaded, &watch) {
            Ok(case) => case,
            Err(Stop::Timeout) => return Ok(None),
            Err(Stop::Interrupted) => return Err(Stop::Interrupted),
        };
        // Published data contradict the truth: nothing is compared.
        if case.dispute().is_some() {
            return Ok(None);
        }
        let find = |backend: &&dyn Contestant| -> Result<Option<Finding>, Stop> {
            let outcome = run(case.as_ref(), *backend, self.budget, &watch.restarted(self.limit))?;
            Ok(self.wanted.of(&outcome).cloned())
        };
        let mut first = None;
        for backend in &self.shown_by {
            match find(backend)? {
                None => return Ok(None),
                found => first = first.or(found),
            }
        }
        for backend in &self.not_by {
            if find(backend)?.is_some() {
                return Ok(None);
            }
        }
        Ok(first)
    }
}
