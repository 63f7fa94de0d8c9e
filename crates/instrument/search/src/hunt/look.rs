//! Evaluation of a scene on the backends: its findings and its heights.

use std::time::Duration;

use predicament_corpus::{LoadedScene, Spelled, Vocabulary};
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Finding, Outcome, Stop, Watch, run};

use super::heights;
use crate::{Backends, Wanted};

/// The target of a hunt: the wanted finding, and the backends.
#[derive(Clone)]
pub struct Quarry<'a> {
    /// The tasks, as suites name them.
    pub vocabulary: &'a Vocabulary,
    /// The task of the scenes.
    pub task: &'a dyn AnyTask,
    /// The wanted finding. Without a class, refusals and timeouts do not count.
    pub wanted: Wanted,
    /// The backends that must all show the finding.
    pub shown_by: Vec<&'a dyn Contestant>,
    /// The backends that must not show the finding.
    pub not_by: Vec<&'a dyn Contestant>,
    /// The sample sizes of the judge.
    pub budget: Budget,
    /// The watch that can end the work.
    pub watch: &'a Watch<'a>,
    /// The time limit of one backend on one scene.
    pub limit: Option<Duration>,
}

/// The result of evaluating a scene.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    /// The scene as read back from its text, so that scenes derived from it do not depend on whether the hunt was
    /// stopped and resumed.
    pub spelled: Spelled,
    /// The wanted findings of the first backend; the other backends show findings of the same class and check.
    pub findings: Vec<Finding>,
    /// The scene's height by each measure.
    pub heights: Vec<i64>,
    /// A hash of the scene's behaviour: scenes with new behaviour are kept for that alone.
    pub conduct: u64,
    /// The reason why a backend declines the scene.
    pub declined: Option<String>,
}

impl Quarry<'_> {
    /// The sample sizes of the judge in a hunt; it checks the laws between predicates only if contradictions are
    /// wanted.
    #[must_use]
    pub fn budget(wanted: &Wanted) -> Budget {
        let thorough = wanted.class.is_none_or(|class| class == Class::Inconsistent);
        Budget { findings_per_class: 100, permutations: 720, relations: 48, thorough, ties: 50, answers: false }
    }

    /// True if a finding is wanted.
    fn is_wanted(&self, finding: &Finding) -> bool {
        let quiet = matches!(finding.class, Class::Declined | Class::Timeout) && self.wanted.class.is_none();
        self.wanted.is(finding) && !quiet
    }

    /// Evaluates a scene; `None` if it is not a scene of the task, or its published data contradict the truth.
    ///
    /// # Errors
    /// [`Stop::Interrupted`].
    pub(super) fn look(&self, spelled: &Spelled) -> Result<Option<Seen>, Stop> {
        let Ok(loaded) = spelled.loaded(self.vocabulary, "hunted") else { return Ok(None) };
        let read = loaded.spelled().unwrap_or_else(|| spelled.clone());
        self.look_at(&loaded, read)
    }

    fn look_at(&self, loaded: &LoadedScene, spelled: Spelled) -> Result<Option<Seen>, Stop> {
        let watch = self.watch.restarted(self.limit);
        let case = match self.task.case(loaded, &watch) {
            Ok(case) => case,
            Err(Stop::Timeout) => return Ok(None),
            Err(Stop::Interrupted) => return Err(Stop::Interrupted),
        };
        if case.dispute().is_some() {
            return Ok(None);
        }
        let outcomes = |backends: &[&dyn Contestant]| -> Result<Vec<Outcome>, Stop> {
            let one = |backend: &&dyn Contestant| {
                run(case.as_ref(), *backend, self.budget, &self.watch.restarted(self.limit))
            };
            backends.iter().map(one).collect()
        };
        let shown = outcomes(&self.shown_by)?;
        let Some(first) = shown.first() else { return Ok(None) };
        let mut findings: Vec<Finding> = first.findings.iter().filter(|one| self.is_wanted(one)).cloned().collect();
        let has = |outcome: &Outcome, finding: &Finding| {
            outcome.findings.iter().any(|other| other.class == finding.class && other.check == finding.check)
        };
        findings.retain(|finding| shown[1..].iter().all(|outcome| has(outcome, finding)));
        if !findings.is_empty() && !self.not_by.is_empty() {
            let not_shown = outcomes(&self.not_by)?;
            findings.retain(|finding| !not_shown.iter().any(|outcome| has(outcome, finding)));
        }
        let declined = shown.iter().flat_map(|outcome| &outcome.findings).find(|one| one.class == Class::Declined);
        let heights = heights::of(loaded, self, &shown);
        let conduct = heights::conduct(loaded, &shown, &heights);
        Ok(Some(Seen { spelled, findings, heights, conduct, declined: declined.map(|one| one.got.clone()) }))
    }

    /// A witness for one class and check, with the same backends.
    pub(super) fn witness(&self, wanted: Wanted) -> Backends<'_> {
        Backends {
            task: self.task,
            wanted,
            shown_by: self.shown_by.clone(),
            not_by: self.not_by.clone(),
            budget: self.budget,
            watch: self.watch,
            limit: self.limit,
        }
    }
}
