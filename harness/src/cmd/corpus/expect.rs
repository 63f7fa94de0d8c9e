//! `expect`: updates a file of expectations from a run; comments and order stay.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use predicament_oracle::expect::Expectations;
use predicament_oracle::known::Scenes;
use predicament_oracle::pattern::Pattern;
use predicament_records::{self as records, Hold, RunDir, Status, SummaryRow};
use predicament_tasks::Class;

use crate::exit::{self, Failure};
use crate::expect_file::{Edits, Told, grouped, prune, update};
use crate::expectations;
use crate::out::hold;
use crate::tool::Tool;

const EXAMPLES: &str = "\
`update` adds unexpected findings to the file, with your reason; read the findings first. `prune` removes \
expectations that no scene of the run shows any more, and expectations that name an unknown scene or backend. \
Expectations that the run has not tested stay: other backends, globs of which only a part was run, suites and engines \
that are elsewhere. Both commands keep comments and order. An entry without a level applies to both levels, and one \
run decides; give `prune` a run of the level that your gate uses.

Examples:
  predicament corpus expect update out/run --expected mine.toml --reason 'differences are rounded' --dry-run
  predicament corpus expect update out/run --expected mine.toml --reason 'differences are rounded'
  predicament corpus expect prune out/run --expected mine.toml --dry-run";

/// Update a file of expectations from a run
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(clap::Subcommand)]
enum Chore {
    /// Add the unexpected findings of a run
    #[command(after_help = EXAMPLES)]
    Update {
        #[command(flatten)]
        of: Of,

        /// The reason for the new expectations; it is written to the file and may not be empty
        #[arg(long, value_name = "TEXT")]
        reason: String,
    },
    /// Remove expectations that no scene shows any more
    #[command(after_help = EXAMPLES)]
    Prune {
        #[command(flatten)]
        of: Of,
    },
}

#[derive(clap::Args)]
struct Of {
    /// A folder written by `run` or `merge`
    run: PathBuf,

    /// The file to edit; default: corpora/expected.toml of the repository that the tool was built from
    #[arg(long, value_name = "FILE")]
    expected: Option<PathBuf>,

    /// Print the difference and do not change the file
    #[arg(long)]
    dry_run: bool,
}

/// The path of the shipped expectations in the repository.
const SHIPPED: &str = "corpora/expected.toml";

/// The file to edit, its text, and the expectations that rows are compared with.
struct Held {
    file: PathBuf,
    text: String,
    /// Expectations besides those of the file.
    beside: Expectations,
    expected: Expectations,
    /// The lock: no other process edits the file until it is written.
    _hold: Option<Hold>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    match &args.chore {
        Chore::Update { of, reason } => {
            if reason.trim().is_empty() {
                return Err(Failure::usage("--reason is empty; say why these findings are expected"));
            }
            let held = held(of, tool, true)?;
            let mut run = judged(of, &held)?;
            let level = run.plan.level.to_string();
            let missing = |row: &SummaryRow| {
                let known: Vec<Class> = held
                    .expected
                    .matching(&row.suite, &row.scene, &row.backend, &level)
                    .map(|entry| entry.class)
                    .collect();
                let found = |class: &Class| !class.is_legal() && row.count(*class) > 0 && !known.contains(class);
                Class::ALL.into_iter().filter(found).collect()
            };
            let entries = grouped(&run, missing);
            let edits = update(&held.file.display().to_string(), &held.text, &entries, &level, reason.trim())?;
            finish(of, &held, edits, |expected| changed(&mut run, expected))
        }
        Chore::Prune { of } => {
            let held = held(of, tool, false)?;
            let run = judged(of, &held)?;
            let known = expectations::scenes(tool, &run.plan)?;
            let told = |glob: &Pattern, backend: &str, class: &str| {
                if expectations::may_be(tool, &run.plan, backend) {
                    told(&run, &known, glob, backend, class)
                } else {
                    Told::Gone
                }
            };
            let level = run.plan.level.to_string();
            let pruned = prune(&held.file.display().to_string(), &held.text, &level, told)?;
            pruned.by_hand.iter().for_each(|line| say!("{line}"));
            if pruned.untried > 0 {
                say!("{} expectations stay, because the run has not tested them", pruned.untried);
            }
            let count = pruned.gone;
            finish(of, &held, pruned.edits, |_| {
                format!("{count} expectations of a scene, backend and class are removed")
            })
        }
    }
}

/// Describes how many rows of the run became expected and how many are still not as expected.
fn changed(run: &mut RunDir, expected: &Expectations) -> String {
    let before: Vec<bool> = run.summary.iter().map(|row| row.status == Status::Unexpected).collect();
    expectations::hold(expected, run);
    let count = |status: Status| run.summary.iter().filter(|row| row.status == status).count();
    let became = before.iter().zip(&*run.summary).filter(|(was, row)| **was && row.status == Status::Expected).count();
    let mut told = format!("{became} rows are expected from now on");
    let left = [(count(Status::Unexpected), "unexpected"), (count(Status::UnexpectedPass), "unexpected pass")];
    for (rows, what) in left.into_iter().filter(|(rows, _)| *rows > 0) {
        let _ = write!(told, ", {rows} still {what}");
    }
    told
}

/// The file to edit, with its text and the expectations that it adds to.
fn held(of: &Of, tool: &Tool, may_begin: bool) -> Result<Held, Failure> {
    let file = match (&of.expected, tool.expected()) {
        (Some(file), _) | (None, Some(file)) => file.clone(),
        (None, None) => {
            let shipped = tool.library()?.companion("expected.toml")?.map(|(_, text)| text);
            let here = std::fs::read_to_string(SHIPPED).ok();
            if here.is_none() || here != shipped {
                return Err(Failure::usage(format!(
                    "{SHIPPED} is missing, or differs from the file that the tool was built with; name a file with \
                     --expected"
                )));
            }
            PathBuf::from(SHIPPED)
        }
    };
    // Wait for another process that edits the file, then read what it wrote.
    let hold = if of.dry_run { None } else { Some(hold(&file)?) };
    if may_begin && of.expected.is_some() && !file.exists() {
        let none = Expectations::default();
        return Ok(Held { file, text: String::new(), beside: none.clone(), expected: none, _hold: hold });
    }
    let text = expectations::text(&file)?;
    let expected = expectations::load(tool, of.expected.as_ref())?;
    let is_own = of.expected.is_none() && tool.expected().is_some();
    let beside = if is_own { expectations::shipped(tool)? } else { Expectations::default() };
    Ok(Held { file, text, beside, expected, _hold: hold })
}

/// The run, with the status of each row recomputed from the file.
fn judged(of: &Of, held: &Held) -> Result<RunDir, Failure> {
    let mut run = RunDir::open(&of.run).map_err(Failure::usage)?;
    if !run.is_complete() {
        let cure = match run.outcome {
            records::Outcome::Timeout => "run it again with a longer --timeout",
            _ => "complete it first with `run --resume`",
        };
        let message = format!("{}: the run is {}; {cure}", of.run.display(), run.outcome.describe());
        return Err(Failure { message, code: exit::INCOMPLETE });
    }
    expectations::hold(&held.expected, &mut run);
    Ok(run)
}

/// The evidence of a run on a scene pattern, a backend that may exist, and a class.
fn told(run: &RunDir, known: &Scenes, glob: &Pattern, backend: &str, class: &str) -> Told {
    if !known.has_any(glob) {
        return match (known.may_be_elsewhere(glob), glob.has_suite()) {
            (true, _) => Told::Untried,
            (false, true) => Told::Gone,
            (false, false) => Told::Nameless,
        };
    }
    let Ok(class) = class.parse::<Class>() else { return Told::Kept };
    let rows = run.summary.iter().filter(|row| row.backend == backend && glob.names(&row.suite, &row.scene));
    let (shown, not): (Vec<&SummaryRow>, Vec<&SummaryRow>) = rows.partition(|row| row.count(class) > 0);
    let is_tried = |(suite, scene): &(String, String)| not.iter().any(|row| row.suite == *suite && row.scene == *scene);
    match (shown.is_empty(), not.is_empty()) {
        (true, true) => Told::Untried,
        (true, false) if known.may_be_elsewhere(glob) || !known.matching(glob).all(is_tried) => Told::Untried,
        (true, false) => Told::Gone,
        (false, false) => Told::Partly,
        (false, true) => Told::Kept,
    }
}

/// Writes the file, or prints the difference. `what` describes the change, given all expectations that rows are now
/// compared with.
fn finish(of: &Of, held: &Held, edits: Edits, what: impl FnOnce(&Expectations) -> String) -> exit::Outcome {
    let edits = edits.with_line_ends_of(&held.text);
    let name = held.file.display().to_string();
    if edits.is_empty() {
        say!("{name}: nothing to change");
        return Ok(exit::OK);
    }
    let made = edits.apply(&held.text);
    let expected = Expectations::parse(Path::new(&name), &made).map_err(|error| {
        Failure::usage(format!("nothing was written, because the result is not a valid file of expectations: {error}"))
    })?;
    if of.dry_run {
        say_text!("{}", edits.patch(&name, &held.text));
    } else {
        records::replace(&held.file, made.as_bytes()).map_err(Failure::usage)?;
        say!("{name}: {}", what(&held.beside.clone().and(expected)));
    }
    Ok(exit::OK)
}
