//! What a scene shows on the backends, and how high it is.

use std::time::Duration;

use predicament_corpus::{LoadedScene, Spelled, Vocabulary};
use predicament_tasks::{AnyTask, Budget, Class, Contestant, Finding, Outcome, Stop, Watch, run};

use super::heights;
use crate::{Backends, Wanted};

/// What is hunted, and on which backends.
#[derive(Clone)]
pub struct Quarry<'a> {
    /// The tasks, as suites know them.
    pub vocabulary: &'a Vocabulary,
    /// The task of the scenes.
    pub task: &'a dyn AnyTask,
    /// What is looked for. Without a class neither a refusal nor a timeout counts.
    pub wanted: Wanted,
    /// All of these have to show it.
    pub shown_by: Vec<&'a dyn Contestant>,
    /// None of these may show it.
    pub not_by: Vec<&'a dyn Contestant>,
    /// How much the judge samples.
    pub budget: Budget,
    /// What ends the work.
    pub watch: &'a Watch<'a>,
    /// How long one backend may take for one scene.
    pub limit: Option<Duration>,
}

/// What a scene shows.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    /// The scene as its text is read: what is derived from it does not depend on whether the hunt was stopped and read from its file.
    pub spelled: Spelled,
    /// What is wanted, of the first backend; the others show findings of the same class and check.
    pub findings: Vec<Finding>,
    /// How high it is by each measure.
    pub heights: Vec<i64>,
    /// What it does, in a number: scenes that do something new are kept for that alone.
    pub conduct: u64,
    /// Why a backend declines it.
    pub declined: Option<String>,
}

impl Quarry<'_> {
    /// How much the judge samples in a hunt: the laws between predicates only where contradictions are wanted.
    #[must_use]
    pub fn budget(wanted: &Wanted) -> Budget {
        let thorough = wanted.class.is_none_or(|class| class == Class::Inconsistent);
        Budget { findings_per_class: 100, permutations: 720, relations: 48, thorough, ties: 50, answers: false }
    }

    /// Whether a finding is one that is hunted.
    fn is_wanted(&self, finding: &Finding) -> bool {
        let quiet = matches!(finding.class, Class::Declined | Class::Timeout) && self.wanted.class.is_none();
        self.wanted.is(finding) && !quiet
    }

    /// What a scene shows; none where it is no scene of the task, or what came with it contradicts the truth.
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

    /// The same backends, asked for one class and check alone.
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
