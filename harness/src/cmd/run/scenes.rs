//! The scenes of a run, one after another: each backend is judged here or in a separate process, and its rows are
//! written.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

use indicatif::ProgressBar;
use predicament_engines::PREFIX;
use predicament_oracle::expect::Expectations;
use predicament_oracle::run as judge;
use predicament_records::{self as records, CostRow, PlannedScene, SummaryRow};
use predicament_tasks::{AnyCase, Budget, Class, Contestant, Outcome, Stop, Watch};
use rayon::prelude::*;

use predicament_corpus::Level;

use super::{Args, Job};
use crate::exit::{self, Failure};
use crate::ledger::Ledger;
use crate::planning::budget;
use crate::select::{Planned, Selection};
use crate::stopwatch::{Cost, Stopwatch};
use crate::tool::Tool;
use crate::worker::{self, Worker};
use crate::{interrupt, progress};

/// `Continue` if the run continues, `Break` if it stops.
type Flow = ControlFlow<()>;

/// The result of all scenes.
pub struct Ended {
    /// The folder of the run.
    pub folder: PathBuf,
    /// The exit code, by the rows.
    pub code: u8,
    /// True if somebody interrupted the run.
    pub is_interrupted: bool,
}

/// Runs the scenes of a job, except those that are done.
pub fn all(args: &Args, tool: &Tool, job: Job, expected: &Expectations) -> Result<Ended, Failure> {
    let Job { selection, mut scenes, backends, engines, permutations, ledger } = job;
    let work = scenes.iter().map(|scene| work(&scene.plan, &backends, &ledger)).sum();
    let by_level = budget(selection.level);
    let mut run = Run {
        args,
        tool,
        selection: &selection,
        backends: &backends,
        engines: &engines,
        expected,
        permutations,
        budget: Budget {
            permutations: permutations.unwrap_or(by_level.permutations),
            answers: ledger.answers,
            ..by_level
        },
        // A scene that ran out of time before the resume still counts as a timeout.
        ended: later(records::Outcome::Complete, &ledger.done),
        ledger,
        bar: progress::bar(work, "answers"),
    };
    // Each scene is dropped before the next is loaded.
    for planned in &mut scenes {
        if run.scene(planned)?.is_break() {
            run.ended = records::Outcome::Interrupted;
            break;
        }
    }
    run.bar.finish_and_clear();
    let folder = run.ledger.folder.clone();
    let is_interrupted = run.ended == records::Outcome::Interrupted;
    Ok(Ended { folder, code: run.ledger.finish(run.ended)?, is_interrupted })
}

/// A run in progress.
struct Run<'r> {
    args: &'r Args,
    tool: &'r Tool,
    selection: &'r Selection,
    backends: &'r [Box<dyn Contestant>],
    /// The files of engines, by backend name.
    engines: &'r BTreeMap<String, String>,
    expected: &'r Expectations,
    permutations: Option<usize>,
    budget: Budget,
    /// The outcome of the run so far.
    ended: records::Outcome,
    ledger: Ledger,
    bar: ProgressBar,
}

impl<'r> Run<'r> {
    /// Runs the backends that have not answered a scene.
    fn scene(&mut self, planned: &mut Planned) -> Result<Flow, Failure> {
        let scene = planned.plan.clone();
        let left = self.left(&scene);
        if left.is_empty() && self.ledger.is_planned(&scene) {
            return Ok(self.pass_over(&scene));
        }
        self.bar.set_message(scene.scene.clone());
        let clock = Stopwatch::start();
        let loaded = planned.take(self.selection)?;
        self.ledger.plan(&scene, &loaded)?;
        if left.is_empty() {
            return Ok(self.pass_over(&scene));
        }
        let task = self.tool.task(loaded.task);
        let (apart, here): (Vec<&dyn Contestant>, Vec<_>) =
            left.iter().partition(|backend| self.args.isolates(self.tool, &backend.name(), task));
        let bar = self.bar.clone();
        let told = |done: u64| bar.inc(done);
        let watch = Watch::new(interrupt::flag(), None, &told);
        let Ok(case) = (!here.is_empty()).then(|| task.case(&loaded, &watch)).transpose() else {
            return Ok(Flow::Break(()));
        };
        let mut shared = clock.read();
        let case = case.as_deref();
        refuse_disputed(&scene, case)?;
        let worker = self.worker(planned, &scene);
        let mut side_by_side = self.side_by_side(case, &here, &watch).map(Vec::into_iter);
        for backend in left {
            let is_apart = apart.iter().any(|other| other.name() == backend.name());
            let flow = match case.filter(|_| !is_apart) {
                None => self.apart(&worker, &scene, backend)?,
                Some(case) => {
                    // Pictures of pixel maps are written with their rows; other scenes have no pictures.
                    if loaded.family == "pixel-map" {
                        self.ledger.draw(case, backend)?;
                    }
                    let (outcome, [cost, for_all]) = match &mut side_by_side {
                        Some(outcomes) => outcomes.next().expect("one for each backend"),
                        None => {
                            let watch = || watch.restarted(self.args.timeout);
                            together(case, &[backend], self.budget, watch).remove(0)
                        }
                    };
                    shared = shared.plus(for_all);
                    self.note(&scene, backend, outcome, cost)?
                }
            };
            if flow.is_break() {
                return Ok(flow);
            }
        }
        self.ledger.cost(&scene, CostRow::TRUTH, shared)?;
        Ok(Flow::Continue(()))
    }

    /// The backends that have not answered a scene.
    fn left(&self, scene: &PlannedScene) -> Vec<&'r dyn Contestant> {
        let is_left = |name: &str| self.ledger.takes(name, &scene.task) && !self.ledger.is_done(scene, name);
        self.backends.iter().map(AsRef::as_ref).filter(|backend| is_left(&backend.name())).collect()
    }

    fn pass_over(&self, scene: &PlannedScene) -> Flow {
        self.bar.inc(work(scene, self.backends, &self.ledger));
        Flow::Continue(())
    }

    /// The separate process for a scene.
    fn worker<'s>(&self, planned: &Planned, scene: &'s PlannedScene) -> Worker<'s>
    where
        'r: 's,
    {
        Worker {
            permutations: self.permutations,
            threads: self.args.threads,
            cache: self.args.selector.cache.as_deref(),
            folder: worker::folder(&self.ledger.folder),
            suite: self.selection.argument(&planned.def),
            engines: self.engines,
            scene,
            limit: self.args.limit(self.selection.level),
            level: self.selection.level,
            answers: self.ledger.answers,
        }
    }

    /// Judges several backends at once. Small scenes leave threads idle, so backends share the threads; a crash can
    /// lose only one such scene. Backends with a time limit run alone.
    fn side_by_side(
        &self,
        case: Option<&dyn AnyCase>,
        backends: &[&dyn Contestant],
        watch: &Watch<'_>,
    ) -> Option<Vec<Judged>> {
        let is_small = self.selection.level == Level::Quick && self.args.timeout.is_none();
        Some(together(case.filter(|_| is_small)?, backends, self.budget, || watch.restarted(None)))
    }

    /// Runs one backend in a separate process.
    fn apart(&mut self, worker: &Worker<'_>, scene: &PlannedScene, backend: &dyn Contestant) -> Result<Flow, Failure> {
        let clock = Stopwatch::start();
        let Some(found) = worker.run(self.tool, &backend.name())? else { return Ok(Flow::Break(())) };
        self.ledger.cost(scene, &backend.name(), clock.read().of_another())?;
        self.ended = later(self.ended, &found.summary);
        self.ledger.adopt(found, scene, &backend.name(), self.expected)?;
        self.bar.inc(scene.queries);
        Ok(Flow::Continue(()))
    }

    /// Writes the result of one backend.
    fn note(
        &mut self,
        scene: &PlannedScene,
        backend: &dyn Contestant,
        outcome: Result<Outcome, Stop>,
        cost: Cost,
    ) -> Result<Flow, Failure> {
        let Ok(outcome) = outcome else { return Ok(Flow::Break(())) };
        let name = backend.name();
        let cost = if name.starts_with(PREFIX) { cost.of_another() } else { cost };
        self.ledger.cost(scene, &name, cost)?;
        let summary = self.ledger.record(scene, &name, &outcome, self.expected)?;
        self.ended = later(self.ended, std::slice::from_ref(&summary));
        Ok(Flow::Continue(()))
    }
}

/// Refuses a scene that is not judged.
fn refuse_disputed(scene: &PlannedScene, case: Option<&dyn AnyCase>) -> Result<(), Failure> {
    let Some(dispute) = case.and_then(|case| case.dispute()) else { return Ok(()) };
    let message = format!("{}/{}: {dispute}", scene.suite, scene.scene);
    Err(Failure { message, code: exit::CORPUS })
}

/// The work of a scene, in answers: the truth, and the answers of the backends that run for its task.
fn work(scene: &PlannedScene, backends: &[Box<dyn Contestant>], ledger: &Ledger) -> u64 {
    let count = backends.iter().filter(|backend| ledger.takes(&backend.name(), &scene.task)).count();
    scene.queries * (count as u64 + 1)
}

/// A backend's outcome, with its own cost and the cost of verdicts that it found for all backends.
type Judged = (Result<Outcome, Stop>, [Cost; 2]);

/// Judges backends at once, and measures their costs. Threads work for any backend when they are free; the common cost
/// is divided in proportion to the backends' own clocks.
fn together<'w>(
    case: &dyn AnyCase,
    backends: &[&dyn Contestant],
    budget: Budget,
    watch: impl Fn() -> Watch<'w> + Sync,
) -> Vec<Judged> {
    let clock = Stopwatch::start();
    let timed = |backend: &&dyn Contestant| {
        let (start, watch) = (Instant::now(), watch());
        let done = judge(case, *backend, budget, &watch);
        (done, [start.elapsed().saturating_sub(watch.shared()), watch.shared()])
    };
    let done: Vec<_> = backends.par_iter().map(timed).collect();
    let (cost, whole) = (clock.read(), done.iter().flat_map(|(_, times)| times).sum());
    done.into_iter().map(|(done, times)| (done, times.map(|time| cost.share(time, whole)))).collect()
}

/// The outcome of the run so far, with these rows added.
fn later(ended: records::Outcome, rows: &[SummaryRow]) -> records::Outcome {
    let timed_out = rows.iter().any(|row| row.count(Class::Timeout) > 0);
    if timed_out && ended == records::Outcome::Complete { records::Outcome::Timeout } else { ended }
}
