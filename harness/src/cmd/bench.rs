//! `bench`: throughput, beside the errors of the very same answers.
//!
//! Every backend's answers are judged first, and that judgement is kept in the
//! bench folder's `summary.csv`. Then the backends take turns, sample by
//! sample, so that a noisy machine is noisy for all of them; each timed pass
//! has to give the answers that were judged, or it is not a measurement.

use std::path::PathBuf;
use std::time::Duration;

use predicament_oracle::{Case, Contestant, Stopwatch, Truth, Watch, digest_of};
use predicament_oracle::{contacts, cubes, interval, locate};
use predicament_report::{self as report, PlannedScene, RunWriter, Shard, ThroughputRow};

use crate::cmd::run::{budget, env, free_folder, plan};
use crate::contact_tables::{self, Primitives, on_threads};
use crate::exit::{self, Failure};
use crate::select::Selector;
use crate::{expectations, interrupt, peers, progress, roster, rows};

const EXAMPLES: &str = "\
Examples:
  predicament bench                                     all embedded corpora
  predicament bench families -f orient2d --samples 21
  predicament bench families -b exact,sos,naive         built with `--features peers`, other crates take part
  predicament bench maps -f 10m -b exact,sos,naive      the same with maps, against `geo`
  predicament bench contact-sizes --level full --samples 3 --threads 8 -b exact,sos,tolerance,tolerance:f32,naive";

/// Time backends against each other on judged answers
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; all if left out
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Samples of each backend
    #[arg(long, value_name = "N", default_value_t = 11)]
    pub samples: u64,

    /// Time contacts on so many threads too; everything is timed on one
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,

    /// Milliseconds that a sample takes at least, by repeating passes
    #[arg(long, value_name = "MS", default_value_t = 4)]
    pub sample_ms: u64,

    /// A new folder; the first free predicament-bench-N if left out
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// One backend at its starting line.
struct Runner<'a> {
    name: String,
    family: String,
    version: String,
    watch: Box<dyn Stopwatch + 'a>,
    judged: u64,
    queries: u64,
    passes: u32,
}

/// Runs the command.
pub fn run(args: Args) -> exit::Outcome {
    if args.samples == 0 {
        return Err(Failure::usage("--samples: at least one sample is needed"));
    }
    let expected = expectations::load(None)?;
    let backends = roster::pick(&args.backends)?;
    let selection = args.selector.select()?;
    let scenes = selection.plan(Shard::WHOLE)?;
    let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-bench"));
    let plan = plan(&selection, &scenes, &backends, Shard::WHOLE);
    let mut writer = RunWriter::create(&folder, &plan, &env()).map_err(Failure::usage)?;
    interrupt::listen();
    let bar = progress::bar(scenes.len() as u64 * args.samples, "rounds");
    let quiet = |_: u64| {};
    let watch = Watch::new(interrupt::flag(), None, &quiet);
    let mut ended = report::Outcome::Complete;
    let mut remarks = Vec::new();
    let mut primitives = Primitives::default();
    let mut threads = vec![1];
    threads.extend(args.threads.map(usize::from).filter(|&threads| threads > 1));
    'scenes: for (def, scene) in &scenes {
        bar.set_message(scene.scene.clone());
        let loaded = selection.load(def)?;
        let Ok(case) = Case::new(&loaded, &watch) else {
            ended = report::Outcome::Interrupted;
            break;
        };
        primitives.learn(scene, &case);
        let mut runners = Vec::new();
        for backend in &backends {
            let Ok(outcome) = case.run(backend.as_ref(), budget(selection.level), &watch) else {
                ended = report::Outcome::Interrupted;
                break 'scenes;
            };
            let row = rows::summary(scene, &backend.name(), &outcome, &expected, selection.level.name());
            writer.write(&[row]).map_err(Failure::usage)?;
            writer.write(&rows::findings(scene, &backend.name(), &outcome)).map_err(Failure::usage)?;
            writer.write(&rows::contacts(scene, &backend.name(), &outcome)).map_err(Failure::usage)?;
            match start(&case, backend.as_ref(), scene, &threads) {
                Ok(started) => runners.extend(started),
                Err(why) => {
                    remarks.push(format!("not timed: {}/{} on {}: {why}", scene.suite, scene.scene, backend.name()))
                }
            }
        }
        for peer in peers::runners(&case) {
            let row = rows::summary(scene, &peer.name, &peer.outcome, &expected, selection.level.name());
            writer.write(&[row]).map_err(Failure::usage)?;
            writer.write(&rows::findings(scene, &peer.name, &peer.outcome)).map_err(Failure::usage)?;
            remarks.extend(peer.remarks.iter().map(|remark| format!("{}/{}: {remark}", scene.suite, scene.scene)));
            if let Some(timed) = peer.timed {
                let (queries, judged) = (peer.outcome.queries, timed.judged);
                let (name, version, watch) = (peer.name, peer.version, timed.watch);
                let family = scene.family.clone();
                runners.push(Runner { name, family, version, watch, judged, queries, passes: 1 });
            }
        }
        let samples = Samples { count: args.samples, least: Duration::from_millis(args.sample_ms) };
        if !samples.take(scene, runners, &mut writer, &mut remarks, || bar.inc(1))? {
            ended = report::Outcome::Interrupted;
            break;
        }
        writer.commit().map_err(Failure::usage)?;
    }
    bar.finish_and_clear();
    writer.finish(ended).map_err(Failure::usage)?;
    println!("{}: {} scenes timed, {}", folder.display(), scenes.len(), ended.describe());
    for line in &remarks {
        println!("  {line}");
    }
    print!("{}", contact_tables::tables(&folder, &primitives, &threads).map_err(Failure::usage)?);
    print!("{}", peers::tables(&folder).map_err(Failure::usage)?);
    Ok(if ended == report::Outcome::Complete { exit::OK } else { exit::INCOMPLETE })
}

/// Prepares one backend, with the digest of its judged answers: contacts for each number of threads.
fn start<'a>(
    case: &'a Case<'a>,
    backend: &'a dyn Contestant,
    scene: &PlannedScene,
    threads: &[usize],
) -> Result<Vec<Runner<'a>>, String> {
    let runner = |watch, judged, threads| Runner {
        name: backend.name(),
        family: on_threads(&scene.family, threads),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        watch,
        judged,
        queries: scene.queries,
        passes: 1,
    };
    Ok(match case.truth() {
        Truth::Signs { queries, .. } => {
            let scene = &case.loaded().scene;
            let answers = backend.answers(scene, queries)?;
            vec![runner(backend.time_signs(scene, queries)?, digest_of(&answers), 1)]
        }
        Truth::Contacts(case) => {
            let judged = contacts::digest_of(&backend.contacts(case.scene(), case.complexes())?);
            let start = |&threads: &usize| Ok(runner(backend.time_contacts(case, threads)?, judged, threads));
            threads.iter().map(start).collect::<Result<_, String>>()?
        }
        Truth::Interval(case) => {
            vec![runner(backend.time_interval(case)?, interval::digest_of(&backend.cells(case)?), 1)]
        }
        Truth::Cubes(case) => {
            vec![runner(backend.time_cubes(case)?, cubes::digest_of(&backend.cube_union(case)?), 1)]
        }
        Truth::Locate(case) => {
            vec![runner(backend.time_locate(case)?, locate::digest_of(&backend.locations(case)?), 1)]
        }
    })
}

struct Samples {
    count: u64,
    least: Duration,
}

impl Samples {
    /// Times the runners in turns. False if interrupted.
    fn take(
        &self,
        scene: &PlannedScene,
        mut runners: Vec<Runner>,
        writer: &mut RunWriter,
        remarks: &mut Vec<String>,
        tick: impl Fn(),
    ) -> Result<bool, Failure> {
        // A pass to warm up, to size the samples, and to see that the answers are the judged ones.
        runners.retain_mut(|runner| {
            runner.watch.pass();
            let pass = runner.watch.pass().max(Duration::from_nanos(1));
            runner.passes = u32::try_from(self.least.as_nanos() / pass.as_nanos() + 1).unwrap_or(u32::MAX);
            let same = runner.watch.digest() == runner.judged;
            if !same {
                remarks.push(format!(
                    "not timed: {}/{} on {}: the timed answers are not the judged ones",
                    scene.suite, scene.scene, runner.name
                ));
            }
            same
        });
        for sample in 0..self.count {
            if interrupt::flag().load(std::sync::atomic::Ordering::Relaxed) {
                return Ok(false);
            }
            let mut rows = Vec::with_capacity(runners.len());
            for runner in &mut runners {
                let total: Duration = (0..runner.passes).map(|_| runner.watch.pass()).sum();
                // Counts of queries and passes are far below 2^53: no rounding.
                #[allow(clippy::cast_precision_loss)]
                let queries = runner.queries as f64 * f64::from(runner.passes);
                rows.push(ThroughputRow {
                    task: scene.task.clone(),
                    family: runner.family.clone(),
                    backend: runner.name.clone(),
                    engine_version: runner.version.clone(),
                    queries: runner.queries,
                    sample,
                    ns_per_query: total.as_secs_f64() * 1e9 / queries,
                });
            }
            writer.write(&rows).map_err(Failure::usage)?;
            tick();
        }
        if let Some(runner) = runners.iter().find(|runner| runner.watch.digest() != runner.judged) {
            let message = format!("{}/{} on {}: answers changed while timed", scene.suite, scene.scene, runner.name);
            return Err(Failure { message, code: exit::UNEXPECTED });
        }
        Ok(true)
    }
}
