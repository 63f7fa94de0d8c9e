//! A run on disk: a folder of two JSON files, eight tables, and a state.
//!
//! ```text
//! plan.json        what is going to be done; written first
//! env.json         where
//! state.json       how far it came: see `Outcome`
//! summary.csv findings.csv throughput.csv stages.csv locate.csv contacts.csv
//! masses.csv precision.csv
//! maps/*.png       pictures for the report, if any
//! ```
//! A table that `state.json` doesn't name and that isn't there is younger than the
//! tool that made the folder: it is read as empty, and started when the run is resumed.
//!
//! The folder says that the run is incomplete until somebody says otherwise.

mod csv_file;
mod reader;
mod state;
mod writer;

pub use reader::{NotRun, RunDir};
pub use state::Outcome;
pub use writer::RunWriter;

use crate::{ContactRow, FindingRow, LocateRow, MassRow, PrecisionRow, Row, StageRow, SummaryRow, ThroughputRow};

const PLAN: &str = "plan.json";
const ENV: &str = "env.json";
const MAPS: &str = "maps";

/// Every table of a run folder: its file and its columns.
const TABLES: [(&str, &[&str]); 8] = [
    (SummaryRow::FILE, SummaryRow::COLUMNS),
    (FindingRow::FILE, FindingRow::COLUMNS),
    (ThroughputRow::FILE, ThroughputRow::COLUMNS),
    (StageRow::FILE, StageRow::COLUMNS),
    (LocateRow::FILE, LocateRow::COLUMNS),
    (ContactRow::FILE, ContactRow::COLUMNS),
    (MassRow::FILE, MassRow::COLUMNS),
    (PrecisionRow::FILE, PrecisionRow::COLUMNS),
];
