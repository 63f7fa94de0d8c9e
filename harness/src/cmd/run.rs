//! `run`: every selected scene through every backend, each answer judged.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Duration;

use predicament_corpus::Level;
use predicament_records::{self as records, NotSelected, Plan, PlannedScene, RunDir, RunWriter, Shard, SummaryRow};
use predicament_tasks::{AnyCase, AnyTask, Budget, Class, Contestant, Stop, Watch};
use rayon::prelude::*;

use crate::exit::{self, Failure};
use crate::ledger::Ledger;
use crate::out::program;
use crate::planning::{budget, env_of, free_folder, plan, tables_of};
use crate::select::{NOT_NAMED, Planned, Selection, Selector};
use crate::tool::{Tool, engines};
use crate::worker::Worker;
use crate::{child, expectations, interrupt, progress};

pub const EXAMPLES: &str = "\
Examples:
  predicament run                                   all embedded corpora, all backends
  predicament run classics -b exact,sos,naive       one suite, three backends
  predicament run families -f 'near.*orient3d' --level full
  predicament run mine.toml --expected mine-expected.toml --out out/mine
  predicament run --shard 2/4 --out out/part2       a quarter of the work; `merge` puts the parts together
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

    /// Part k of n, by scene id
    #[arg(long, value_name = "k/n", default_value = "1/1")]
    pub shard: Shard,

    /// Threads; all cores if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// A new folder for the run; the first free predicament-run-N if left out
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Go on with an incomplete run; takes its selection from that run's plan
    #[arg(long, value_name = "DIR", conflicts_with_all = ["out", "shard", "backends", "answers", "filter", "level"])]
    pub resume: Option<PathBuf>,

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
    /// one row; `auto` does so for backends that are not built in, and for algorithms on whole scenes under --timeout
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
    /// Backends that are not built in, and algorithms on whole scenes under a time limit.
    Auto,
    /// All.
    Always,
    /// None.
    Never,
}

/// The folder of a worker's files, in that of the run.
const WORKER: &str = "worker";

/// The time limit of a scene in a process of its own at level quick, where none is given.
const PATIENCE: Duration = Duration::from_secs(600);

impl Args {
    /// Whether this backend runs a scene of this task in a process of its own. (An engine is one already.)
    fn isolates(&self, tool: &Tool, backend: &str, task: &dyn AnyTask) -> bool {
        match self.isolate {
            Isolate::Auto => tool.is_foreign(backend) || (self.timeout.is_some() && !task.looks_at_the_watch()),
            Isolate::Always => true,
            Isolate::Never => false,
        }
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
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    child::end_with_parent();
    set_threads(args.threads)?;
    let expected = expectations::load(tool, args.expected.as_ref())?;
    let Job { selection, mut scenes, backends, engines, mut ledger } = match &args.resume {
        None => Job::new(&args, tool)?,
        Some(folder) => Job::resume(&args, tool, folder)?,
    };
    interrupt::listen();
    let work: u64 = scenes.iter().map(|scene| scene.plan.queries * (backends.len() as u64 + 1)).sum();
    let bar = progress::bar(work, "answers");
    let told = |done: u64| bar.inc(done);
    let by_level = budget(selection.level);
    let permutations = args.permutations.unwrap_or(by_level.permutations);
    let budget = Budget { permutations, answers: ledger.answers, ..by_level };
    let mut ended = records::Outcome::Complete;
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
        let loaded = planned.take(&selection)?;
        ledger.plan(&scene, &loaded)?;
        if left.is_empty() {
            bar.inc(scene.queries * (backends.len() as u64 + 1));
            continue;
        }
        let task = tool.task(loaded.task);
        let limit = args.limit(selection.level);
        let worker = Worker {
            permutations: args.permutations,
            threads: args.threads,
            cache: args.selector.cache.as_deref(),
            folder: ledger.folder.join(WORKER),
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
            .map(|case| here.par_iter().map(|backend| judge(case, *backend)).collect::<Vec<_>>().into_iter());
        for backend in left {
            let Some(case) = case.as_deref().filter(|_| apart.iter().all(|other| other.name() != backend.name()))
            else {
                let Some(found) = worker.run(tool, &backend.name())? else {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                };
                ended = later(ended, &found.summary);
                ledger.adopt(found, &scene, &backend.name(), &expected)?;
                bar.inc(scene.queries);
                continue;
            };
            // The pictures of pixel maps go with their rows; every other scene has none.
            if loaded.family == "pixel-map" {
                ledger.draw(case, backend)?;
            }
            let outcome = match &mut side_by_side {
                Some(outcomes) => outcomes.next().expect("one for each backend"),
                None => judge(case, backend),
            };
            match outcome {
                Err(Stop::Interrupted | Stop::Timeout) => {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                }
                Ok(outcome) => {
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
            let end = super::shrink::first_of_each_class(tool, &folder, n, args.selector.cache.as_deref())?;
            Ok(if end == exit::OK { code } else { end })
        }
        _ => Ok(code),
    }
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
    ledger: Ledger,
}

impl Job {
    fn new(args: &Args, tool: &Tool) -> Result<Job, Failure> {
        let backends = tool.pick(&args.backends)?;
        let selection = args.selector.select(tool)?;
        let (scenes, whole) = selection.part(args.shard)?;
        let engines = engines(&args.backends)?;
        let plan = Plan {
            answers: args.answers,
            engines: engines.clone(),
            left_out: tool.left_out(&args.backends),
            whole,
            ..plan(&selection, &scenes, &backends, args.shard)
        };
        let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-run"));
        let writer =
            RunWriter::create(&folder, &plan, &env_of(&backends), &tables_of(tool, &plan)).map_err(Failure::usage)?;
        tell_not_selected(&selection.not_selected, "run");
        let (level, answers) = (selection.level, args.answers);
        let (done, precision, wholes) = (Vec::new(), Vec::new(), BTreeMap::new());
        let (places, left_out) = (places(&plan), plan.left_out);
        let ledger = Ledger { level, answers, wholes, done, precision, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, ledger })
    }

    fn resume(args: &Args, tool: &Tool, folder: &PathBuf) -> Result<Job, Failure> {
        let before = RunDir::open(folder).map_err(Failure::usage)?;
        let plan = &before.plan;
        if plan.timed {
            let message = format!(
                "{}: a bench can't be resumed, as its times belong together; start a new one",
                folder.display()
            );
            return Err(Failure::usage(message));
        }
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { level, ..args.selector.clone() };
        let selector =
            if selector.suites.is_empty() { Selector { suites: plan.arguments(), ..selector } } else { selector };
        let selection = selector.select(tool)?;
        let (backends, engines) = (tool.pick_planned(plan)?, plan.engines.clone());
        // The filter of the first call isn't needed: the plan lists its scenes.
        let (mut scenes, _) = selection.part(plan.shard)?;
        scenes.retain(|scene| plan.scenes.contains(&scene.plan));
        if let Some(lost) = plan.scenes.iter().find(|planned| scenes.iter().all(|scene| scene.plan != **planned)) {
            return Err(Failure::usage(format!(
                "{}: scene {}/{} has changed since the run was planned; start a new run",
                folder.display(),
                lost.suite,
                lost.scene
            )));
        }
        let (answers, left_out, places) = (plan.answers, plan.left_out.clone(), places(plan));
        let (writer, before) = RunWriter::resume(folder, &tables_of(tool, plan)).map_err(Failure::usage)?;
        // What a run that was killed has left of its worker.
        let _ = std::fs::remove_dir_all(folder.join(WORKER));
        let RunDir { summary, precision, .. } = before;
        let (done, precision) = (summary.into(), precision.into());
        let (folder, wholes) = (folder.clone(), BTreeMap::new());
        let ledger = Ledger { level, answers, wholes, done, precision, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, ledger })
    }
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
