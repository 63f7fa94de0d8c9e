//! `bench`: throughput, next to the errors of the same answers.
//!
//! The answers of every backend are judged first, here or in an earlier run (`--judged`); the bench folder's
//! `summary.csv` keeps the judgement. Then the backends take turns, sample by sample, so that noise of the machine
//! affects all of them. Each timed pass has to give the judged answers; otherwise it is not a measurement. Sampling of
//! a backend stops when its median is known well enough. After that, `timing/phases.rs` times the parts of some
//! algorithms one by one.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Duration;

use predicament_corpus::LoadedScene;
use predicament_oracle::expect::Expectations;
use predicament_records::{self as records, Plan, PlannedScene, RunDir, RunWriter, Shard};
use predicament_tasks::{AnyCase, AnyTask, Contestant, Watch};

use crate::exit::{self, Failure};
use crate::judged::Judged;
use crate::planning::{budget, env_of, free_folder, plan};
use crate::programs::recorded;
use crate::select::{Planned, Selection, Selector};
use crate::shared::seconds;
use crate::timing::{Limit, Runner, Samples, empty, phases, sample, start};
use crate::tool::Tool;
use crate::{expectations, interrupt, progress, rows};

const EXAMPLES: &str = "\
Examples:
  predicament bench                                     all embedded corpora
  predicament bench --judged predicament-run-1          the scenes and backends of a run, and what it has judged
  predicament bench --judged predicament-run-1 --seconds 30    a sample of its families
  predicament bench families -f orient2d --samples 21 --precision 0.01
  predicament bench families -b exact,shewchuk,engine:robust,engine:simplicity    beside other crates, as engines
  predicament bench contact-sizes --level full --samples 3 --threads 8 -b exact,sos,tolerance,tolerance:f32,naive
  predicament bench mesh-sizes --level full --samples 3 --threads 2 -b exact    points in meshes, phase by phase: phases.csv";

/// Time backends against each other on judged answers
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; default: all, or those of --judged
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Maximum number of samples of each backend
    #[arg(long, value_name = "N", default_value_t = 11)]
    pub samples: u64,

    /// Stop sampling a backend when the 95 % confidence interval of its median (by order statistics) is within this
    /// fraction of it; 0 takes all samples
    #[arg(long, value_name = "FRACTION", default_value_t = 0.05, value_parser = fraction)]
    pub precision: f64,

    /// Use the judgements of this run instead of judging again; the scenes, level and backends (except engines) default
    /// to those of the run
    #[arg(long, value_name = "RUN")]
    pub judged: Option<PathBuf>,

    /// Also time contacts, points in meshes and intersections of meshes on this number of threads; everything is timed
    /// on one thread
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,

    /// Time a sample of the families that takes about this many seconds; the costs of scenes come from the judged run
    #[arg(long, value_name = "SECONDS", value_parser = seconds, requires = "judged")]
    pub seconds: Option<Duration>,

    /// Minimum milliseconds of a sample; passes are repeated to reach it
    #[arg(long, value_name = "MS", default_value_t = 2)]
    pub sample_ms: u64,

    /// A new folder; default: the first free predicament-bench-N
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Parses a precision of the median: a fraction from 0, less than 1.
fn fraction(text: &str) -> Result<f64, String> {
    let precision = text.parse().ok().filter(|precision| (0.0..1.0).contains(precision));
    precision.ok_or_else(|| {
        format!("`{text}` is not a precision; write a fraction such as 0.05 for 5 %, or 0 for all samples")
    })
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    if args.samples == 0 {
        return Err(Failure::usage("--samples: at least one sample is needed"));
    }
    let expected = expectations::load(tool, None)?;
    let judged = args.judged.as_deref().map(Judged::read).transpose()?;
    let (selection, mut scenes) = match &judged {
        None => {
            let selection = args.selector.select(tool)?;
            let scenes = selection.plan()?;
            (selection, scenes)
        }
        Some(judged) => judged.select(&args.selector, tool)?,
    };
    let mut remarks = Vec::new();
    let names = match &judged {
        Some(judged) if args.backends.is_empty() => judged.backends(&mut remarks),
        _ => args.backends.clone(),
    };
    let backends = tool.pick(&names)?;
    if let (Some(time), Some(run)) = (args.seconds, &args.judged) {
        let names: Vec<String> = backends.iter().map(|backend| backend.name()).collect();
        let limit = Limit { time, run, backends: &names, sample_ms: args.sample_ms };
        let (chosen, line) = sample(scenes, &limit)?;
        scenes = chosen;
        note!("{line}");
        remarks.push(line);
    }
    let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-bench"));
    let plan = Plan {
        timed: true,
        engines: recorded(&names, &backends)?,
        ..plan(tool, &selection, &scenes, &backends, Shard::WHOLE)
    };
    let writer =
        RunWriter::create(&folder, &plan, &env_of(&backends), &phases::tables(tool)).map_err(Failure::usage)?;
    // A pass over a large scene does not check the interrupt flag.
    interrupt::listen_for(Duration::from_secs(3));
    let bar = progress::bar(scenes.len() as u64, "scenes");
    let timed = scenes.len();
    let bindings: Vec<(String, Box<dyn Contestant>)> =
        backends.iter().filter_map(|backend| Some((backend.name(), backend.binding()?))).collect();
    let mut bench = Bench {
        tool,
        selection: &selection,
        backends: &backends,
        bindings: &bindings,
        judged: judged.as_ref(),
        expected: &expected,
        threads: std::iter::once(1).chain(args.threads.map(usize::from).filter(|&threads| threads > 1)).collect(),
        samples: Samples {
            most: args.samples,
            least: Duration::from_millis(args.sample_ms),
            precision: args.precision,
        },
        writer,
        remarks,
        taken_over: 0,
        primitives: BTreeMap::new(),
    };
    let mut ended = records::Outcome::Complete;
    for planned in &mut scenes {
        bar.set_message(planned.plan.scene.clone());
        if bench.scene(planned)?.is_break() {
            ended = records::Outcome::Interrupted;
            break;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let Bench { writer, remarks, taken_over, primitives, threads, .. } = bench;
    writer.finish(ended).map_err(Failure::usage)?;
    say!("{}: {timed} scenes timed, {}", folder.display(), ended.describe());
    if let Some(judged) = &judged {
        say!("  {}", judged.told(taken_over));
    }
    for line in &remarks {
        say!("  {line}");
    }
    let run = RunDir::open(&folder).map_err(Failure::usage)?;
    for task in tool.tasks() {
        say_text!("{}", task.timed_in(&run, &primitives, &threads).map_err(Failure::usage)?);
    }
    Ok(if ended == records::Outcome::Complete { exit::OK } else { exit::INCOMPLETE })
}

/// A bench in progress.
struct Bench<'b> {
    tool: &'b Tool,
    selection: &'b Selection,
    backends: &'b [Box<dyn Contestant>],
    /// The call overhead of predicates of programs in other languages, by backend name.
    bindings: &'b [(String, Box<dyn Contestant>)],
    /// The judgements of an earlier run.
    judged: Option<&'b Judged>,
    expected: &'b Expectations,
    /// The numbers of threads that are timed.
    threads: Vec<usize>,
    samples: Samples,
    writer: RunWriter,
    remarks: Vec<String>,
    /// The number of judgements taken from the earlier run.
    taken_over: usize,
    /// The number of primitives of each scene that has some, by scene id.
    primitives: BTreeMap<String, u64>,
}

/// A scene, and its truth once a backend's answers have to be judged.
struct Truth<'s> {
    task: &'static dyn AnyTask,
    loaded: &'s LoadedScene,
    case: Option<Box<dyn AnyCase + 's>>,
}

impl Truth<'_> {
    /// The scene with its truth, or `None` if interrupted.
    fn known(&mut self, watch: &Watch<'_>) -> Option<&dyn AnyCase> {
        if self.case.is_none() {
            self.case = self.task.case(self.loaded, watch).ok();
        }
        self.case.as_deref()
    }
}

impl Bench<'_> {
    /// Judges and times one scene.
    fn scene(&mut self, planned: &mut Planned) -> Result<ControlFlow<()>, Failure> {
        const STOPPED: Result<ControlFlow<()>, Failure> = Ok(ControlFlow::Break(()));
        let scene = planned.plan.clone();
        let loaded = planned.take(self.selection)?;
        self.writer.write(rows::imported(&scene, &loaded.notes).as_slice()).map_err(Failure::usage)?;
        let task = self.tool.task(loaded.task);
        self.primitives.extend(task.primitives_of(&loaded).map(|count| (loaded.id.clone(), count)));
        let quiet = |_: u64| {};
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let mut truth = Truth { task, loaded: &loaded, case: None };
        let mut runners = Vec::new();
        for backend in self.backends.iter().map(AsRef::as_ref) {
            let Some(digest) = self.judge(&scene, &mut truth, backend, &watch)? else { return STOPPED };
            runners.extend(self.started(&scene, &loaded, backend, digest));
        }
        let Bench { samples, threads, writer, remarks, .. } = self;
        let is_done = samples.take(&scene, &mut runners, writer, remarks)?
            && phases::take(samples, &scene, (&loaded, task), (&mut runners, threads), writer, remarks)?;
        if !is_done {
            return STOPPED;
        }
        self.writer.commit_if_due().map_err(Failure::usage)?;
        Ok(ControlFlow::Continue(()))
    }

    /// Judges a backend, or takes its judgement from an earlier run, and returns the digest of its answers, if it has
    /// any. The outer `None` means interrupted.
    fn judge(
        &mut self,
        scene: &PlannedScene,
        truth: &mut Truth<'_>,
        backend: &dyn Contestant,
        watch: &Watch<'_>,
    ) -> Result<Option<Option<u64>>, Failure> {
        let name = backend.name();
        if let Some(before) = self.judged.and_then(|judged| judged.of(scene, &name)) {
            self.taken_over += 1;
            self.writer.write(std::slice::from_ref(before.summary)).map_err(Failure::usage)?;
            self.writer.write(&before.findings).map_err(Failure::usage)?;
            return Ok(Some(before.digest));
        }
        let level = self.selection.level;
        let Some(case) = truth.known(watch) else { return Ok(None) };
        if let Some(dispute) = case.dispute() {
            let message = format!("{}/{}: {dispute}", case.loaded().suite, case.loaded().name);
            return Err(Failure { message, code: exit::CORPUS });
        }
        let Ok(outcome) = predicament_oracle::run(case, backend, budget(level), watch) else { return Ok(None) };
        rows::record(&mut self.writer, scene, &name, &outcome, self.expected, level.name()).map_err(Failure::usage)?;
        Ok(Some(outcome.digest))
    }

    /// Runners of a backend that are ready to be timed, and of its binding, if it has one, as a row of its own.
    fn started<'s>(
        &mut self,
        scene: &PlannedScene,
        loaded: &'s LoadedScene,
        backend: &'s dyn Contestant,
        digest: Option<u64>,
    ) -> Vec<Runner<'s>>
    where
        Self: 's,
    {
        let name = backend.name();
        let is_threaded = self.tool.task(loaded.task).is_threaded();
        let threads = if is_threaded { &self.threads[..] } else { &self.threads[..1] };
        let mut all = vec![(name.clone(), start(loaded, backend, scene, digest, threads))];
        let bindings: &'s [(String, Box<dyn Contestant>)] = self.bindings;
        if let Some((_, binding)) = bindings.iter().find(|(of, _)| *of == name && digest.is_some()) {
            all.push((binding.name(), empty(loaded, binding.as_ref(), scene, &self.threads[..1])));
        }
        let mut runners = Vec::new();
        for (name, started) in all {
            match started {
                Ok(started) => runners.extend(started),
                Err(why) => self.remarks.push(format!("not timed: {}/{} on {name}: {why}", scene.suite, scene.scene)),
            }
        }
        runners
    }
}
