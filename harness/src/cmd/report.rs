//! `report`: pages from run folders.

use std::path::{Path, PathBuf};

use predicament_records::RunDir;
use predicament_report::{Section, against, splice, write_pages};
use predicament_studies::compare;

use crate::details::details;
use crate::exit::{self, Failure};
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament report out/run --out out/report
  predicament report out/run out/bench --out out/report    errors and timings on one page
  predicament compare --out out/run/compare                then every report of out/run has the table of backends
  predicament report out/run --against out/main --out out/report   what changed since an earlier run
  predicament report out/run --splice README.md             the same tables in a page of your own
  predicament report out/run out/compare --out out/report  with the comparison of backends that `compare` has written elsewhere";

/// Write Markdown, one self-contained HTML page, plots and their figures as CSV from run folders
///
/// A scene on a backend that several folders have counts once: in the first folder. Where they disagree, it is an error.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run` or `bench`; earlier ones come first where several have the same. Folders written by `compare` add its table, as do those in RUN/compare
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// Where the pages go; files of an earlier report are replaced
    #[arg(long, value_name = "DIR", default_value = "predicament-report")]
    pub out: PathBuf,

    /// Show what changed since this earlier run, or these: scenes, classes and times
    #[arg(long, value_name = "RUN")]
    pub against: Vec<PathBuf>,

    /// Put sections into a Markdown page of your own, between `<!-- predicament: SECTION -->` and `<!-- /predicament -->`; `SECTION tables` for its tables alone
    #[arg(long, value_name = "FILE")]
    pub splice: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let (mut folders, mut compared) = (Vec::new(), Vec::new());
    for folder in &args.runs {
        match compare::section(folder).map_err(Failure::usage)? {
            Some(section) if !folder.join("plan.json").exists() => compared.push(section),
            _ => folders.push(folder.clone()),
        }
    }
    if folders.is_empty() {
        return Err(Failure::usage(
            "there is no run among the folders; name one that `run` or `bench` has written, too",
        ));
    }
    if compared.is_empty() {
        compared.push(beside(&folders)?);
    }
    let runs = RunDir::open_all(&folders).map_err(Failure::usage)?;
    for warning in runs.iter().flat_map(|run| &run.warnings) {
        note!("{warning}");
    }
    compared.extend(tool.sections(&runs).map_err(Failure::usage)?);
    let (told, missing) = details(&runs, tool)?;
    if missing > 0 {
        note!("{missing} findings are on the page without their points: they can't be asked again alone");
    }
    if !args.against.is_empty() {
        compared.push(against(&runs, &RunDir::open_all(&args.against).map_err(Failure::usage)?));
    }
    // All pages are made before any is written.
    let mut spliced = Vec::new();
    for page in &args.splice {
        let named = |why: String| Failure::usage(format!("{}: {why}", page.display()));
        let text = std::fs::read_to_string(page).map_err(|why| named(why.to_string()))?;
        let (text, _) = splice(&text, &runs, &compared).map_err(|why| named(why.message))?;
        spliced.push((page, text));
    }
    write_pages(&runs, &compared, &told, &args.out).map_err(Failure::usage)?;
    for (page, text) in spliced {
        std::fs::write(page, text).map_err(|why| Failure::usage(format!("{}: {why}", page.display())))?;
        note!("{} has the sections that its marks name", page.display());
    }
    say!("{}", args.out.join("report.html").display());
    Ok(exit::OK)
}

/// The comparison of backends that is in a folder of a run, or in `compare` in it: the first there is, or how to make it.
fn beside(runs: &[PathBuf]) -> Result<Section, Failure> {
    for folder in runs {
        for place in [folder.clone(), folder.join(COMPARISON)] {
            if let Some(section) = compare::section(&place).map_err(Failure::usage)? {
                return Ok(section);
            }
        }
    }
    let first = runs.first().map_or(Path::new("RUN"), PathBuf::as_path);
    Ok(compare::missing(&first.join(COMPARISON)))
}

/// The folder of a comparison in that of a run.
const COMPARISON: &str = "compare";
