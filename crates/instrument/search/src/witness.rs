//! What a scene has to show.

use predicament_corpus::LoadedScene;
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Finding, Outcome, Stop, Watch, run};

/// What is looked for: a class of findings, of one check or of any.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Wanted {
    /// The class; any that is a finding where there is none.
    pub class: Option<Class>,
    /// The check; any where there is none.
    pub check: Option<String>,
}

impl Wanted {
    /// A class of findings by a check.
    #[must_use]
    pub fn finding(class: Class, check: &str) -> Wanted {
        Wanted { class: Some(class), check: Some(check.to_owned()) }
    }

    /// Whether a finding is one of these.
    #[must_use]
    pub fn is(&self, finding: &Finding) -> bool {
        self.class.is_none_or(|class| class == finding.class)
            && self.check.as_ref().is_none_or(|check| *check == finding.check)
    }

    /// The first finding of an outcome that is one of these.
    #[must_use]
    pub fn of<'o>(&self, outcome: &'o Outcome) -> Option<&'o Finding> {
        outcome.findings.iter().find(|finding| self.is(finding))
    }
}

/// Says whether a scene shows what is looked for.
pub trait Witness {
    /// The finding that the scene shows, if it does.
    ///
    /// # Errors
    /// [`Stop::Interrupted`]; a scene that takes too long shows nothing else.
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop>;
}

/// Backends in this process: some have to show a finding, others have to show none.
pub struct Backends<'a> {
    /// The task of the scenes.
    pub task: &'a dyn AnyTask,
    /// What is looked for.
    pub wanted: Wanted,
    /// All of these have to show it. The finding is that of the first.
    pub shown_by: Vec<&'a dyn Contestant>,
    /// None of these may show it.
    pub not_by: Vec<&'a dyn Contestant>,
    /// How much the judge samples.
    pub budget: Budget,
    /// What ends the work. A time limit is for each backend on each scene.
    pub watch: &'a Watch<'a>,
    /// Seconds for a backend on a scene; none without a limit.
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
        // What came with the data contradicts the truth: nothing is compared.
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
