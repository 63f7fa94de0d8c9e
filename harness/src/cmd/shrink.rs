//! `shrink`: finds the smallest scene that shows a finding, or the smallest files on which a command fails.

use std::path::{Path, PathBuf};
use std::time::Duration;

use predicament_records::RunDir;

use crate::adding::add;
use crate::exit::{self, Failure};
use crate::found::find;
use crate::planning::free_folder;
use crate::programs::Programs;
use crate::reducing;
use crate::shared::{seconds, set_threads};
use crate::shrinking::{Ask, EVALUATIONS, Job, STATE, SUITE, again, begun, told};
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
A finding: everything that the finding does not need is removed: queries, primitives, points (the others keep their order), \
constructions and corners of loops. Then coordinates are made simpler. The folder has shrunk.toml, a suite with the \
scene, and the scene as a test in Rust, C++, Python and JavaScript. The scene is also printed.

Files: the command after `--` runs on smaller and smaller copies of the files, in parallel. `{}` stands for all files, \
`{1}`, `{2}` for one of them, `{dir}` for their temporary folder. A candidate is taken if the command fails on it: by \
--when. Meshes (OFF, OBJ, PLY, STL), maps (GeoJSON, WKT) and points (CSV) lose components, faces or features, loops, \
points, then digits of their coordinates. The folder always has the smallest files so far.

Examples:
  predicament shrink 180cf3db2411 --run out/run
  predicament shrink 180c --run out/run --into mine.toml         the scene is added to a suite, ready to commit
  predicament shrink 180c --run out/run -b naive:first           a second backend has to show it too
  predicament shrink 180c --run out/run --not-by shewchuk        and one that must not
  predicament shrink --resume predicament-shrink-1 --evaluations 20000
  predicament run mine.toml --shrink 3                           the first three findings of each class, after a run
  predicament shrink a.off b.off -- ./union {1} {2}              two meshes on which ./union still fails
  predicament shrink map.geojson --when signal -- ./overlay {}   a signal ends it: a crash
  predicament shrink p.csv --when 'prints=not convex' --timeout 2 -- python3 hull.py {}
  predicament shrink a.obj --when timeout --timeout 5 -- ./triangulate {} {dir}/out.obj
  predicament shrink --resume predicament-shrink-1 -- ./union {1} {2}   continue after Ctrl-C or a kill";

/// Find the smallest scene with a finding, or the smallest files on which a command fails
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The id of the finding, or a prefix of it, from findings.csv or the report; or files, with a command after `--`
    #[arg(value_name = "ID|FILE", required_unless_present = "resume")]
    pub what: Vec<String>,

    /// The command that fails on the files
    #[arg(last = true, value_name = "COMMAND")]
    pub command: Vec<String>,

    /// The failure of the command: nonzero, code=N, timeout, signal or prints=TEXT; default: nonzero
    #[arg(long, value_name = "CONDITION", requires = "command")]
    pub when: Option<String>,

    /// The number of runs of the command at a time; default: all cores
    #[arg(long, value_name = "N", requires = "command")]
    pub threads: Option<usize>,

    /// The run that found it
    #[arg(long, value_name = "DIR", conflicts_with = "command")]
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

    /// The time limit in seconds of one backend on one scene, or of one run of the command
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "10")]
    pub timeout: Duration,

    /// A new folder; default: the first free predicament-shrink-N
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    pub out: Option<PathBuf>,

    /// Continue an interrupted `shrink`, or one that had too few evaluations
    #[arg(long, value_name = "DIR", conflicts_with_all = ["what", "run", "backends", "not_by"])]
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
    if !args.command.is_empty() || args.resume.as_ref().is_some_and(|folder| folder.join(reducing::STATE).exists()) {
        return files(args);
    }
    let (programs, also) = args.programs.clone().and_named(&args.backends)?;
    let (programs, not_by) = programs.and_named(&args.not_by)?;
    let (job, folder) = match (&args.resume, args.what.as_slice(), &args.run) {
        (Some(folder), ..) => (resumed(args, tool, folder)?, folder.clone()),
        (None, [id], Some(run)) => {
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
        _ => {
            let cure = "name a finding and its --run, or files and, after `--`, the command that fails on them";
            return Err(Failure::usage(format!("{cure}; or --resume a folder")));
        }
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

/// Shrinks files on which a command fails.
fn files(args: &Args) -> exit::Outcome {
    if args.command.is_empty() {
        let cure = "a folder never starts a command, so write the command again after `--`";
        return Err(Failure::usage(format!("the folder is that of a command; {cure}")));
    }
    let named =
        args.into.is_some() || args.evaluations.is_some() || !args.backends.is_empty() || !args.not_by.is_empty();
    if named {
        return Err(Failure::usage("a command has no --into, --evaluations, --backend or --not-by; leave them out"));
    }
    set_threads(args.threads)?;
    reducing::run(&reducing::Ask {
        files: &args.what,
        command: &args.command,
        when: args.when.as_deref(),
        timeout: args.timeout,
        out: args.out.as_deref(),
        resume: args.resume.as_deref(),
    })
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
