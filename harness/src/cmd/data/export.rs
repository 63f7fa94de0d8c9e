//! `export`: writes run folders as typed tables for databases.

use std::path::PathBuf;
use std::sync::atomic::Ordering::Relaxed;

use clap::ValueEnum;
use indicatif::ProgressBar;
use predicament_export::{Format, Watch, export, find};
use predicament_records::format::{counted, thousands};

use crate::exit::{self, Failure};
use crate::planning::every_table;
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
Each table of the folders becomes one file: summary, findings, throughput and the others. It has the rows of all \
folders, with four columns in front: run, date, commit, machine. `runs` has a row for each folder, with its outcome; \
`scenes` has the planned scenes. `predicament data schema` prints the columns. docs/DATA.md shows how to read the \
files with DuckDB, pandas and R, and how to find out from a year of nightly runs when something became slower.

The files replace those of an earlier export once all of them are complete. The same folders give the same bytes. It \
is an error if a table was truncated or edited after its run was complete, or if a run has lost its plan.json. The \
exit code is 103 if interrupted.

Examples:
  predicament data export out/run --out out/data
  predicament data export out/run out/bench --out out/data
  predicament data export nightly --out out/data                 all run folders below a folder, such as a year of nights
  predicament data export out/run --out out/csv --format csv     the same columns, not compressed and without types";

/// Write run folders as typed tables for DuckDB, pandas or R, one file per table
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run`, `bench` or `merge`, or folders that contain such folders at any depth
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// The folder for the files
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,

    /// The format of the files
    #[arg(long, value_enum, default_value_t = As::Parquet)]
    pub format: As,
}

/// The file formats.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum As {
    /// Typed columns, compressed by gzip
    Parquet,
    /// Comma-separated values
    Csv,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let found = find(&args.runs).map_err(Failure::usage)?;
    if !found.others.is_empty() {
        let first = found.others[0].display();
        note!(
            "not exported: {} that are links or have no run: {first}, …",
            counted(found.others.len() as u64, "folder")
        );
    }
    interrupt::listen_for_all();
    let format = match args.format {
        As::Parquet => Format::Parquet,
        As::Csv => Format::Csv,
    };
    let mut waiting = Waiting(progress::bar(found.runs.len() as u64, "runs"));
    let exported = export(&found.runs, &every_table(tool), format, &args.out, &mut waiting);
    waiting.0.finish_and_clear();
    let Some(exported) = exported.map_err(Failure::usage)? else {
        note!("interrupted: {} is unchanged", args.out.display());
        return Ok(exit::INCOMPLETE);
    };
    for line in &exported.notes {
        note!("{line}");
    }
    if let Some((run, outcome)) = exported.incomplete.first() {
        let runs = counted(exported.incomplete.len() as u64, "run");
        note!("{runs} not complete (see the column `outcome` of `runs`): {run} is {outcome}");
    }
    for file in &exported.files {
        say!("{}: {}, {} bytes", file.path.display(), counted(file.rows, "row"), thousands(file.bytes));
    }
    Ok(exit::OK)
}

struct Waiting(ProgressBar);

impl Watch for Waiting {
    fn is_stopped(&self) -> bool {
        interrupt::flag().load(Relaxed)
    }

    fn done(&mut self) {
        self.0.inc(1);
    }
}
