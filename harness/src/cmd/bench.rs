//! `bench`: throughput, beside the errors of the very same answers.
//!
//! Every backend's answers are judged first, here or in an earlier run
//! (`--judged`), and that judgement is kept in the bench folder's
//! `summary.csv`. Then the backends take turns, sample by sample, so that a
//! noisy machine is noisy for all of them; each timed pass has to give the
//! answers that were judged, or it is not a measurement. A backend is done when
//! its median is known well enough. The parts of some algorithms are timed one by one after that: see `phases.rs`.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use predicament_corpus::LoadedScene;
use predicament_oracle::caught;
use predicament_records::{self as records, Interface, Plan, PlannedScene, RunWriter, Shard, ThroughputRow};
use predicament_tasks::contacts::Complexes;
use predicament_tasks::mesh_intersect::TwoMeshes;
use predicament_tasks::mesh_locate::ProbedMesh;
use predicament_tasks::{AnyCase, Contestant, Stop, Stopwatch, Watch};

use crate::contact_tables::{self, Primitives, on_threads};
use crate::exit::{self, Failure};
use crate::judged::Judged;
use crate::planning::{budget, env_of, free_folder, plan};
use crate::programs::recorded;
use crate::select::Selector;
use crate::tool::Tool;
use crate::{expectations, interrupt, peers, phases, progress, rows};

const EXAMPLES: &str = "\
Examples:
  predicament bench                                     all embedded corpora
  predicament bench --judged predicament-run-1          the scenes and backends of a run, and what it has judged
  predicament bench families -f orient2d --samples 21 --precision 0.01
  predicament bench families -b exact,sos,naive         built with `--features peers`, other crates take part
  predicament bench maps -f 10m -b exact,sos,naive      the same with maps, against `geo`
  predicament bench contact-sizes --level full --samples 3 --threads 8 -b exact,sos,tolerance,tolerance:f32,naive
  predicament bench mesh-sizes --level full --samples 3 --threads 2 -b exact    points in meshes, phase by phase: phases.csv";

/// Time backends against each other on judged answers
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; all if left out, or those of --judged
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Samples of each backend, at most
    #[arg(long, value_name = "N", default_value_t = 11)]
    pub samples: u64,

    /// Stop sampling a backend when its median is known to this fraction (the
    /// 95 % confidence interval of the median, by order statistics); 0 takes all samples
    #[arg(long, value_name = "FRACTION", default_value_t = 0.05, value_parser = fraction)]
    pub precision: f64,

    /// A run whose judgements are taken over: answers are not judged again, only compared with those that were. Without suites its scenes
    /// are timed, at its level, and without -b on its backends, but for engines
    #[arg(long, value_name = "RUN")]
    pub judged: Option<PathBuf>,

    /// Time contacts, points in meshes and intersections of meshes on so many threads too; everything is timed on one
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,

    /// Milliseconds that a sample takes at least, by repeating passes
    #[arg(long, value_name = "MS", default_value_t = 2)]
    pub sample_ms: u64,

    /// A new folder; the first free predicament-bench-N if left out
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// How well a median has to be known: a part of it, from 0 on and below 1.
fn fraction(text: &str) -> Result<f64, String> {
    let precision = text.parse().ok().filter(|precision| (0.0..1.0).contains(precision));
    precision
        .ok_or_else(|| format!("`{text}` is no precision; write a fraction such as 0.05 for 5 %, or 0 for all samples"))
}

/// One backend at its starting line.
pub struct Runner<'a> {
    /// The backend's name.
    pub name: String,
    family: String,
    version: String,
    /// How it is asked.
    interface: Interface,
    /// The threads that it uses.
    pub threads: usize,
    /// Its passes.
    pub watch: Box<dyn Stopwatch + 'a>,
    judged: u64,
    queries: u64,
    passes: u32,
    /// Nanoseconds per query of each sample.
    samples: Vec<f64>,
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
    let mut taken_over = 0;
    let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-bench"));
    let plan = Plan {
        timed: true,
        engines: recorded(&names, &backends)?,
        ..plan(tool, &selection, &scenes, &backends, Shard::WHOLE)
    };
    let mut writer =
        RunWriter::create(&folder, &plan, &env_of(&backends), &phases::tables(tool)).map_err(Failure::usage)?;
    // A pass over a large scene looks at no flag.
    interrupt::listen_for(Duration::from_secs(3));
    let bar = progress::bar(scenes.len() as u64, "scenes");
    let quiet = |_: u64| {};
    let watch = Watch::new(interrupt::flag(), None, &quiet);
    let mut ended = records::Outcome::Complete;
    let mut primitives = Primitives::default();
    let mut threads = vec![1];
    threads.extend(args.threads.map(usize::from).filter(|&threads| threads > 1));
    let timed = scenes.len();
    let bindings: Vec<(String, Box<dyn Contestant>)> =
        backends.iter().filter_map(|backend| Some((backend.name(), backend.binding()?))).collect();
    'scenes: for planned in &mut scenes {
        let scene = planned.plan.clone();
        bar.set_message(scene.scene.clone());
        let loaded = planned.take(&selection)?;
        primitives.learn(&loaded);
        writer.write(rows::imported(&scene, &loaded.notes).as_slice()).map_err(Failure::usage)?;
        // The truth is worked out only where somebody's answers have not been judged.
        let mut case: Option<Box<dyn AnyCase + '_>> = None;
        let mut runners = Vec::new();
        let task = tool.task(loaded.task);
        for backend in &backends {
            let name = backend.name();
            let digest = if let Some(before) = judged.as_ref().and_then(|judged| judged.of(&scene, &name)) {
                taken_over += 1;
                writer.write(std::slice::from_ref(before.summary)).map_err(Failure::usage)?;
                writer.write(&before.findings).map_err(Failure::usage)?;
                before.digest
            } else {
                if case.is_none() {
                    case = task.case(&loaded, &watch).ok();
                }
                let Some(case) = &case else {
                    ended = records::Outcome::Interrupted;
                    break 'scenes;
                };
                let budget = budget(selection.level);
                let outcome = match predicament_oracle::run(case.as_ref(), backend.as_ref(), budget, &watch) {
                    Ok(outcome) => outcome,
                    Err(Stop::Interrupted | Stop::Timeout) => {
                        ended = records::Outcome::Interrupted;
                        break 'scenes;
                    }
                };
                let level = selection.level.name();
                rows::record(&mut writer, &scene, &name, &outcome, &expected, level).map_err(Failure::usage)?;
                outcome.digest
            };
            match start(&loaded, backend.as_ref(), &scene, digest, &threads) {
                Ok(started) => runners.extend(started),
                Err(why) => remarks.push(format!("not timed: {}/{} on {name}: {why}", scene.suite, scene.scene)),
            }
            // What it costs to reach a predicate of another language, as a row of its own.
            if let Some(binding) = bindings.iter().find(|(of, _)| *of == name).map(|(_, binding)| binding)
                && digest.is_some()
            {
                match empty(&loaded, binding.as_ref(), &scene, &threads[..1]) {
                    Ok(started) => runners.extend(started),
                    Err(why) => {
                        remarks.push(format!(
                            "not timed: {}/{} on {}: {why}",
                            scene.suite,
                            scene.scene,
                            binding.name()
                        ));
                    }
                }
            }
        }
        if peers::ANY {
            if case.is_none() {
                case = task.case(&loaded, &watch).ok();
            }
            for peer in case.iter().flat_map(|case| peers::runners(case.as_ref())) {
                let level = selection.level.name();
                rows::record(&mut writer, &scene, &peer.name, &peer.outcome, &expected, level)
                    .map_err(Failure::usage)?;
                remarks.extend(peer.remarks.iter().map(|remark| format!("{}/{}: {remark}", scene.suite, scene.scene)));
                if let Some(timed) = peer.timed {
                    runners.push(Runner {
                        name: peer.name,
                        family: scene.family.clone(),
                        version: peer.version,
                        interface: timed.interface,
                        threads: 1,
                        watch: timed.watch,
                        judged: timed.judged,
                        queries: peer.outcome.queries,
                        passes: 1,
                        samples: Vec::new(),
                    });
                }
            }
        }
        let samples =
            Samples { most: args.samples, least: Duration::from_millis(args.sample_ms), precision: args.precision };
        let is_done = samples.take(&scene, &mut runners, &mut writer, &mut remarks)?
            && phases::take(&samples, &scene, (&loaded, task), (&mut runners, &threads), &mut writer, &mut remarks)?;
        if !is_done {
            ended = records::Outcome::Interrupted;
            break;
        }
        writer.commit_if_due().map_err(Failure::usage)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    writer.finish(ended).map_err(Failure::usage)?;
    say!("{}: {timed} scenes timed, {}", folder.display(), ended.describe());
    if let Some(judged) = &judged {
        say!("  {}", judged.told(taken_over));
    }
    for line in &remarks {
        say!("  {line}");
    }
    say_text!("{}", contact_tables::tables(&folder, &primitives, &threads).map_err(Failure::usage)?);
    say_text!("{}", peers::tables(&folder).map_err(Failure::usage)?);
    Ok(if ended == records::Outcome::Complete { exit::OK } else { exit::INCOMPLETE })
}

/// Prepares one backend by each interface: contacts and meshes with points or other meshes for each number of threads, all else for one.
fn start<'a>(
    loaded: &'a LoadedScene,
    backend: &'a dyn Contestant,
    scene: &PlannedScene,
    judged: Option<u64>,
    threads: &[usize],
) -> Result<Vec<Runner<'a>>, String> {
    let judged = judged.ok_or("there are no judged answers")?;
    let solver = backend.solver(loaded.task).ok_or("the backend was not told of the task")?;
    let is_parallel = loaded.content::<Complexes>().is_some()
        || loaded.content::<ProbedMesh>().is_some()
        || loaded.content::<TwoMeshes>().is_some();
    let threads = if is_parallel { threads } else { &threads[..1] };
    let content = loaded.content.as_ref();
    let mut runners = Vec::new();
    for &threads in threads {
        for interface in solver.interfaces(content) {
            let prepared = caught(|| solver.stopwatch(&loaded.scene, content, threads, interface));
            let Some(watch) = prepared.map_err(|broken| broken.to_string()).flatten()? else { continue };
            runners.push(Runner {
                name: backend.name(),
                family: on_threads(&scene.family, threads),
                version: backend.version().unwrap_or_else(|| env!("CARGO_PKG_VERSION").to_owned()),
                watch,
                interface,
                threads,
                judged,
                queries: scene.queries,
                passes: 1,
                samples: Vec::new(),
            });
        }
    }
    Ok(runners)
}

/// Prepares predicates that return at once: what they answer is not judged, only that it stays the same.
fn empty<'a>(
    loaded: &'a LoadedScene,
    binding: &'a dyn Contestant,
    scene: &PlannedScene,
    threads: &[usize],
) -> Result<Vec<Runner<'a>>, String> {
    let mut runners = start(loaded, binding, scene, Some(0), threads)?;
    for runner in &mut runners {
        caught(|| runner.watch.pass()).map_err(|broken| broken.to_string())?;
        runner.judged = runner.watch.digest();
    }
    Ok(runners)
}

/// How samples are taken.
pub struct Samples {
    /// How many, at most.
    pub most: u64,
    /// What a sample takes, at least.
    pub least: Duration,
    precision: f64,
}

/// How many times longer than it lasts a sample may take.
const PATIENCE: u128 = 10;

/// Samples before the first look at the confidence interval: the smallest and the
/// largest of six enclose the median with 97 %.
const FIRST_LOOK: usize = 6;

impl Samples {
    /// Times the runners in turns. False if interrupted.
    fn take(
        &self,
        scene: &PlannedScene,
        runners: &mut Vec<Runner>,
        writer: &mut RunWriter,
        remarks: &mut Vec<String>,
    ) -> Result<bool, Failure> {
        // A pass to warm up, to size the samples, and to see that the answers are the judged ones.
        runners.retain_mut(|runner| {
            let warm = caught(|| {
                runner.watch.pass();
                let start = Instant::now();
                let pass = runner.watch.pass().max(Duration::from_nanos(1));
                (pass, start.elapsed().max(Duration::from_nanos(1)))
            });
            let (pass, wall) = match warm {
                Ok(warm) => warm,
                Err(broken) => {
                    remarks.push(format!("not timed: {}/{} on {}: {broken}", scene.suite, scene.scene, runner.name));
                    return false;
                }
            };
            // By a clock of its own a pass can be much shorter than we wait for it.
            let passes =
                (self.least.as_nanos() / pass.as_nanos()).min(PATIENCE * self.least.as_nanos() / wall.as_nanos());
            runner.passes = u32::try_from(passes + 1).unwrap_or(u32::MAX);
            let same = runner.watch.digest() == runner.judged;
            if !same {
                remarks.push(format!(
                    "not timed: {}/{} on {}: the timed answers are not the judged ones",
                    scene.suite, scene.scene, runner.name
                ));
            }
            same
        });
        for sample in 0..self.most {
            let mut rows = Vec::with_capacity(runners.len());
            let mut broken = Vec::new();
            for (at, runner) in runners.iter_mut().enumerate().filter(|(_, runner)| !self.is_known(&runner.samples)) {
                if interrupt::flag().load(std::sync::atomic::Ordering::Relaxed) {
                    return Ok(false);
                }
                let total = match caught(|| runner.watch.passes(runner.passes)) {
                    Ok(total) => total,
                    Err(why) => {
                        let (suite, scene, name) = (&scene.suite, &scene.scene, &runner.name);
                        remarks.push(format!("timed {sample} times only: {suite}/{scene} on {name}: {why}"));
                        broken.push(at);
                        continue;
                    }
                };
                // Counts of queries and passes are far below 2^53: no rounding.
                #[allow(clippy::cast_precision_loss)]
                let queries = runner.queries as f64 * f64::from(runner.passes);
                // A clock that has not moved says that it was less than its step.
                let ns_per_query = total.max(Duration::from_nanos(1)).as_secs_f64() * 1e9 / queries;
                runner.samples.push(ns_per_query);
                rows.push(ThroughputRow {
                    task: scene.task.clone(),
                    family: runner.family.clone(),
                    backend: runner.name.clone(),
                    interface: runner.interface,
                    engine_version: runner.version.clone(),
                    queries: runner.queries,
                    sample,
                    ns_per_query,
                });
            }
            writer.write(&rows).map_err(Failure::usage)?;
            for at in broken.into_iter().rev() {
                runners.remove(at);
            }
        }
        if let Some(runner) = runners.iter().find(|runner| runner.watch.digest() != runner.judged) {
            let message = format!("{}/{} on {}: answers changed while timed", scene.suite, scene.scene, runner.name);
            return Err(Failure { message, code: exit::UNEXPECTED });
        }
        Ok(true)
    }

    /// Whether the median is known well enough.
    pub fn is_known(&self, samples: &[f64]) -> bool {
        interval(samples).is_some_and(|[low, high]| high - low <= self.precision * (low + high))
    }
}

/// A confidence interval of the median, of at least 95 %: between two order
/// statistics, so that it needs no distribution. None for fewer than six samples.
fn interval(samples: &[f64]) -> Option<[f64; 2]> {
    let n = samples.len();
    if n < FIRST_LOOK {
        return None;
    }
    let mut sorted = samples.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    // The share of outcomes of n fair coins with at most `below` heads, doubled, is what the interval misses.
    let mut below = 0;
    let (mut term, mut tail) = (0.5_f64.powi(i32::try_from(n).unwrap_or(i32::MAX)), 0.0);
    while below < n / 2 {
        tail += term;
        if 2.0 * tail > 0.05 {
            break;
        }
        below += 1;
        // Counts of samples: exact as doubles.
        #[allow(clippy::cast_precision_loss)]
        let next = (n - below + 1) as f64 / below as f64;
        term *= next;
    }
    let at = below.checked_sub(1)?;
    Some([sorted[at], sorted[n - 1 - at]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_that_of_the_binomial_distribution() {
        let samples = |n: u32| (1..=n).rev().map(f64::from).collect::<Vec<_>>();
        assert_eq!(interval(&samples(5)), None);
        // The tables of order statistics: 1 and 6 of 6 (96.9 %), 2 and 10 of 11 (98.8 %), 6 and 15 of 20 (95.9 %).
        assert_eq!(interval(&samples(6)), Some([1.0, 6.0]));
        assert_eq!(interval(&samples(11)), Some([2.0, 10.0]));
        assert_eq!(interval(&samples(20)), Some([6.0, 15.0]));
    }

    #[test]
    fn sampling_stops_when_the_median_is_known() {
        let samples = Samples { most: 11, least: Duration::ZERO, precision: 0.05 };
        assert!(samples.is_known(&[1.0, 1.01, 0.99, 1.0, 1.02, 1.0]));
        assert!(!samples.is_known(&[1.0, 1.01, 0.99, 1.0, 1.02]), "too few to know");
        assert!(!samples.is_known(&[1.0, 1.2, 0.99, 1.0, 1.02, 1.0]), "too far apart");
        assert!(!Samples { precision: 0.0, ..samples }.is_known(&[1.0, 1.0, 1.0, 1.0, 1.0, 1.01]));
    }
}
