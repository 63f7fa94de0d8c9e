//! `shrink`: finds the smallest scene that still shows a finding.

use std::path::{Path, PathBuf};
use std::time::Duration;

use predicament_records::RunDir;

use crate::adding::add;
use crate::exit::{self, Failure};
use crate::found::find;
use crate::planning::free_folder;
use crate::programs::Programs;
use crate::shared::seconds;
use crate::shrinking::{Ask, EVALUATIONS, Job, STATE, SUITE, again, begun, told};
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
Everything that the finding does not need is removed: queries, primitives, points (the others keep their order), \
constructions and corners of loops. Then coordinates are made simpler. The folder has shrunk.toml, a suite with the \
scene, and the scene as a test in Rust, C++ and Python. The scene is also printed.

Examples:
  predicament shrink 180cf3db2411 --run out/run
  predicament shrink 180c --run out/run --into mine.toml         the scene is added to a suite, ready to commit
  predicament shrink 180c --run out/run -b naive:first           a second backend has to show it too
  predicament shrink 180c --run out/run --not-by shewchuk        and one that must not
  predicament shrink --resume predicament-shrink-1 --evaluations 20000
  predicament run mine.toml --shrink 3                           the first three findings of each class, after a run";

/// Find the smallest scene that still shows a finding
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The id of the finding, or a prefix of it, from findings.csv or the report
    #[arg(required_unless_present = "resume", requires = "run")]
    pub id: Option<String>,

    /// The run that found it
    #[arg(long, value_name = "DIR")]
    pub run: Option<PathBuf>,

    /// Backends that have to show the finding, in addition to the finding's backend
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Backends that must not show the finding
    #[arg(long, value_name = "BACKEND")]
    pub not_by: Vec<String>,

    /// Maximum number of scenes evaluated; default: 5,000
    #[arg(long, value_name = "N")]
    pub evaluations: Option<u64>,

    /// The time limit in seconds of one backend on one scene
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "10")]
    pub timeout: Duration,

    /// A new folder; default: the first free predicament-shrink-N
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    pub out: Option<PathBuf>,

    /// Continue an interrupted `shrink`, or one that had too few evaluations
    #[arg(long, value_name = "DIR", conflicts_with_all = ["id", "run", "backends", "not_by"])]
    pub resume: Option<PathBuf>,

    /// A suite to add the scene to; the file is created if it does not exist
    #[arg(long, value_name = "FILE")]
    pub into: Option<PathBuf>,

    #[command(flatten)]
    pub programs: Programs,

    /// The folder of fetched data; default: $PREDICAMENT_CACHE or the user's cache
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let (programs, also) = args.programs.clone().and_named(&args.backends)?;
    let (programs, not_by) = programs.and_named(&args.not_by)?;
    let (job, folder) = match (&args.resume, &args.id, &args.run) {
        (Some(folder), ..) => (resumed(args, tool, folder)?, folder.clone()),
        (None, Some(id), Some(run)) => {
            let dir = RunDir::open(run).map_err(Failure::usage)?;
            let finding = find(&dir, id, run)?;
            let ask = Ask {
                also,
                not_by,
                evaluations: args.evaluations.unwrap_or(EVALUATIONS),
                timeout: args.timeout,
                cache: args.cache.as_deref(),
                programs: &programs,
            };
            let job = begun(tool, &dir, finding, &ask)?;
            let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-shrink"));
            make(&folder)?;
            (job, folder)
        }
        _ => return Err(Failure::usage("name a finding and its run, or --resume a folder")),
    };
    interrupt::listen();
    let bar = progress::bar(job.state.most, "scenes");
    let (table, state) = {
        let source = job.source.clone();
        let done = job.run(&folder, &mut |evaluations, pieces| {
            bar.set_position(evaluations);
            bar.set_message(format!("{pieces} pieces"));
        });
        // If the work fails before it begins, an empty folder is removed; a folder with files stays.
        let (state, shrunk) = done.inspect_err(|_| drop(std::fs::remove_dir(&folder)))?;
        (state.table(&source, &shrunk.spelled, &shrunk.finding), state)
    };
    bar.finish_and_clear();
    say_text!("{table}");
    note!("{}: {}", folder.display(), told(&state));
    if let Some(file) = &args.into {
        if state.end.is_some() {
            add(tool, file, &table)?;
        } else {
            note!("{}: nothing was added: the scene is not the smallest yet", file.display());
        }
    }
    Ok(if state.end.is_some() { exit::OK } else { exit::INCOMPLETE })
}

/// Makes a new folder.
fn make(folder: &Path) -> Result<(), Failure> {
    let failed = |error| Failure::io(folder)(error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    if folder.join(STATE).exists() || folder.join(SUITE).exists() {
        let message = format!(
            "{}: the folder has a `shrink`; continue it with --resume, or name another folder",
            folder.display()
        );
        return Err(Failure::usage(message));
    }
    Ok(())
}

/// The work in the folder of an earlier `shrink`.
fn resumed<'a>(args: &Args, tool: &'a Tool, folder: &Path) -> Result<Job<'a>, Failure> {
    let mut job = again(tool, folder, &args.programs)?;
    job.state.most = args.evaluations.unwrap_or(job.state.most);
    job.state.end = None;
    Ok(job)
}
