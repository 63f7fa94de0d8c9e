//! `run`: runs every selected scene through every backend and judges each answer.

mod job;
mod scenes;

use std::path::{Path, PathBuf};
use std::time::Duration;

use predicament_corpus::Level;
use predicament_engines::PREFIX;
use predicament_records::{RunDir, Shard};
use predicament_tasks::AnyTask;

use crate::exit::{self, Failure};
use crate::expectations::Held;
use crate::programs::Programs;
use crate::select::Selector;
use crate::shared::{seconds, set_threads};
use crate::shrinking::first_of_each_class;
use crate::tool::Tool;
use crate::{child, expectations, interrupt};
use job::Job;

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

    /// Backends, several with commas or by repeating; default: those that run by default (the last lines of output list
    /// the others)
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Part k of n, by scene id or as the plan divides the scenes; default: all of it
    #[arg(long, value_name = "k/n")]
    pub shard: Option<Shard>,

    /// Run a file written by `plan`, or the part of it that --shard names
    #[arg(long, value_name = "FILE", conflicts_with_all = ["suites", "filter", "level", "backends", "answers", "permutations"])]
    pub plan: Option<PathBuf>,

    /// The number of threads; default: all cores
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// A new folder for the run; default: the first free predicament-run-N
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Continue an incomplete run; the selection comes from that run's plan
    #[arg(long, value_name = "DIR", conflicts_with_all = ["out", "plan", "shard", "backends", "answers", "filter", "level", "permutations"])]
    pub resume: Option<PathBuf>,

    #[command(flatten)]
    pub programs: Programs,

    /// The file of expected disagreements; default: those of the embedded corpora
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// Evaluations per backend and scene on other orders of the arguments, 0 for none; default: 5,000 for quick and 24
    /// million for full
    #[arg(long, value_name = "N")]
    pub permutations: Option<usize>,

    /// Write every answer to answers.csv; scenes whose answer is one whole are only counted
    #[arg(long)]
    pub answers: bool,

    /// The time limit in seconds of one backend on one scene, such as 30 or 0.5; the scene runs in a separate process,
    /// which is ended then (default at level quick: 10 minutes)
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub timeout: Option<Duration>,

    /// Run each scene and backend in a separate process, so that a loop, a crash or a lack of memory costs one row;
    /// `auto` does so for backends that are not built in and, with --timeout, for engines and for algorithms on whole
    /// scenes
    #[arg(long, value_name = "WHEN", value_enum, default_value_t = Isolate::Auto, num_args = 0..=1,
          default_missing_value = "always", require_equals = false)]
    pub isolate: Isolate,

    /// Shrink the first N findings of each class when the run is complete, unexpected ones first, into `shrunk` in its
    /// folder
    #[arg(long, value_name = "N")]
    pub shrink: Option<usize>,
}

/// The scenes and backends that run in a separate process.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Isolate {
    /// Backends that are not built in; with a time limit, also engines and algorithms on whole scenes.
    Auto,
    /// All scenes and backends.
    Always,
    /// No scene and no backend.
    Never,
}

/// The default time limit of a scene in a separate process at level quick.
const PATIENCE: Duration = Duration::from_secs(600);

impl Args {
    /// True if this backend runs a scene of this task in a separate process. (An engine already is a separate process,
    /// but this process waits for it.)
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

    /// Takes the settings that rows depend on, but the selection does not include, from the plan of a resumed run.
    fn recall(&mut self) -> Result<(), Failure> {
        let Some(folder) = &self.resume else { return Ok(()) };
        let plan = RunDir::plan(folder).map_err(Failure::usage)?;
        let no_count = |_| Failure::usage(format!("{}: the number of permutations is too large", folder.display()));
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

    /// The time limit of a separate process.
    fn limit(&self, level: Level) -> Option<Duration> {
        self.timeout.or((level == Level::Quick).then_some(PATIENCE))
    }
}

/// Runs the command.
pub fn run(mut args: Args, tool: &Tool) -> exit::Outcome {
    child::end_with_parent();
    set_threads(args.threads)?;
    args.recall()?;
    let (programs, _) = args.programs.clone().and_named(&args.backends)?;
    if let Some(folder) = &args.resume
        && args.shrink.is_some()
        && RunDir::open(folder).is_ok_and(|run| run.is_complete())
    {
        // The run is complete; only shrinking remains.
        interrupt::listen();
        let run = exit::open(folder)?;
        return shrunk(&args, tool, folder, &programs, exit::of_rows(run.outcome, &run.summary));
    }
    let Held { expected, digest } = expectations::held(tool, args.expected.as_ref())?;
    let job = Job::of(&args, tool, &digest)?;
    interrupt::listen();
    let ended = scenes::all(&args, tool, job, &expected)?;
    if ended.is_interrupted { Ok(ended.code) } else { shrunk(&args, tool, &ended.folder, &programs, ended.code) }
}

/// Shrinks findings if the command line asks for it; returns the run's exit code if no finding remains to be shrunk.
fn shrunk(args: &Args, tool: &Tool, folder: &Path, programs: &Programs, code: u8) -> exit::Outcome {
    let Some(n) = args.shrink else { return Ok(code) };
    let end = first_of_each_class(tool, folder, n, args.selector.cache.as_deref(), programs)?;
    Ok(if end == exit::OK { code } else { end })
}
