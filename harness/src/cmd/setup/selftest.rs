//! `selftest`: plants faults and sees whether they are caught.
//!
//! Each faulty backend claims a real contract and runs through the embedded corpora like any other backend. Correct
//! answers of honest backends are spoiled before they are judged. The judge and the readers are tested against
//! independent facts.
//!
//! A fault names the checks that must find it. If one of these checks finds nothing, either the corpora have a hole or
//! the check does not work, even if another check finds the fault. Conversely, each check must be needed by some fault:
//! with the check switched off, the tool misses that fault.
//!
//! The real backends with proved contracts run on every scene on which a check finds its fault, and must have no
//! findings; otherwise the score would mean nothing. `run` and `gate` test them on all other scenes. One of these
//! backends does not run by default: it runs here on every scene that it supports.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use predicament_records::replace;

use crate::exit::{self, Failure};
use crate::expectations;
use crate::scorecard::declared::Declarations;
use crate::scorecard::entries::{Entry, entries, only};
use crate::scorecard::page::{Card, checks_csv, checks_page, checks_text};
use crate::scorecard::work::{How, Work};
use crate::select::Selector;
use crate::tool::{Tool, each};

const EXAMPLES: &str = "\
A fault runs until every check that must find it has found it. Honest backends run on each scene on which a check finds \
a fault, and sos:per-mesh on each such scene with two meshes; `run` and `gate` test honest backends on all scenes. \
`scenes` and `queries` count the work until the last of these checks found the fault.

Examples:
  predicament setup selftest
  predicament setup selftest --list                      the faults, and the checks that have to find them
  predicament setup selftest --checks                    the checks, and the faults that need them: docs/CHECKS.md
  predicament setup selftest --only answer:interval-next-cell,fault:contacts-one-sided
  predicament setup selftest --only fault:exact-flushed --everything   all checks that find it, on all scenes
  predicament setup selftest -f kettner                  which faults does one part of the corpora catch?
  predicament setup selftest --without 'perturbed sign'  red: faults are missed without the check
  predicament setup selftest --shrink --out out/selftest how small a scene shows each fault, and tables
  predicament run -b fault:sos-swapped-term        a planted fault in a run of its own; `gate` turns red";

/// Scenes that are looked at for each shrunk one.
const EVALUATIONS: u64 = 300;

/// The files of `--out`.
const CARD: &str = "selftest.csv";
const CHECKS: &str = "checks.csv";

/// Plant faults in backends, answers, judges and readers; each must be caught by its checks
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Only scenes whose `suite/scene` matches this regular expression; a fault is then
    /// caught by any finding
    #[arg(short = 'f', long = "filter", value_name = "RE")]
    pub filter: Option<String>,

    /// Only these faults by name, several with commas
    #[arg(long, value_name = "FAULT", value_delimiter = ',')]
    pub only: Vec<String>,

    /// Ignore what these checks find, by NAME, CLASS/NAME or TASK:CLASS/NAME: the card has to come out red
    #[arg(long, value_name = "CHECK")]
    pub without: Vec<String>,

    /// Run each fault on all scenes, and name all checks that find it
    #[arg(long)]
    pub everything: bool,

    /// Shrink a scene that shows each fault, and say how large it is; takes a while longer
    #[arg(long)]
    pub shrink: bool,

    /// Name the faults and the checks that have to find them, and stop
    #[arg(long, conflicts_with_all = ["checks", "filter", "without", "everything", "shrink", "out"])]
    pub list: bool,

    /// Name the checks and the faults that need them, and stop
    #[arg(long, conflicts_with_all = ["filter", "only", "without", "everything", "shrink", "out"])]
    pub checks: bool,

    /// The format: text; for the card JSON with one object a line (name, area, verdict, checks, scenes, queries,
    /// points, pieces); for --checks Markdown or CSV
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// A folder for the card and the checks as tables, selftest.csv and checks.csv
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// The format of what is printed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// Lines.
    Text,
    /// The page docs/CHECKS.md.
    Md,
    /// A table.
    Csv,
    /// One JSON object a line.
    Json,
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    let checks = Declarations::of(tool);
    let mut entries = entries(tool, &checks).map_err(Failure::usage)?;
    if args.checks {
        match args.format {
            Format::Text => say_text!("{}", checks_text(&checks, &entries)),
            Format::Md => say_text!("{}", checks_page(&checks, &entries)),
            Format::Csv => say_text!("{}", checks_csv(&checks, &entries).map_err(Failure::usage)?),
            Format::Json => return Err(Failure::usage("--checks prints text, md or csv, not json")),
        }
        return Ok(exit::OK);
    }
    if matches!(args.format, Format::Md | Format::Csv) {
        return Err(Failure::usage("the card is printed as text or json; md and csv are for --checks"));
    }
    let off: Result<Vec<Vec<usize>>, String> = each(&args.without).map(|name| checks.called(name)).collect();
    let off: BTreeSet<usize> = off.map_err(Failure::usage)?.into_iter().flatten().collect();
    let is_all = args.only.is_empty();
    if !is_all {
        entries = only(entries, &args.only).map_err(Failure::usage)?;
    }
    if args.list {
        list(&checks, &entries);
        return Ok(exit::OK);
    }
    if let Some(folder) = &args.out {
        // Before minutes of work, not after.
        std::fs::create_dir_all(folder).map_err(Failure::io(folder))?;
    }
    let is_whole = args.filter.is_none();
    let selector = Selector { filter: args.filter, ..Selector::everything() };
    let selection = selector.select(tool)?;
    let expected = expectations::load(tool, None)?;
    let how = How { everything: args.everything, shrink: args.shrink.then_some(EVALUATIONS) };
    Work { tool, checks: &checks, entries: &mut entries, expected: &expected, how }.run(&selection)?;
    let card = Card { checks: &checks, entries: &entries, off, is_whole, is_complete: is_whole && is_all };
    if let Some(folder) = &args.out {
        write(folder, CARD, &card.csv().map_err(Failure::usage)?)?;
        write(folder, CHECKS, &checks_csv(&checks, &entries).map_err(Failure::usage)?)?;
    }
    say_text!("{}", if args.format == Format::Json { card.json() } else { card.text() });
    Ok(if card.is_good() { exit::OK } else { exit::UNEXPECTED })
}

/// The faults by name, what is wrong, and what has to find them.
fn list(checks: &Declarations, entries: &[Entry]) {
    let faults: Vec<&Entry> = entries.iter().filter(|entry| entry.is_fault()).collect();
    let width = faults.iter().map(|entry| entry.name.chars().count()).max().unwrap_or(0);
    for entry in faults {
        let by: Vec<String> = entry.wants.iter().map(|&check| checks.0[check].to_string()).collect();
        let area = entry.area.map_or("", predicament_oracle::faults::Area::name);
        say!("{:<width$}  {area:<10}  {}", entry.name, entry.what);
        say!("{:<width$}  {:<10}  caught by {}", "", "", by.join(", "));
    }
}

fn write(folder: &Path, name: &str, text: &str) -> Result<(), Failure> {
    let file = folder.join(name);
    replace(&file, text.as_bytes()).map_err(Failure::usage)
}
