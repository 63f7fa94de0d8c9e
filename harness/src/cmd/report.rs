//! `report`: pages from run folders.

use std::path::PathBuf;

use predicament_records::RunDir;
use predicament_report::write_pages;

use crate::exit::{self, Failure};
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament report out/run --out out/report
  predicament report out/run out/bench --out out/report    errors and timings on one page
  predicament report out/run out/compare --out out/report  with the comparison of backends that `compare` has written";

/// Write Markdown, one self-contained HTML page, plots and their figures as CSV from run folders
///
/// A scene on a backend that several folders have counts once: in the first folder. Where they disagree, it is an error.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run` or `bench`; earlier ones come first where several have the same. Folders written by `compare` add its table
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// Where the pages go; files of an earlier report are replaced
    #[arg(long, value_name = "DIR", default_value = "predicament-report")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let (mut folders, mut compared) = (Vec::new(), Vec::new());
    for folder in &args.runs {
        match predicament_studies::compare::section(folder).map_err(Failure::usage)? {
            Some(section) if !folder.join("plan.json").exists() => compared.push(section),
            _ => folders.push(folder.clone()),
        }
    }
    if folders.is_empty() {
        return Err(Failure::usage(
            "there is no run among the folders; name one that `run` or `bench` has written, too",
        ));
    }
    let runs = RunDir::open_all(&folders).map_err(Failure::usage)?;
    for warning in runs.iter().flat_map(|run| &run.warnings) {
        note!("{warning}");
    }
    compared.extend(tool.sections(&runs).map_err(Failure::usage)?);
    write_pages(&runs, &compared, &args.out).map_err(Failure::usage)?;
    say!("{}", args.out.join("report.html").display());
    Ok(exit::OK)
}
