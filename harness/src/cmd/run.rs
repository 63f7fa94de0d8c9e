//! `run`: every selected scene through every backend, each answer judged.

use std::path::PathBuf;
use std::time::Duration;

use predicament_corpus::{Level, LoadedScene};
use predicament_exact::{Exact, Precision};
use predicament_oracle::expect::Expectations;
use predicament_predicates::Backend;
use predicament_records::{
    self as records, Env, ImportRow, NotSelected, Plan, PlannedScene, PrecisionRow, RunDir, RunWriter, SampledRow,
    Shard, Status, SummaryRow, TableSpec,
};
use predicament_tasks::{AnyCase, Budget, Class, Contestant, Outcome, Stop, Watch};
use rayon::prelude::*;

use crate::cmd::map;
use crate::exit::{self, Failure};
use crate::judged::JudgedRow;
use crate::out::program;
use crate::select::{NOT_NAMED, Planned, Selection, Selector};
use crate::tool::Tool;
use crate::worker::Worker;
use crate::{expectations, interrupt, progress, rows};

pub const EXAMPLES: &str = "\
Examples:
  predicament run                                   all embedded corpora, all backends
  predicament run classics -b exact,sos,naive       one suite, three backends
  predicament run families -f 'near.*orient3d' --level full
  predicament run mine.toml --expected mine-expected.toml --out out/mine
  predicament run --shard 2/4 --out out/part2       a quarter of the work
  predicament run --resume out/part2                go on where it stopped";

/// Run scenes through backends and judge every answer
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; all if left out
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
    #[arg(long, value_name = "DIR", conflicts_with_all = ["out", "shard", "backends"])]
    pub resume: Option<PathBuf>,

    /// Expected disagreements; those of the embedded corpora if left out
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// Evaluations that one backend spends on other orders of the arguments in
    /// one scene, 0 for none; 5,000 for quick and 24 million for full if left out
    #[arg(long, value_name = "N")]
    pub permutations: Option<usize>,

    /// Seconds that one backend may take for one scene; algorithms on whole scenes run in a
    /// process of their own then, which is ended
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub timeout: Option<Duration>,
}

/// A time limit: a positive number of seconds.
fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().filter(|&seconds: &f64| seconds > 0.0);
    let limit = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    limit.ok_or_else(|| format!("`{text}` is no time; write seconds such as 30 or 0.5"))
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    set_threads(args.threads)?;
    let expected = expectations::load(tool, args.expected.as_ref())?;
    let Job { selection, mut scenes, backends, mut ledger } = match &args.resume {
        None => Job::new(&args, tool)?,
        Some(folder) => Job::resume(&args, tool, folder)?,
    };
    interrupt::listen();
    let work: u64 = scenes.iter().map(|scene| scene.plan.queries * (backends.len() as u64 + 1)).sum();
    let bar = progress::bar(work, "answers");
    let told = |done: u64| bar.inc(done);
    let by_level = budget(selection.level);
    let budget = Budget { permutations: args.permutations.unwrap_or(by_level.permutations), ..by_level };
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
        if let Some(limit) = args.timeout.filter(|_| !task.looks_at_the_watch()) {
            let worker = Worker { args: &args, suite: selection.argument(&planned.def), scene: &scene, limit };
            for backend in left {
                let Some(found) = worker.run(tool, &backend.name())? else {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                };
                ended = later(ended, &found.summary);
                ledger.adopt(found, &scene, &backend.name(), &expected)?;
            }
            continue;
        }
        let watch = Watch::new(interrupt::flag(), None, &told);
        let Ok(case) = task.case(&loaded, &watch) else {
            ended = records::Outcome::Interrupted;
            break 'scenes;
        };
        if let Some(dispute) = case.dispute() {
            let message =
                format!("{}/{}: {dispute}; fix the data before anything is compared", scene.suite, scene.scene);
            return Err(Failure { message, code: exit::CORPUS });
        }
        let judge = |backend: &&dyn Contestant| {
            predicament_oracle::run(case.as_ref(), *backend, budget, &watch.restarted(args.timeout))
        };
        // Small scenes leave threads idle, so backends share them; what a crash can lose is one such scene. Time limits
        // are for a backend by itself.
        let mut side_by_side = (selection.level == Level::Quick && args.timeout.is_none())
            .then(|| left.par_iter().map(judge).collect::<Vec<_>>().into_iter());
        for backend in left {
            // The pictures of pixel maps go with their rows; every other scene has none.
            if loaded.family == "pixel-map" {
                ledger.draw(case.as_ref(), backend)?;
            }
            let outcome = match &mut side_by_side {
                Some(outcomes) => outcomes.next().expect("one for each backend"),
                None => judge(&backend),
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
    ledger.finish(ended)
}

/// How the run has ended so far, with these rows.
fn later(ended: records::Outcome, rows: &[SummaryRow]) -> records::Outcome {
    let timed_out = rows.iter().any(|row| row.count(Class::Timeout) > 0);
    if timed_out && ended == records::Outcome::Complete { records::Outcome::Timeout } else { ended }
}

/// Sizes the thread pool.
pub fn set_threads(threads: Option<usize>) -> Result<(), Failure> {
    if threads == Some(0) {
        return Err(Failure::usage("--threads: at least one thread is needed"));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build_global()
        .map_err(|error| Failure::usage(format!("--threads: {error}")))
}

/// How much is sampled at a level.
pub fn budget(level: Level) -> Budget {
    match level {
        Level::Quick => Budget::QUICK,
        Level::Full => Budget::FULL,
    }
}

/// A run under way.
struct Job {
    selection: Selection,
    scenes: Vec<Planned>,
    backends: Vec<Box<dyn Contestant>>,
    ledger: Ledger,
}

/// What is done, in memory and on disk.
struct Ledger {
    level: Level,
    done: Vec<SummaryRow>,
    precision: Vec<PrecisionRow>,
    folder: PathBuf,
    writer: RunWriter,
}

impl Job {
    fn new(args: &Args, tool: &Tool) -> Result<Job, Failure> {
        let backends = tool.pick(&args.backends)?;
        let selection = args.selector.select(tool)?;
        let scenes = selection.plan(args.shard)?;
        let plan = plan(&selection, &scenes, &backends, args.shard);
        let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-run"));
        let writer = RunWriter::create(&folder, &plan, &env(), &tables(tool)).map_err(Failure::usage)?;
        tell_not_selected(&selection.not_selected);
        let ledger = Ledger { level: selection.level, done: Vec::new(), precision: Vec::new(), folder, writer };
        Ok(Job { selection, scenes, backends, ledger })
    }

    fn resume(args: &Args, tool: &Tool, folder: &PathBuf) -> Result<Job, Failure> {
        let before = RunDir::open(folder).map_err(Failure::usage)?;
        let plan = &before.plan;
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { level, ..args.selector.clone() };
        let selector =
            if selector.suites.is_empty() { Selector { suites: plan.arguments(), ..selector } } else { selector };
        let selection = selector.select(tool)?;
        let backends = tool.pick(&plan.backends)?;
        // The filter of the first call isn't needed: the plan lists its scenes.
        let mut scenes = selection.plan(plan.shard)?;
        scenes.retain(|scene| plan.scenes.contains(&scene.plan));
        if let Some(lost) = plan.scenes.iter().find(|planned| scenes.iter().all(|scene| scene.plan != **planned)) {
            return Err(Failure::usage(format!(
                "{}: scene {}/{} has changed since the run was planned; start a new run",
                folder.display(),
                lost.suite,
                lost.scene
            )));
        }
        let (writer, before) = RunWriter::resume(folder, &tables(tool)).map_err(Failure::usage)?;
        let ledger =
            Ledger { level, done: before.summary, precision: before.precision, folder: folder.clone(), writer };
        Ok(Job { selection, scenes, backends, ledger })
    }
}

/// Names the suites that are not run: those that were not asked for in one line.
fn tell_not_selected(suites: &[NotSelected]) {
    let (unnamed, others): (Vec<_>, Vec<_>) = suites.iter().partition(|suite| suite.reason == NOT_NAMED);
    for left in others {
        eprintln!("{}: suite `{}` is not run: {}", program(), left.suite, left.reason);
    }
    if !unnamed.is_empty() {
        let names: Vec<&str> = unnamed.iter().map(|suite| suite.suite.as_str()).collect();
        eprintln!("{}: not run, as {NOT_NAMED}: {}", program(), names.join(", "));
    }
}

/// The tables of a run folder besides those of every run.
pub fn tables(tool: &Tool) -> Vec<TableSpec> {
    let mut tables = tool.tables();
    tables.extend([TableSpec::of::<JudgedRow>(), TableSpec::of::<SampledRow>(), TableSpec::of::<ImportRow>()]);
    tables
}

impl Ledger {
    fn is_done(&self, scene: &PlannedScene, backend: &str) -> bool {
        self.done.iter().any(|row| row.suite == scene.suite && row.scene == scene.scene && row.backend == backend)
    }

    /// Whether the scene's precision plan is written down: a run folder may be older than that table.
    fn is_planned(&self, scene: &PlannedScene) -> bool {
        self.precision.iter().any(|row| row.suite == scene.suite && row.scene == scene.scene)
    }

    /// Writes the scene's precision plan and what reading it has changed, once; the next commit makes it permanent.
    fn plan(&mut self, scene: &PlannedScene, loaded: &LoadedScene) -> Result<(), Failure> {
        if !self.is_planned(scene) {
            let row = rows::precision(scene, &Precision::of(&loaded.scene));
            self.writer.write(std::slice::from_ref(&row)).map_err(Failure::usage)?;
            self.writer.write(rows::imported(scene, &loaded.notes).as_slice()).map_err(Failure::usage)?;
            self.precision.push(row);
        }
        Ok(())
    }

    fn record(
        &mut self,
        scene: &PlannedScene,
        backend: &str,
        outcome: &Outcome,
        expected: &Expectations,
    ) -> Result<SummaryRow, Failure> {
        let level = self.level.name();
        let summary =
            rows::record(&mut self.writer, scene, backend, outcome, expected, level).map_err(Failure::usage)?;
        self.writer.commit().map_err(Failure::usage)?;
        self.done.push(summary.clone());
        Ok(summary)
    }

    /// Takes the rows that a worker has left.
    fn adopt(
        &mut self,
        found: crate::worker::Found,
        scene: &PlannedScene,
        backend: &str,
        expected: &Expectations,
    ) -> Result<(), Failure> {
        let mut summary = found.summary;
        for row in &mut summary {
            row.status = rows::status(scene, backend, row, expected, self.level.name());
        }
        let writer = &mut self.writer;
        writer.write(&summary).map_err(Failure::usage)?;
        writer.write(&found.findings).map_err(Failure::usage)?;
        writer.write(&found.stages).map_err(Failure::usage)?;
        writer.append(&found.more).map_err(Failure::usage)?;
        writer.commit().map_err(Failure::usage)?;
        self.done.extend(summary);
        Ok(())
    }

    fn draw(&self, case: &dyn AnyCase, backend: &dyn Contestant) -> Result<(), Failure> {
        // A backend that declines or panics has a row that says so, and no picture.
        let tile = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| map::tile(case, backend)));
        let Ok(Ok(tile)) = tile else { return Ok(()) };
        let png = tile.map.to_png(1).map_err(Failure::usage)?;
        let name = format!("{} {}", case.loaded().name, backend.name()).replace(':', "-");
        self.writer.add_map(&name, &png).map_err(Failure::usage)
    }

    fn finish(self, ended: records::Outcome) -> exit::Outcome {
        self.writer.finish(ended).map_err(Failure::usage)?;
        let count = |status: Status| self.done.iter().filter(|row| row.status == status).count();
        let (unexpected, passes) = (count(Status::Unexpected), count(Status::UnexpectedPass));
        let queries: u64 = self.done.iter().map(|row| row.queries).sum();
        say!(
            "{}: {queries} answers judged; rows: {} ok, {} expected, {unexpected} unexpected, \
             {passes} unexpected pass; {}",
            self.folder.display(),
            count(Status::Ok),
            count(Status::Expected),
            ended.describe(),
        );
        for row in self.done.iter().filter(|row| !row.status.passes()) {
            say!("  {}", describe(row));
        }
        Ok(if ended != records::Outcome::Complete {
            exit::INCOMPLETE
        } else if unexpected > 0 {
            exit::UNEXPECTED
        } else if passes > 0 {
            exit::UNEXPECTED_PASS
        } else {
            exit::OK
        })
    }
}

/// A summary row in words.
pub fn describe(row: &SummaryRow) -> String {
    let classes: Vec<String> = Class::ALL
        .into_iter()
        .filter(|&class| row.count(class) > 0)
        .map(|class| format!("{} {}", row.count(class), class.name()))
        .collect();
    format!("{}: {}/{} on {}: {}", row.status.name(), row.suite, row.scene, row.backend, classes.join(", "))
}

/// The plan of a run over these scenes.
pub fn plan(selection: &Selection, scenes: &[Planned], backends: &[Box<dyn Contestant>], shard: Shard) -> Plan {
    Plan {
        format: records::FORMAT,
        created_by: format!("predicament {}", env!("CARGO_PKG_VERSION")),
        level: match selection.level {
            Level::Quick => records::Level::Quick,
            Level::Full => records::Level::Full,
        },
        suites: selection.suites.iter().map(|suite| suite.name.clone()).collect(),
        paths: selection.paths(),
        scenes: scenes.iter().map(|scene| scene.plan.clone()).collect(),
        backends: backends.iter().map(|backend| backend.name()).collect(),
        ladder: Exact.stages().iter().map(|&stage| stage.to_owned()).collect(),
        shard,
        not_selected: selection.not_selected.clone(),
        findings_per_class: budget(selection.level).findings_per_class as u64,
    }
}

/// The machine, the compiler and the peers.
pub fn env() -> Env {
    let mut env = Env::collect(env!("CARGO_PKG_VERSION"));
    env.rustc = Some(env!("PREDICAMENT_RUSTC").to_owned());
    env.peers.insert("robust".to_owned(), env!("PREDICAMENT_ROBUST").to_owned());
    env.peers.extend(crate::peers::VERSIONS.iter().map(|&(peer, version)| (peer.to_owned(), version.to_owned())));
    env
}

/// `stem-1`, or the first number that is free.
pub fn free_folder(stem: &str) -> PathBuf {
    let mut names = (1..).map(|n| PathBuf::from(format!("{stem}-{n}")));
    names.find(|path| !path.exists()).expect("some number is free")
}
