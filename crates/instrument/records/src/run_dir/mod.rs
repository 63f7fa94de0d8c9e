//! A run on disk: a folder of two JSON files, tables, and a state.
//!
//! ```text
//! plan.json        the planned work; written first
//! env.json         the machine
//! state.json       the outcome, and the valid length of each table: see `Outcome`
//! summary.csv findings.csv throughput.csv stages.csv precision.csv
//! *.csv            tables of single tasks, such as contacts.csv
//! segments.csv     in a part of a run: the bytes of each table that belong to each scene
//! costs.csv        the time of each scene on each backend; not covered by a digest: see `CostRow`
//! maps/*.png       pictures for the report, if any
//! run.lock         locked by the process that writes the folder
//! ```
//!
//! If a table is missing and `state.json` does not list it, the folder was made by an older version of the tool. The
//! table is then read as empty, and started when the run is resumed.
//!
//! A folder counts as incomplete until the run records its end. JSON files and pictures are complete or absent. A table
//! counts up to the length in the state, and only with the digest in the state. Each JSON file has a digest of itself,
//! its seal. So a run can be ended at any moment: its folder is then resumed or refused.

mod costs;
mod csv_file;
mod hashed;
mod lock;
mod merge;
mod once;
mod reader;
mod regular;
mod sealed;
mod segments;
mod state;
mod stream;
mod tables;
mod text_rows;
mod writer;

pub use costs::CostRow;
pub use merge::{NotMerged, merge};
pub use reader::{NotRun, RunDir};
pub use segments::SegmentRow;
pub use state::Outcome;
pub use stream::RunFolder;
pub use tables::{Record, TableSpec};
pub use text_rows::Lined;
pub use writer::RunWriter;

use crate::{FindingRow, PrecisionRow, StageRow, SummaryRow, ThroughputRow};

const PLAN: &str = "plan.json";
const ENV: &str = "env.json";
const MAPS: &str = "maps";

/// The tables that every run folder has.
pub const TABLES: [TableSpec; 5] = [
    TableSpec::of::<SummaryRow>(),
    TableSpec::of::<FindingRow>(),
    TableSpec::of::<ThroughputRow>(),
    TableSpec::of::<StageRow>(),
    TableSpec::of::<PrecisionRow>(),
];
