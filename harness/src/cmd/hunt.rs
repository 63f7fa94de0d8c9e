//! `hunt`: mutates and recombines scenes until one of them shows a finding.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use predicament_engines::PREFIX;
use predicament_formats::use_one_of;
use predicament_predicates::Class;
use predicament_search::Wanted;
use predicament_search::hunt::{Hunt, Options, Quarry, Seed, State, has_shapes, seeds};
use predicament_tasks::{AnyTask, Watch, digest};

use crate::exit::{self, Failure};
use crate::hunting::{Order, STATE, SUITE, Saved, TABLE};
use crate::out::program;
use crate::planning::free_folder;
use crate::programs::{Programs, Recorded};
use crate::shared::{seconds, set_threads};
use crate::tool::{Tool, each};
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
A hunt needs a task, backends and a class, but no place to look. It starts with small scenes of the suites and with \
shapes of small whole numbers, derives other scenes from them, and climbs towards disagreements. Each find is shrunk. \
The folder has finds.toml (a suite), hunt.csv (a table), each find as a test in Rust, C++, Python and JavaScript, and hunt.json, \
from which --resume continues. The same seed and number of evaluations give the same finds with any number of \
threads. docs/SEARCH.md explains the method.

Examples:
  predicament hunt orient2d -b naive                             one find of each class and check
  predicament hunt incircle -b shewchuk --class overreach        a class
  predicament hunt incircle -b mine --class inconsistent --check mixed-grassmann-plucker --seconds 60
  predicament hunt orient3d -b naive,naive:first --not-by shewchuk   shown by both, and not by another
  predicament hunt contacts2d -b tolerance --check 'crossing parity' --evaluations 50000
  predicament hunt orient2d -b mine --from shapes                from small whole numbers alone
  predicament hunt --resume predicament-hunt-1 --evaluations 100000
  predicament hunt orient2d -b naive --into mine.toml            the finds are added to a suite, ready to commit";

/// Search for scenes on which a backend is wrong
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The task, as suites name it
    #[arg(required_unless_present = "resume", conflicts_with = "resume")]
    pub task: Option<String>,

    /// Backends that all have to show the finding; `predicament run --help` lists them
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        required_unless_present = "resume",
        conflicts_with = "resume"
    )]
    pub backends: Vec<String>,

    /// Backends that must not show the finding
    #[arg(long, value_name = "BACKEND", conflicts_with = "resume")]
    pub not_by: Vec<String>,

    /// The class to find; default: any except `declined` and `timeout`
    #[arg(long, value_name = "CLASS", conflicts_with = "resume")]
    pub class: Option<Class>,

    /// The check to find; default: any
    #[arg(long, value_name = "CHECK", conflicts_with = "resume")]
    pub check: Option<String>,

    /// Maximum number of scenes that backends answer (the last generation is completed); default: 20,000, or no limit
    /// if only --seconds is given
    #[arg(long, value_name = "N")]
    pub evaluations: Option<u64>,

    /// The time in seconds after which no new generation begins
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub seconds: Option<Duration>,

    /// The seed of the random numbers
    #[arg(long, value_name = "N", default_value = "1", conflicts_with = "resume")]
    pub seed: u64,

    /// Stop after K finds; default: 10, or 1 if both --class and --check are given
    #[arg(long, value_name = "K")]
    pub finds: Option<std::num::NonZeroUsize>,

    /// Suites to start from, by name or file, or `shapes` for small whole numbers; default: all embedded suites and
    /// shapes
    #[arg(long, value_name = "SUITE", conflicts_with = "resume")]
    pub from: Vec<String>,

    /// The time limit in seconds of one backend on one scene
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "10", conflicts_with = "resume")]
    pub timeout: Duration,

    #[command(flatten)]
    pub programs: Programs,

    /// The number of threads; default: all cores
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// A new folder; default: the first free predicament-hunt-N
    #[arg(long, value_name = "DIR", conflicts_with = "resume")]
    pub out: Option<PathBuf>,

    /// Continue an interrupted hunt, or one with a larger budget
    #[arg(long, value_name = "DIR")]
    pub resume: Option<PathBuf>,

    /// A suite to add the finds to; the file is created if it does not exist
    #[arg(long, value_name = "FILE")]
    pub into: Option<PathBuf>,
}

/// The number of evaluations if no budget is given.
const EVALUATIONS: u64 = 20_000;
/// The maximum number of scenes evaluated to shrink a find.
const SHRINKING: u64 = 3_000;
/// The name among suites that stands for shapes.
const SHAPES: &str = "shapes";

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    set_threads(args.threads)?;
    let (programs, shown_by) = args.programs.clone().and_named(&args.backends)?;
    let (programs, not_by) = programs.and_named(&args.not_by)?;
    let (mut saved, seeds, folder) = match (&args.resume, &args.task) {
        (Some(folder), _) => {
            let saved = Saved::open(tool, folder)?;
            let seeds = resumed(&saved, tool, folder)?;
            (saved, seeds, folder.clone())
        }
        (None, Some(task)) => {
            let (saved, seeds) = begun(args, tool, task, (shown_by, not_by))?;
            let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-hunt"));
            make(&folder)?;
            (saved, seeds, folder)
        }
        _ => return Err(Failure::usage("name a task, or --resume a folder")),
    };
    let by_time = args.seconds.is_some() && args.evaluations.is_none();
    saved.evaluations = args.evaluations.unwrap_or(if by_time { u64::MAX } else { saved.evaluations });
    saved.finds = args.finds.map_or(saved.finds, std::num::NonZeroUsize::get);
    interrupt::listen();
    let ended = hunt(args, tool, &programs, &mut saved, (seeds, &folder))?;
    if let Some(file) = &args.into {
        add(tool, file, &saved)?;
    }
    Ok(if ended { exit::OK } else { exit::INCOMPLETE })
}

/// Hunts until the budget is used up or enough is found; false if interrupted.
fn hunt(
    args: &Args,
    tool: &Tool,
    programs: &Programs,
    saved: &mut Saved,
    (seeds, folder): (Vec<Seed>, &Path),
) -> Result<bool, Failure> {
    let order = saved.order.clone();
    let task = task_of(tool, &order.task)?;
    let recorded = Recorded { file: &folder.join(STATE), folder: Some(folder), engines: &order.engines };
    let shown_by = programs.pick(tool, &order.shown_by, recorded)?;
    let not_by = programs.pick(tool, &order.not_by, recorded)?;
    for picked in [&shown_by, &not_by] {
        saved.order.engines.extend(picked.recorded()?);
    }
    let class = order.class.as_deref().map(str::parse::<Class>).transpose().map_err(Failure::usage)?;
    let wanted = Wanted { class, check: order.check.clone() };
    let quiet = |_: u64| {};
    let watch = Watch::new(interrupt::flag(), None, &quiet);
    let quarry = Quarry {
        vocabulary: tool.vocabulary(),
        task,
        budget: Quarry::budget(&wanted),
        wanted,
        shown_by: shown_by.backends.iter().map(AsRef::as_ref).collect(),
        not_by: not_by.backends.iter().map(AsRef::as_ref).collect(),
        watch: &watch,
        limit: Some(Duration::try_from_secs_f64(order.limit).map_err(Failure::usage)?),
    };
    let options = Options { seed: order.seed, finds: saved.finds, shrinking: order.shrinking, shapes: order.shapes };
    let mut hunt = Hunt::new(quarry, options, seeds, saved.state.clone()).map_err(Failure::usage)?;
    let (start, before) = (Instant::now(), saved.seconds);
    let elapsed = || before + start.elapsed().as_secs_f64();
    let bar = match args.seconds {
        Some(limit) if args.evaluations.is_none() => progress::bar(limit.as_secs(), "seconds"),
        _ => progress::bar(saved.evaluations, "scenes"),
    };
    saved.write(tool, folder, None)?;
    let mut interrupted = false;
    while !hunt.is_done() && hunt.state().evaluations < saved.evaluations {
        if args.seconds.is_some_and(|limit| start.elapsed() >= limit) {
            break;
        }
        let written = saved.state.finds.len();
        if hunt.generation(&elapsed).is_err() {
            interrupted = true;
            break;
        }
        if let Some(why) = &hunt.state().declined {
            bar.finish_and_clear();
            for file in [STATE, SUITE, TABLE] {
                let _ = std::fs::remove_file(folder.join(file));
            }
            let backends = order.shown_by.join(", ");
            return Err(Failure::usage(format!("{backends} declines all initial scenes of {}: {why}", order.task)));
        }
        (saved.seconds, saved.state) = (elapsed(), hunt.saved());
        saved.write(tool, folder, Some(written))?;
        let whole_seconds = start.elapsed().as_secs();
        bar.set_position(if args.seconds.is_some() && args.evaluations.is_none() {
            whole_seconds
        } else {
            saved.state.evaluations
        });
        bar.set_message(format!("{} finds", saved.state.finds.len()));
    }
    bar.finish_and_clear();
    tell_summary(&hunt, saved, folder, interrupted);
    Ok(!interrupted)
}

/// Prints the result: finds on stdout, and how near the hunt came on stderr.
fn tell_summary(hunt: &Hunt<'_>, saved: &Saved, folder: &Path, interrupted: bool) {
    let State { scenes, evaluations, generations, known, finds, .. } = hunt.state();
    for (at, find) in finds.iter().enumerate() {
        let [before, after] = find.pieces;
        say!(
            "{}. {} ({}) after {} evaluations, {:.1} s; {before} pieces shrunk to {after}: {}",
            at + 1,
            find.class,
            find.check,
            find.evaluations,
            find.seconds,
            saved.name(find)
        );
        let query = if find.query.is_empty() { "the whole scene" } else { &find.query };
        say!("   {query}: got {}, truth {}", or_dash(&find.got), or_dash(&find.truth));
    }
    if finds.is_empty() {
        say!("no finds");
    }
    if !known.is_empty() {
        note!("left out, because they already show the finding: {}", known.join(", "));
    }
    for (height, peak) in hunt.peaks() {
        if let Some((peak, number)) = peak {
            #[allow(clippy::cast_precision_loss)] // shown with two decimals
            let peak = peak as f64 / 1000.0;
            note!("{}: {peak:.2} at scene {number} ({})", height.name, height.what);
        }
    }
    let end =
        if interrupted { format!("interrupted; `{} hunt --resume` continues", program()) } else { "done".to_owned() };
    let discarded = scenes - evaluations;
    if discarded > 0 {
        note!("{discarded} scenes discarded: they are not valid scenes of the task, or their truth took too long");
    }
    note!(
        "{}: {} finds in {evaluations} evaluations, {generations} generations, {:.1} s; {end}",
        folder.join(SUITE).display(),
        finds.len(),
        saved.seconds
    );
}

fn or_dash(text: &str) -> &str {
    if text.is_empty() { "-" } else { text }
}

fn task_of<'t>(tool: &'t Tool, name: &str) -> Result<&'t dyn AnyTask, Failure> {
    let found = tool.tasks().iter().copied().find(|task| task.name() == name);
    found.map(|task| task as &dyn AnyTask).ok_or_else(|| {
        let names: Vec<&str> = tool.tasks().iter().map(|task| task.name()).collect();
        Failure::usage(format!("no task is called `{name}`; {}", use_one_of(name, &names)))
    })
}

/// A new hunt, and its seeds.
fn begun(
    args: &Args,
    tool: &Tool,
    task: &str,
    (shown_by, not_by): (Vec<String>, Vec<String>),
) -> Result<(Saved, Vec<Seed>), Failure> {
    let task = task_of(tool, task)?.name();
    let from: Vec<String> = each(&args.from).map(ToOwned::to_owned).collect();
    let shapes = from.is_empty() || from.iter().any(|name| name == SHAPES);
    let suites: Vec<String> = from.into_iter().filter(|name| name != SHAPES).collect();
    let all = args.from.is_empty();
    let seeds = seeds_of(tool, task, &suites, all)?;
    let pinned = args.class.is_some() && args.check.is_some();
    // Check the names before the folder is made.
    let (shown_by, not_by) = (whole_names(tool, shown_by)?, whole_names(tool, not_by)?);
    possible(args, &shown_by, &not_by)?;
    let nothing = seeds.is_empty() && !(shapes && has_shapes(task));
    if nothing {
        let message = format!("these suites have no small scene of {task} to start from; name others with --from");
        return Err(Failure::usage(message));
    }
    let order = Order {
        task: task.to_owned(),
        class: args.class.map(|class| class.name().to_owned()),
        check: args.check.clone(),
        shown_by,
        not_by,
        engines: BTreeMap::new(),
        seed: args.seed,
        suites: if all { vec![ALL.to_owned()] } else { suites },
        shapes,
        seeds: digest_of(&seeds),
        shrinking: SHRINKING,
        limit: args.timeout.as_secs_f64(),
    };
    let finds = if pinned { 1 } else { 10 };
    Ok((Saved { order, evaluations: EVALUATIONS, finds, seconds: 0.0, state: State::default() }, seeds))
}

/// The names of backends with their parameters, as the state of a hunt has them: `epsilon` is `epsilon:1e-10`.
///
/// Engines keep the names that [`Programs::and_named`] gave them.
fn whole_names(tool: &Tool, names: Vec<String>) -> Result<Vec<String>, Failure> {
    let whole = |name: String| match name.starts_with(PREFIX) {
        true => Ok(name),
        false => tool.backend(&name).map(|backend| backend.name()),
    };
    names.into_iter().map(whole).collect::<Result<_, _>>().map_err(Failure::usage)
}

/// Refuses options with which no finding is possible.
fn possible(args: &Args, shown_by: &[String], not_by: &[String]) -> Result<(), Failure> {
    if let Some(both) = not_by.iter().find(|name| shown_by.contains(name)) {
        return Err(Failure::usage(format!("--not-by {both}: -b names it, too; drop one")));
    }
    if let Some(class) = args.class.filter(|class| class.is_legal()) {
        return Err(Failure::usage(format!(
            "--class {class}: findings do not have this class; name another, or leave it out"
        )));
    }
    Ok(())
}

/// The name that stands for all embedded suites.
const ALL: &str = "*";

/// The seeds of an earlier hunt.
fn resumed(saved: &Saved, tool: &Tool, folder: &Path) -> Result<Vec<Seed>, Failure> {
    let Order { task, suites, .. } = &saved.order;
    let all = suites.iter().any(|name| name == ALL);
    let file = folder.join(STATE);
    // The wrong name of a suite is an error of this file; an error inside a suite is an error of the suite's file.
    let named = |failure: Failure| match failure.code {
        exit::USAGE => Failure::usage(format!("{}: {}", file.display(), failure.message)),
        _ => failure,
    };
    let seeds = seeds_of(tool, task, if all { &[] } else { suites }, all).map_err(named)?;
    if digest_of(&seeds) == saved.order.seeds {
        return Ok(seeds);
    }
    Err(Failure::usage(format!(
        "{}: the suites have changed since the hunt began, so it cannot continue; start a new hunt",
        file.display()
    )))
}

fn seeds_of(tool: &Tool, task: &str, names: &[String], all: bool) -> Result<Vec<Seed>, Failure> {
    let library = tool.library()?;
    let mut suites = Vec::new();
    if all {
        suites.extend(library.suites()?.iter().cloned());
        suites.extend(tool.own_suites()?);
    }
    for name in names {
        suites.push(library.suite(name)?);
    }
    Ok(seeds(&suites, task)?)
}

fn digest_of(seeds: &[Seed]) -> u64 {
    digest(seeds.iter().flat_map(|seed| format!("{seed:?}").into_bytes()))
}

/// Makes a new folder.
fn make(folder: &Path) -> Result<(), Failure> {
    let failed = |error| Failure::io(folder)(error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    if folder.join(STATE).exists() {
        let message =
            format!("{}: the folder has a hunt; continue it with --resume, or name another folder", folder.display());
        return Err(Failure::usage(message));
    }
    Ok(())
}

/// Adds the finds to a suite, except those that it already has.
fn add(tool: &Tool, file: &Path, saved: &Saved) -> Result<(), Failure> {
    for find in &saved.state.finds {
        let before = std::fs::read_to_string(file).unwrap_or_default();
        if !before.contains(&format!("\"{}\"", saved.name(find))) {
            crate::adding::add(tool, file, &saved.scene(tool, find)?)?;
        }
    }
    Ok(())
}
