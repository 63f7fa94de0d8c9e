//! `shrink`: the smallest scene that still shows a finding.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Duration;

use predicament_predicates::Class;
use predicament_records::{FindingRow, RunDir, replace};

use super::replay::{find, load};
use crate::adding::add;
use crate::exit::{self, Failure};
use crate::out::program;
use crate::planning::free_folder;
use crate::programs::{Programs, Recorded};
use crate::shrinking::{self, Job, Measure, STATE, SUITE, State};
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
What the finding does not need is left out: queries, primitives, points (the order of the others stays), constructions, corners of
loops; then coordinates become simpler. The folder has shrunk.toml, a suite with the scene, and the same as a test in Rust, C++ and
Python. The scene is also printed.

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
    /// The finding's id, or a prefix of it, from findings.csv or the report
    #[arg(required_unless_present = "resume", requires = "run")]
    pub id: Option<String>,

    /// The run that found it
    #[arg(long, value_name = "DIR")]
    pub run: Option<PathBuf>,

    /// Backends that have to show it besides the one that the finding is about
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Backends that must not show it
    #[arg(long, value_name = "BACKEND")]
    pub not_by: Vec<String>,

    /// Scenes to look at, at most; 5,000 if left out
    #[arg(long, value_name = "N")]
    pub evaluations: Option<u64>,

    /// Seconds that one backend may take for one scene
    #[arg(long, value_name = "SECONDS", value_parser = super::run::seconds, default_value = "10")]
    pub timeout: Duration,

    /// A new folder; the first free predicament-shrink-N if left out
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    pub out: Option<PathBuf>,

    /// Go on where a `shrink` was interrupted, or with more evaluations where these had run out
    #[arg(long, value_name = "DIR", conflicts_with_all = ["id", "run", "backends", "not_by"])]
    pub resume: Option<PathBuf>,

    /// A suite to add the scene to; it is made if there is none
    #[arg(long, value_name = "FILE")]
    pub into: Option<PathBuf>,

    #[command(flatten)]
    pub programs: Programs,

    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Evaluations where none are asked for.
pub const EVALUATIONS: u64 = 5_000;

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
        // Where nothing was begun, nothing is left: a folder with files in it stays.
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
            note!("{}: nothing was added, as the scene is not the smallest yet", file.display());
        }
    }
    Ok(if state.end.is_some() { exit::OK } else { exit::INCOMPLETE })
}

/// What became of a scene, in a line.
pub fn told(state: &State) -> String {
    let State { before, after, evaluations, .. } = state;
    let end = match state.end.as_deref() {
        Some("smallest") => "nothing smaller was found".to_owned(),
        Some(end) => format!("the {end} have run out; `{} shrink --resume` goes on with --evaluations", program()),
        None => format!("interrupted; `{} shrink --resume` goes on", program()),
    };
    let Measure { points, pieces, digits } = after;
    format!(
        "{} points to {points}, {} pieces to {pieces}, {} digits to {digits}, {evaluations} scenes looked at; {end}",
        before.points, before.pieces, before.digits
    )
}

/// Makes a new folder.
pub fn make(folder: &Path) -> Result<(), Failure> {
    let failed = |error| Failure::io(folder)(error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    if folder.join(STATE).exists() || folder.join(SUITE).exists() {
        let message = format!("{}: there is a `shrink` in it; go on with --resume, or name another", folder.display());
        return Err(Failure::usage(message));
    }
    Ok(())
}

/// How a finding is to be shrunk.
pub struct Ask<'a> {
    pub also: Vec<String>,
    pub not_by: Vec<String>,
    pub evaluations: u64,
    pub timeout: Duration,
    pub cache: Option<&'a Path>,
    pub programs: &'a Programs,
}

/// The work on a finding of a run.
pub fn begun<'a>(tool: &'a Tool, dir: &RunDir, finding: &FindingRow, ask: &Ask<'_>) -> Result<Job<'a>, Failure> {
    let loaded = load(dir, finding, ask.cache, tool)?;
    let start = loaded.spelled().ok_or_else(|| {
        Failure::usage(format!("{}: the task {} cannot write its scenes out", finding.finding_id, finding.task))
    })?;
    let mut shown_by = vec![finding.backend.clone()];
    shown_by.extend(ask.also.iter().filter(|name| **name != finding.backend).cloned());
    let measure = Measure::of(&start);
    let state = State {
        finding_id: finding.finding_id.clone(),
        suite: finding.suite.clone(),
        scene: finding.scene.clone(),
        scene_id: finding.scene_id.clone(),
        task: finding.task.clone(),
        class: finding.class.name().to_owned(),
        check: finding.check.clone(),
        shown_by,
        not_by: ask.not_by.clone(),
        engines: BTreeMap::new(),
        level: dir.plan.level.to_string(),
        limit: ask.timeout.as_secs_f64(),
        evaluations: 0,
        most: ask.evaluations,
        end: None,
        before: measure,
        after: measure,
    };
    let file = dir.path.join("plan.json");
    let recorded = Recorded { file: &file, folder: Some(&dir.path), engines: &dir.plan.engines };
    let backends = state.pick(tool, ask.programs, recorded)?;
    Ok(Job { tool, state, start, source: loaded.source, named: shrinking::named(&finding.query), backends })
}

/// The folder in that of a run.
const SHRUNK: &str = "shrunk";

/// Shrinks the first findings of each class of a run that has ended, each in a folder of its own in `shrunk`, and puts all scenes into
/// one suite there. What was shrunk before stays; what was begun goes on.
pub fn first_of_each_class(
    tool: &Tool,
    run: &Path,
    n: usize,
    cache: Option<&Path>,
    programs: &Programs,
) -> exit::Outcome {
    let dir = RunDir::open(run).map_err(Failure::usage)?;
    let unexpected: BTreeSet<(&str, &str, &str)> = dir
        .summary
        .iter()
        .filter(|row| !row.status.passes())
        .map(|row| (row.suite.as_str(), row.scene.as_str(), row.backend.as_str()))
        .collect();
    let is_unexpected = |row: &FindingRow| unexpected.contains(&(&*row.suite, &*row.scene, &*row.backend));
    let (first, rest): (Vec<&FindingRow>, Vec<_>) = dir.findings.iter().partition(|row| is_unexpected(row));
    let mut chosen: BTreeMap<Class, Vec<&FindingRow>> = BTreeMap::new();
    for row in first.into_iter().chain(rest) {
        let of_class = chosen.entry(row.class).or_default();
        if of_class.len() < n && of_class.iter().all(|other| other.finding_id != row.finding_id) {
            of_class.push(row);
        }
    }
    let all: Vec<&FindingRow> = chosen.into_values().flatten().collect();
    let bar = progress::bar(all.len() as u64, "findings");
    let mut tables: BTreeMap<String, String> = BTreeMap::new();
    let mut complete = true;
    for row in all {
        let folder = run.join(SHRUNK).join(&row.finding_id);
        let ask = Ask {
            also: Vec::new(),
            not_by: Vec::new(),
            evaluations: EVALUATIONS,
            timeout: Duration::from_secs(10),
            cache,
            programs,
        };
        let job =
            if folder.join(STATE).exists() { again(tool, &folder, programs) } else { begun(tool, &dir, row, &ask) };
        bar.inc(1);
        let Ok(job) = job.map_err(|failure| note!("not shrunk: {}", failure.message)) else { continue };
        std::fs::create_dir_all(&folder).map_err(Failure::io(&folder))?;
        // A finding that comes only with the whole scene, such as one of a sample, is told and left.
        match done(job, &folder) {
            Ok((state, scene, table)) => {
                complete &= state.end.is_some();
                note!("{}: {}", folder.display(), told(&state));
                // Two findings may have one smallest scene, which a suite holds once.
                tables.entry(scene).or_insert(table);
            }
            Err(failure) => note!("not shrunk: {}", failure.message),
        }
        if interrupt::flag().load(Ordering::Relaxed) {
            complete = false;
            break;
        }
    }
    bar.finish_and_clear();
    if !tables.is_empty() {
        let text: Vec<String> = tables.into_values().collect();
        let text = format!("title = \"Shrunk findings\"\n\n{}", text.join("\n"));
        let file = run.join(SHRUNK).join(SUITE);
        replace(&file, text.as_bytes()).map_err(Failure::usage)?;
        say!("{}: the smallest scenes, as a suite", file.display());
    }
    Ok(if complete { exit::OK } else { exit::INCOMPLETE })
}

/// Shrinks, or tells what was shrunk before: how it ended, the scene's id, and the scene.
fn done(job: Job<'_>, folder: &Path) -> Result<(State, String, String), Failure> {
    let source = job.source.clone();
    let (state, shrunk) = job.run(folder, &mut |_, _| {})?;
    let table = state.table(&source, &shrunk.spelled, &shrunk.finding);
    Ok((state, shrunk.loaded.id, table))
}

/// What the source of a shrunk scene says about the source of the first one: what was put before it comes off again.
fn source_of(source: &str) -> String {
    source.split_once("); ").map_or_else(String::new, |(_, source)| source.to_owned())
}

/// The work of a folder as it was left.
fn again<'a>(tool: &'a Tool, folder: &Path, programs: &Programs) -> Result<Job<'a>, Failure> {
    let (state, loaded) = shrinking::open(tool, folder)?;
    let start = loaded.spelled().ok_or_else(|| Failure::usage("the task cannot write its scenes out"))?;
    let source = source_of(&loaded.source);
    let recorded = Recorded { file: &folder.join(STATE), folder: Some(folder), engines: &state.engines };
    let backends = state.pick(tool, programs, recorded)?;
    Ok(Job { tool, state, start, source, named: Vec::new(), backends })
}

/// The same, to go on with.
fn resumed<'a>(args: &Args, tool: &'a Tool, folder: &Path) -> Result<Job<'a>, Failure> {
    let mut job = again(tool, folder, &args.programs)?;
    job.state.most = args.evaluations.unwrap_or(job.state.most);
    job.state.end = None;
    Ok(job)
}
