//! `run`: every selected scene through every backend, each answer judged.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use predicament_corpus::Level;
use predicament_engines::PREFIX;
use predicament_records::{
    self as records, Build, CostRow, Env, NotSelected, Plan, PlannedScene, RunDir, RunWriter, Shard, SummaryRow, Whole,
    WorkPlan,
};
use predicament_tasks::{AnyCase, AnyTask, Budget, Class, Contestant, Stop, Watch};
use rayon::prelude::*;

use crate::exit::{self, Failure};
use crate::expectations::Held;
use crate::ledger::Ledger;
use crate::out::program;
use crate::planning::{budget, env, env_of, free_folder, plan, same_versions, tables_of};
use crate::programs::{Picked, Programs, Recorded, recorded};
use crate::select::{NOT_NAMED, Planned, Selection, Selector, suites_of};
use crate::stopwatch::{Cost, Stopwatch};
use crate::tool::{Tool, engines};
use crate::worker::{self, Worker};
use crate::{child, expectations, interrupt, progress};

pub const EXAMPLES: &str = "\
Examples:
  predicament run                                   all embedded corpora, all backends
  predicament run classics -b exact,sos,naive       one suite, three backends
  predicament run families -f 'near.*orient3d' --level full
  predicament run mine.toml --expected mine-expected.toml --out out/mine
  predicament run --shard 2/4 --out out/part2       a quarter of the work; `merge` puts the parts together
  predicament run --plan plan.json --shard 2/4 --out out/part2     the same, as `plan` has divided it
  predicament run mine.toml --answers               every answer of every backend, as CSV
  predicament run --resume out/part2                go on where it stopped
  predicament run mine.toml --shrink 2              the smallest scenes that show the first two findings of each class
  predicament run -b mine,exact --isolate --timeout 30    a backend that may crash, in a tool that has it";

/// Run scenes through backends and judge every answer
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; if left out those that run by default, and the end says which others there are
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Part k of n, by scene id or as the plan has it; all of it if left out
    #[arg(long, value_name = "k/n")]
    pub shard: Option<Shard>,

    /// Do what a file of `plan` says, or the part of it that --shard names
    #[arg(long, value_name = "FILE", conflicts_with_all = ["suites", "filter", "level", "backends", "answers", "permutations"])]
    pub plan: Option<PathBuf>,

    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// A new folder for the run; the first free predicament-run-N if left out
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Go on with an incomplete run; takes its selection from that run's plan
    #[arg(long, value_name = "DIR", conflicts_with_all = ["out", "plan", "shard", "backends", "answers", "filter", "level", "permutations"])]
    pub resume: Option<PathBuf>,

    #[command(flatten)]
    pub programs: Programs,

    /// Expected disagreements; those of the embedded corpora if left out
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// Evaluations that one backend spends on other orders of the arguments in
    /// one scene, 0 for none; 5,000 for quick and 24 million for full if left out
    #[arg(long, value_name = "N")]
    pub permutations: Option<usize>,

    /// Write every answer to answers.csv; what has no answer to each query is counted
    #[arg(long)]
    pub answers: bool,

    /// Seconds that one backend may take for one scene, such as 30 or 0.5; in a process of its own
    /// it is ended then (10 minutes at level quick if left out)
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub timeout: Option<Duration>,

    /// Run each scene and backend in a process of its own, so that a loop, a crash or a lack of memory costs
    /// one row; `auto` does so for backends that are not built in, and under --timeout for engines and for algorithms on whole scenes
    #[arg(long, value_name = "WHEN", value_enum, default_value_t = Isolate::Auto, num_args = 0..=1,
          default_missing_value = "always", require_equals = false)]
    pub isolate: Isolate,

    /// Shrink the first N findings of each class once the run is complete, unexpected ones first, into `shrunk` in its folder
    #[arg(long, value_name = "N")]
    pub shrink: Option<usize>,
}

/// Which scenes and backends run in a process of their own.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Isolate {
    /// Backends that are not built in, and under a time limit engines and algorithms on whole scenes.
    Auto,
    /// All.
    Always,
    /// None.
    Never,
}

/// The time limit of a scene in a process of its own at level quick, where none is given.
const PATIENCE: Duration = Duration::from_secs(600);

impl Args {
    /// Whether this backend runs a scene of this task in a process of its own. (An engine is one already, but is waited for in this one.)
    fn isolates(&self, tool: &Tool, backend: &str, task: &dyn AnyTask) -> bool {
        match self.isolate {
            Isolate::Auto => {
                let watches = task.looks_at_the_watch() && !backend.starts_with(PREFIX);
                tool.is_foreign(backend) || (self.timeout.is_some() && !watches)
            }
            Isolate::Always => true,
            Isolate::Never => false,
        }
    }

    /// Takes from the plan of a run that is resumed what its rows depend on and the selection does not say.
    fn recall(&mut self) -> Result<(), Failure> {
        let Some(folder) = &self.resume else { return Ok(()) };
        let plan = RunDir::plan(folder).map_err(Failure::usage)?;
        let no_count = |_| Failure::usage(format!("{}: permutations that can't be counted", folder.display()));
        self.permutations = plan.permutations.map(usize::try_from).transpose().map_err(no_count)?;
        let planned = plan.expected;
        if self.expected.is_none() {
            self.expected = planned.as_ref().map(|planned| PathBuf::from(&planned.file));
        }
        let now = self.expected.as_deref().map(expectations::file).transpose()?;
        if now.as_ref().map(|file| &file.sha256) != planned.as_ref().map(|file| &file.sha256) {
            let file = now.or(planned).map_or_else(|| folder.display().to_string(), |file| file.file);
            return Err(Failure::usage(format!(
                "{file}: the run was begun with other expectations; restore them, give the same --expected, or start a new run"
            )));
        }
        Ok(())
    }

    /// The time limit of a process.
    fn limit(&self, level: Level) -> Option<Duration> {
        self.timeout.or((level == Level::Quick).then_some(PATIENCE))
    }
}

/// A time limit from seconds: a positive number, up to some thirty years, as clocks can't add what is beyond them.
pub fn seconds(text: &str) -> Result<Duration, String> {
    const MOST: f64 = 1e9;
    let seconds = text.parse().ok().filter(|&seconds: &f64| seconds > 0.0 && seconds <= MOST);
    let limit = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    limit.ok_or_else(|| format!("`{text}` is no time limit; write seconds such as 30 or 0.5, at most {MOST}"))
}

/// Runs the command.
pub fn run(mut args: Args, tool: &Tool) -> exit::Outcome {
    child::end_with_parent();
    set_threads(args.threads)?;
    args.recall()?;
    if let (Some(folder), Some(n)) = (&args.resume, args.shrink)
        && RunDir::open(folder).is_ok_and(|run| run.is_complete())
    {
        // All that was left of it is to shrink.
        interrupt::listen();
        let run = exit::open(folder)?;
        let end = super::shrink::first_of_each_class(tool, folder, n, args.selector.cache.as_deref(), &args.programs)?;
        return Ok(if end == exit::OK { exit::of_rows(run.outcome, &run.summary) } else { end });
    }
    let Held { expected, digest } = expectations::held(tool, args.expected.as_ref())?;
    let Job { selection, mut scenes, backends, engines, permutations, mut ledger } = match (&args.resume, &args.plan) {
        (Some(folder), _) => Job::resume(&args, tool, folder, &digest)?,
        (None, Some(file)) => Job::planned(&args, tool, file, &digest)?,
        (None, None) => Job::new(&args, tool, &digest)?,
    };
    let (programs, _) = args.programs.clone().and_named(&args.backends)?;
    interrupt::listen();
    let work: u64 = scenes.iter().map(|scene| scene.plan.queries * (backends.len() as u64 + 1)).sum();
    let bar = progress::bar(work, "answers");
    let told = |done: u64| bar.inc(done);
    let by_level = budget(selection.level);
    let budget =
        Budget { permutations: permutations.unwrap_or(by_level.permutations), answers: ledger.answers, ..by_level };
    // What ran out of time before it was resumed has.
    let mut ended = later(records::Outcome::Complete, &ledger.done);
    // Each scene is dropped before the next.
    'scenes: for planned in &mut scenes {
        let scene = planned.plan.clone();
        let left: Vec<&dyn Contestant> =
            backends.iter().map(AsRef::as_ref).filter(|backend| !ledger.is_done(&scene, &backend.name())).collect();
        if left.is_empty() && ledger.is_planned(&scene) {
            bar.inc(scene.queries * (backends.len() as u64 + 1));
            continue;
        }
        bar.set_message(scene.scene.clone());
        let clock = Stopwatch::start();
        let loaded = planned.take(&selection)?;
        ledger.plan(&scene, &loaded)?;
        if left.is_empty() {
            bar.inc(scene.queries * (backends.len() as u64 + 1));
            continue;
        }
        let task = tool.task(loaded.task);
        let limit = args.limit(selection.level);
        let worker = Worker {
            permutations,
            threads: args.threads,
            cache: args.selector.cache.as_deref(),
            folder: worker::folder(&ledger.folder),
            suite: selection.argument(&planned.def),
            engines: &engines,
            scene: &scene,
            limit,
            level: selection.level,
            answers: ledger.answers,
        };
        let (apart, here): (Vec<&dyn Contestant>, Vec<_>) =
            left.iter().partition(|backend| args.isolates(tool, &backend.name(), task));
        let watch = Watch::new(interrupt::flag(), None, &told);
        let case = (!here.is_empty()).then(|| task.case(&loaded, &watch)).transpose();
        let Ok(case) = case else {
            ended = records::Outcome::Interrupted;
            break 'scenes;
        };
        ledger.cost(&scene, CostRow::TRUTH, clock.read())?;
        if let Some(dispute) = case.as_ref().and_then(|case| case.dispute()) {
            let message =
                format!("{}/{}: {dispute}; fix the data before anything is compared", scene.suite, scene.scene);
            return Err(Failure { message, code: exit::CORPUS });
        }
        let judge = |case: &dyn AnyCase, backend: &dyn Contestant| {
            predicament_oracle::run(case, backend, budget, &watch.restarted(args.timeout))
        };
        // Small scenes leave threads idle, so backends share them; what a crash can lose is one such scene. Time limits
        // are for a backend by itself.
        let mut side_by_side = case
            .as_deref()
            .filter(|_| selection.level == Level::Quick && args.timeout.is_none())
            .map(|case| together(&here, |backend| judge(case, backend)).into_iter());
        for backend in left {
            let Some(case) = case.as_deref().filter(|_| apart.iter().all(|other| other.name() != backend.name()))
            else {
                let clock = Stopwatch::start();
                let Some(found) = worker.run(tool, &backend.name())? else {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                };
                ledger.cost(&scene, &backend.name(), clock.read().of_another())?;
                ended = later(ended, &found.summary);
                ledger.adopt(found, &scene, &backend.name(), &expected)?;
                bar.inc(scene.queries);
                continue;
            };
            // The pictures of pixel maps go with their rows; every other scene has none.
            if loaded.family == "pixel-map" {
                ledger.draw(case, backend)?;
            }
            let (outcome, cost) = match &mut side_by_side {
                Some(outcomes) => outcomes.next().expect("one for each backend"),
                None => {
                    let clock = Stopwatch::start();
                    let outcome = judge(case, backend);
                    (outcome, clock.read())
                }
            };
            match outcome {
                Err(Stop::Interrupted | Stop::Timeout) => {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                }
                Ok(outcome) => {
                    let cost = if backend.name().starts_with(PREFIX) { cost.of_another() } else { cost };
                    ledger.cost(&scene, &backend.name(), cost)?;
                    let summary = ledger.record(&scene, &backend.name(), &outcome, &expected)?;
                    ended = later(ended, std::slice::from_ref(&summary));
                }
            }
        }
    }
    bar.finish_and_clear();
    let folder = ledger.folder.clone();
    let code = ledger.finish(ended)?;
    match args.shrink {
        Some(n) if ended != records::Outcome::Interrupted => {
            let end = super::shrink::first_of_each_class(tool, &folder, n, args.selector.cache.as_deref(), &programs)?;
            Ok(if end == exit::OK { code } else { end })
        }
        _ => Ok(code),
    }
}

/// Does the same for each backend at once. Threads work for one or another as they are free, so of what all have cost together each has the
/// share that its own clock says.
fn together<T: Send>(backends: &[&dyn Contestant], each: impl Fn(&dyn Contestant) -> T + Sync) -> Vec<(T, Cost)> {
    let clock = Stopwatch::start();
    let timed = |backend: &&dyn Contestant| {
        let start = Instant::now();
        let done = each(*backend);
        (done, start.elapsed())
    };
    let done: Vec<(T, Duration)> = backends.par_iter().map(timed).collect();
    let (cost, whole) = (clock.read(), done.iter().map(|(_, time)| *time).sum());
    done.into_iter().map(|(done, time)| (done, cost.share(time, whole))).collect()
}

/// How the run has ended so far, with these rows.
fn later(ended: records::Outcome, rows: &[SummaryRow]) -> records::Outcome {
    let timed_out = rows.iter().any(|row| row.count(Class::Timeout) > 0);
    if timed_out && ended == records::Outcome::Complete { records::Outcome::Timeout } else { ended }
}

/// More threads than any machine has cores.
const MOST_THREADS: usize = 4096;

/// Sizes the thread pool.
pub fn set_threads(threads: Option<usize>) -> Result<(), Failure> {
    if let Some(threads) = threads.filter(|threads| !(1..=MOST_THREADS).contains(threads)) {
        return Err(Failure::usage(format!("--threads: {threads} threads; choose from 1 to {MOST_THREADS}")));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build_global()
        .map_err(|error| Failure::usage(format!("--threads: {error}")))
}

/// A run under way.
struct Job {
    selection: Selection,
    scenes: Vec<Planned>,
    backends: Vec<Box<dyn Contestant>>,
    /// The files of engines, by the backends' names.
    engines: BTreeMap<String, String>,
    /// How much is spent on other orders of arguments, where it was named.
    permutations: Option<usize>,
    ledger: Ledger,
}

impl Job {
    /// What the command line selects.
    fn new(args: &Args, tool: &Tool, expected: &str) -> Result<Job, Failure> {
        let backends = tool.pick(&args.backends)?;
        let selection = args.selector.select(tool)?;
        let shard = args.shard.unwrap_or(Shard::WHOLE);
        let (scenes, whole) = selection.part(shard)?;
        let plan = Plan {
            answers: args.answers,
            permutations: args.permutations.map(|most| most as u64),
            engines: recorded(&args.backends, &backends)?,
            left_out: tool.left_out(&args.backends),
            expected: args.expected.as_deref().map(expectations::file).transpose()?,
            whole: whole.map(|whole| Whole { expected: Some(expected.to_owned()), ..whole }),
            ..plan(tool, &selection, &scenes, &backends, shard)
        };
        let picked = Picked { backends, files: engines(&args.backends)? };
        let job = Job::start(args, tool, (selection, scenes, picked), plan, None)?;
        tell_not_selected(&job.selection.not_selected, "run");
        Ok(job)
    }

    /// What a plan of work says, or a part of it.
    fn planned(args: &Args, tool: &Tool, file: &Path, expected: &str) -> Result<Job, Failure> {
        let work = WorkPlan::read(file).map_err(Failure::usage)?;
        let refuse = |why: String| Failure::usage(format!("{}: {why}", file.display()));
        let build = Build::of(&env());
        if work.build != build {
            let (planned, this) = (work.build.describe(), build.describe());
            return Err(refuse(format!("it was made by another build of the tool, {planned}; this is {this}")));
        }
        if work.expected != expected {
            return Err(refuse(
                "it was made for other expectations; give the same --expected, or make it anew".to_owned(),
            ));
        }
        let named = args.expected.as_deref().map(expectations::file).transpose()?;
        let plan = Plan { expected: named, ..work.part(args.shard).map_err(refuse)? };
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { suites: suites_of(file, &plan), level, ..args.selector.clone() };
        let selection = selector.select(tool)?;
        let scenes = selection.of_plan(&plan.scenes, |scene, of| {
            refuse(format!(
                "scene {}/{}{of} has changed since the plan was made, or is gone; make the plan anew",
                scene.suite, scene.scene
            ))
        })?;
        if let Some((suite, _)) = plan.hashes.iter().find(|(suite, hash)| selection.hashes().get(*suite) != Some(hash))
        {
            let of = selection.of_file(suite);
            return Err(refuse(format!("the suite `{suite}`{of} has changed since; make the plan anew")));
        }
        let recorded = Recorded { file, folder: None, engines: &plan.engines };
        let picked = args.programs.pick(tool, &plan.backends, recorded)?;
        Job::start(args, tool, (selection, scenes, picked), plan, Some(work.hash))
    }

    /// Makes the folder.
    fn start(
        args: &Args,
        tool: &Tool,
        (selection, scenes, picked): (Selection, Vec<Planned>, Picked),
        plan: Plan,
        work: Option<String>,
    ) -> Result<Job, Failure> {
        let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-run"));
        let Picked { backends, files: engines } = picked;
        let env = Env { plan: work, ..env_of(&backends) };
        let writer = RunWriter::create(&folder, &plan, &env, &tables_of(tool, &plan)).map_err(Failure::usage)?;
        let (level, answers, permutations) = (selection.level, plan.answers, permutations(&plan));
        let (done, precision, wholes) = (Vec::new(), Vec::new(), BTreeMap::new());
        let (places, left_out) = (places(&plan), plan.left_out);
        let ledger = Ledger { level, answers, wholes, done, precision, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, permutations, ledger })
    }

    /// What is left of a run that has not come to its end.
    fn resume(args: &Args, tool: &Tool, folder: &PathBuf, expected: &str) -> Result<Job, Failure> {
        let plan = &RunDir::plan(folder).map_err(Failure::usage)?;
        if plan.timed {
            let message = format!(
                "{}: a bench can't be resumed, as its times belong together; start a new one",
                folder.display()
            );
            return Err(Failure::usage(message));
        }
        if plan.whole.as_ref().and_then(|whole| whole.expected.as_ref()).is_some_and(|hash| hash != expected) {
            let message =
                "it was begun with other expectations, and its rows would not agree; give the same --expected";
            return Err(Failure::usage(format!("{}: {message}", folder.display())));
        }
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { level, ..args.selector.clone() };
        let selector = if selector.suites.is_empty() {
            Selector { suites: suites_of(folder, plan), ..selector }
        } else {
            selector
        };
        let selection = selector.select(tool)?;
        let recorded = Recorded { file: &folder.join("plan.json"), folder: Some(folder), engines: &plan.engines };
        let Picked { backends, files: engines } = args.programs.pick(tool, &plan.backends, recorded)?;
        // The filter of the first call isn't needed: the plan lists its scenes.
        let scenes = selection.of_plan(&plan.scenes, |lost, of| {
            Failure::usage(format!(
                "{}: scene {}/{}{of} has changed since the run was planned, or is gone; start a new run",
                folder.join("plan.json").display(),
                lost.suite,
                lost.scene
            ))
        })?;
        let permutations = args.permutations.or(permutations(plan));
        let (answers, left_out, places) = (plan.answers, plan.left_out.clone(), places(plan));
        same_versions(folder, &backends)?;
        let (writer, before) =
            RunWriter::resume(folder, || env_of(&backends), &tables_of(tool, plan)).map_err(Failure::usage)?;
        // What a run that was killed has left of its workers.
        worker::clear(folder);
        let RunDir { summary, precision, .. } = before;
        let (done, precision) = (summary.into(), precision.into());
        let (folder, wholes, level) = (folder.clone(), BTreeMap::new(), selection.level);
        let ledger = Ledger { level, answers, wholes, done, precision, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, permutations, ledger })
    }
}

/// How much a plan spends on other orders of arguments, where it says so.
fn permutations(plan: &Plan) -> Option<usize> {
    plan.permutations.map(|most| usize::try_from(most).unwrap_or(usize::MAX))
}

/// The places of a part's scenes in the whole.
fn places(plan: &Plan) -> BTreeMap<PlannedScene, u64> {
    let places = plan.whole.iter().flat_map(|whole| whole.places.iter().copied());
    plan.scenes.iter().cloned().zip(places).collect()
}

/// Says in one line which suites are not run (or the like): how many, where they were not asked for.
pub fn tell_not_selected(suites: &[NotSelected], done: &str) {
    let unnamed = suites.iter().filter(|suite| suite.reason == NOT_NAMED).count();
    let unfetched: Vec<&str> =
        suites.iter().filter(|suite| suite.reason != NOT_NAMED).map(|suite| suite.suite.as_str()).collect();
    match (unnamed, unfetched.join(", ")) {
        (0, unfetched) if unfetched.is_empty() => {}
        (0, unfetched) => {
            note!("not {done}: {unfetched}: `{} corpus fetch` gets their data, then name them", program())
        }
        (unnamed, _) => {
            note!("{unnamed} suites were {NOT_NAMED} and are not {done}; `{} corpus list` has them", program())
        }
    }
}
