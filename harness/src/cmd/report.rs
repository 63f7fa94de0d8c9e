//! `report`: pages from run folders.

use std::path::PathBuf;

use predicament_records::RunDir;
use predicament_report::write_pages;

use crate::exit::{self, Failure};
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament report out/run --out out/report
  predicament report out/run out/bench --out out/report    errors and timings on one page";

/// Write Markdown, one self-contained HTML page, plots and their figures as CSV from run folders
///
/// A scene on a backend that several folders have counts once: in the first folder. Where they disagree, it is an error.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run` or `bench`; earlier ones come first where several have the same
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// Where the pages go; files of an earlier report are replaced
    #[arg(long, value_name = "DIR", default_value = "predicament-report")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let runs = RunDir::open_all(&args.runs).map_err(Failure::usage)?;
    for warning in runs.iter().flat_map(|run| &run.warnings) {
        note!("{warning}");
    }
    write_pages(&runs, &tool.sections(&runs).map_err(Failure::usage)?, &args.out).map_err(Failure::usage)?;
    say!("{}", args.out.join("report.html").display());
    Ok(exit::OK)
}
