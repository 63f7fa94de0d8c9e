//! Runs faults on scenes until all checks that have to find them have found them.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Level, LoadedScene};
use predicament_oracle::expect::Expectations;
use predicament_oracle::guards::{self, Held};
use predicament_tasks::{AnyCase, Budget, Contestant, Outcome, Stop, Watch};
use rayon::prelude::*;

use super::declared::Declarations;
use super::entries::{Entry, Kind, TWO_MESHES, answer, caught, honest};
use super::shrunk::Shrinking;
use crate::exit::{self, Failure};
use crate::select::Selection;
use crate::tool::Tool;
use crate::{interrupt, planning, progress};

/// Scenes with more queries are not run thoroughly.
const MOST_THOROUGH: usize = 100_000;

/// The options of the work.
pub struct How {
    /// True if each fault is run on all scenes; false if only until it is caught.
    pub everything: bool,
    /// The maximum number of scenes evaluated to shrink each scene, or `None` to shrink none.
    pub shrink: Option<u64>,
}

/// The work on all entries.
pub struct Work<'a> {
    pub tool: &'a Tool,
    pub checks: &'a Declarations,
    pub entries: &'a mut [Entry],
    pub expected: &'a Expectations,
    pub how: How,
}

/// The outcomes of entries, by index.
type Found = Vec<(usize, Outcome)>;

impl Work<'_> {
    /// Runs the parts of the tool, then all scenes.
    pub fn run(mut self, selection: &Selection) -> Result<(), Failure> {
        self.parts();
        let backends = self.entries.iter().filter(|entry| entry.is_backend());
        let contestants: Result<Vec<Box<dyn Contestant>>, String> =
            backends.map(|entry| self.tool.backend(&entry.name)).collect();
        let contestants = contestants.map_err(Failure::usage)?;
        if self.entries.iter().all(|entry| !self.is_open(entry)) {
            return Ok(());
        }
        let mut scenes = selection.plan()?;
        // Small scenes first: a fault that a small scene shows need not be run on a large one.
        scenes.sort_by_key(|scene| scene.plan.queries);
        interrupt::listen_for_all();
        let bar = progress::bar(scenes.len() as u64, "scenes");
        let interrupted = |_| {
            let message =
                "interrupted: no card, because faults that were not found yet would count as missed".to_owned();
            Failure { message, code: exit::INCOMPLETE }
        };
        for scene in &mut scenes {
            bar.inc(1);
            let task = scene.plan.task.as_str();
            let is_needed = self.entries.iter().any(|entry| self.is_open_in(entry, task))
                || self.tool.task(task).spoiled_answers().iter().any(|spoiled| self.open(spoiled.name()).is_some());
            let loaded = scene.take(selection)?;
            if is_needed || loaded.scene.second_mesh().is_some() {
                self.scene(&loaded, &contestants).map_err(interrupted)?;
            }
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn is_open(&self, entry: &Entry) -> bool {
        entry.is_open() || self.how.everything && entry.is_fault() && !matches!(entry.kind, Kind::Part(_))
    }

    /// True if a faulty backend is run on the next scene of a task. Once something has found the fault, it is run only
    /// on tasks that use a check that still misses it.
    fn is_open_in(&self, entry: &Entry, task: &str) -> bool {
        let is_tried = |check: usize| self.checks.0[check].is_tried_in(task);
        entry.is_open_in(task) && (entry.record.found.is_empty() || entry.missed().any(is_tried))
            || self.how.everything && matches!(entry.kind, Kind::Backend(fault) if fault.shows_in(task))
    }

    /// The index of a fault in an answer that is run on the next scene.
    fn open(&self, fault: &str) -> Option<usize> {
        let name = answer(fault);
        self.entries.iter().position(|entry| entry.name == name && self.is_open(entry))
    }

    /// Runs the guards on parts of the tool.
    fn parts(&mut self) {
        for entry in self.entries.iter_mut() {
            let held: Vec<Held> = match entry.kind {
                Kind::Part(fault) => fault.run(),
                Kind::HonestPart(area) => guards::honest(area),
                Kind::Honest | Kind::Backend(_) | Kind::Answer => continue,
            };
            entry.record.scenes = 1;
            for Held { guard, facts, broken } in held {
                entry.record.queries += facts;
                if broken.is_some() {
                    entry.note(self.checks.guard(guard));
                }
            }
        }
    }

    /// Runs the open entries on a scene. If they found something new, runs the honest backends too.
    fn scene(&mut self, loaded: &LoadedScene, contestants: &[Box<dyn Contestant>]) -> Result<(), Stop> {
        let quiet = |_: u64| {};
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let case = self.tool.task(loaded.task).case(loaded, &watch)?;
        let found = self.faulty(case.as_ref(), contestants, &watch)?;
        let catches: BTreeMap<usize, BTreeSet<usize>> = found
            .iter()
            .map(|(at, outcome)| {
                let (catches, undeclared) = caught(self.checks, loaded.task, outcome);
                let record = &mut self.entries[*at].record;
                record.scenes += 1;
                record.queries += outcome.queries;
                record.undeclared.extend(undeclared);
                (*at, catches)
            })
            .collect();
        let gains = catches.iter().any(|(at, catches)| self.gains(&self.entries[*at], catches));
        let has_two = loaded.scene.second_mesh().is_some();
        let is_held =
            |entry: &Entry| matches!(entry.kind, Kind::Honest) && (gains || has_two && entry.name == TWO_MESHES);
        let honest = self.run_backends(case.as_ref(), contestants, &watch, is_held)?;
        // A finding that an honest backend is expected to show catches no fault.
        let mut known: BTreeSet<usize> = BTreeSet::new();
        for (at, outcome) in honest {
            let (catches, undeclared) = caught(self.checks, loaded.task, &outcome);
            let entry = &mut self.entries[at];
            let of = |check: &usize| {
                let mut of = self.expected.matching(&loaded.suite, &loaded.name, &entry.name, Level::Quick.name());
                let class = self.checks.0[*check].class();
                of.any(|expected| Some(expected.class) == class)
            };
            let (expected, wrong): (BTreeSet<usize>, BTreeSet<usize>) = catches.into_iter().partition(of);
            entry.record.scenes += 1;
            entry.record.queries += outcome.queries;
            entry.record.undeclared.extend(undeclared);
            entry.note(wrong);
            known.extend(expected);
        }
        // Without a new find the honest backends were not run, and no find is lost.
        for (at, catches) in catches.into_iter().filter(|_| gains) {
            let before = self.entries[at].missed().collect::<Vec<_>>();
            self.entries[at].note(catches.difference(&known).copied());
            let first = before.into_iter().find(|check| self.entries[at].record.found.contains_key(check));
            if let (Some(evaluations), Some(check)) = (self.how.shrink, first)
                && self.entries[at].record.shrunk.is_none()
            {
                let of = Shrinking { tool: self.tool, check: &self.checks.0[check], contestants, evaluations };
                let outcome = found.iter().find(|(of, _)| *of == at).map(|(_, outcome)| outcome);
                let entry = &mut self.entries[at];
                entry.record.shrunk = outcome.and_then(|outcome| of.shrunk(entry, loaded, outcome));
            }
        }
        Ok(())
    }

    /// True if an outcome has a find by a check that had missed the fault.
    fn gains(&self, entry: &Entry, catches: &BTreeSet<usize>) -> bool {
        let is_new = |check: &usize| !entry.record.found.contains_key(check);
        if self.how.everything || entry.record.found.is_empty() {
            return catches.iter().any(is_new);
        }
        catches.iter().any(|check| entry.wants.contains(check) && is_new(check))
    }

    /// The sampling budget; thorough if a check that still misses the fault is tested only then.
    fn budget(&self, entry: &Entry, case: &dyn AnyCase) -> Budget {
        let task = case.task().name();
        let is_tried = |check: usize| {
            let declared = &self.checks.0[check];
            declared.is_thorough() && declared.is_tried_in(task)
        };
        let is_wanted = match self.how.everything {
            true => entry.is_fault() && (0..self.checks.0.len()).any(is_tried),
            false => entry.missed().any(is_tried),
        };
        let thorough = is_wanted && case.loaded().count() <= MOST_THOROUGH;
        Budget { thorough, ..planning::budget(Level::Quick) }
    }

    /// Runs the backends of these entries, which come first in the list.
    fn run_backends(
        &self,
        case: &dyn AnyCase,
        contestants: &[Box<dyn Contestant>],
        watch: &Watch,
        which: impl Fn(&Entry) -> bool + Sync,
    ) -> Result<Found, Stop> {
        let entries = &*self.entries;
        let chosen: Vec<(usize, &dyn Contestant, Budget)> = contestants
            .iter()
            .enumerate()
            .filter(|(at, _)| which(&entries[*at]))
            .map(|(at, one)| (at, one.as_ref(), self.budget(&entries[at], case)))
            .collect();
        let run = |(at, one, budget): (usize, &dyn Contestant, Budget)| {
            Ok((at, predicament_oracle::run(case, one, budget, watch)?))
        };
        chosen.into_par_iter().map(run).collect()
    }

    /// Runs the open faults: faulty backends, and right answers with each fault of the scene's task.
    fn faulty(&self, case: &dyn AnyCase, contestants: &[Box<dyn Contestant>], watch: &Watch) -> Result<Found, Stop> {
        let task = case.task().name();
        let open: BTreeSet<&str> =
            self.entries.iter().filter(|entry| self.is_open_in(entry, task)).map(|entry| entry.name.as_str()).collect();
        let mut found = self.run_backends(case, contestants, watch, |entry| open.contains(entry.name.as_str()))?;
        for spoiled in case.task().spoiled_answers() {
            let Some(at) = self.open(spoiled.name()) else { continue };
            let honest = honest(contestants, spoiled.backend());
            let budget = planning::budget(Level::Quick);
            found.push((at, predicament_oracle::run_spoiled(case, spoiled.as_ref(), honest, budget, watch)?));
        }
        Ok(found)
    }
}
