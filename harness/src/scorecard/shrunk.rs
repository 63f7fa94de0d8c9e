//! Shrinks a scene while it still shows a fault to a check.

use std::time::Duration;

use predicament_corpus::{Level, LoadedScene};
use predicament_search::shrink::{Limits, shrink};
use predicament_search::{Backends, Wanted, Witness};
use predicament_tasks::{AnySpoiled, AnyTask, Budget, Contestant, Finding, Outcome, Stop, Watch};

use super::declared::{Declared, Of};
use super::entries::{Entry, Kind, answer, honest};
use crate::shrinking::Measure;
use crate::tool::Tool;
use crate::{interrupt, planning};

/// The time limit for a scene; a scene that takes longer counts as not showing the fault.
const LIMIT: Duration = Duration::from_secs(2);

/// The options of shrinking.
pub struct Shrinking<'a> {
    pub tool: &'a Tool,
    pub check: &'a Declared,
    pub contestants: &'a [Box<dyn Contestant>],
    /// The maximum number of scenes evaluated.
    pub evaluations: u64,
}

impl Shrinking<'_> {
    /// The size of the smallest scene, or `None` if the task cannot write its scenes out.
    pub fn shrunk(&self, entry: &Entry, loaded: &LoadedScene, outcome: &Outcome) -> Option<Measure> {
        let Of::Judge(check) = self.check.of else { return None };
        let start = loaded.spelled()?;
        let found = outcome.findings.iter().find(|finding| check.has(finding.class, &finding.check))?;
        let named: Vec<_> = found.queries.iter().flat_map(|query| query.vertices().collect::<Vec<_>>()).collect();
        let wanted = Wanted::finding(found.class, &found.check);
        let quiet = |_: u64| {};
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let task = self.tool.task(loaded.task);
        let budget = Budget { thorough: check.thorough, ..planning::budget(Level::Quick) };
        let limits = Limits { evaluations: self.evaluations };
        let run = |witness: &dyn Witness| {
            shrink(self.tool.vocabulary(), witness, start.clone(), &named, limits, 0, &mut |_, _, _| {})
        };
        let done = match entry.kind {
            Kind::Backend(_) => {
                let backend = honest(self.contestants, &entry.name);
                let witness = Backends {
                    task,
                    wanted,
                    shown_by: vec![backend],
                    not_by: Vec::new(),
                    budget,
                    watch: &watch,
                    limit: Some(LIMIT),
                };
                run(&witness)
            }
            Kind::Answer => {
                let faults = task.spoiled_answers();
                let fault = faults.iter().find(|fault| answer(fault.name()) == entry.name)?.as_ref();
                let backend = honest(self.contestants, fault.backend());
                run(&Answers { task, fault, backend, wanted, budget, watch: &watch })
            }
            Kind::Honest | Kind::HonestPart(_) | Kind::Part(_) => return None,
        };
        done.ok().map(|shrunk| Measure::of(&shrunk.spelled))
    }
}

/// Right answers that are spoiled by a fault.
struct Answers<'a> {
    task: &'a dyn AnyTask,
    fault: &'a dyn AnySpoiled,
    backend: &'a dyn Contestant,
    wanted: Wanted,
    budget: Budget,
    watch: &'a Watch<'a>,
}

impl Witness for Answers<'_> {
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop> {
        let watch = self.watch.restarted(Some(LIMIT));
        let case = match self.task.case(loaded, &watch) {
            Ok(case) => case,
            Err(Stop::Timeout) => return Ok(None),
            Err(Stop::Interrupted) => return Err(Stop::Interrupted),
        };
        if case.dispute().is_some() {
            return Ok(None);
        }
        let outcome = predicament_oracle::run_spoiled(case.as_ref(), self.fault, self.backend, self.budget, &watch)?;
        Ok(self.wanted.of(&outcome).cloned())
    }
}
