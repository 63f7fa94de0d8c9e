//! A run on disk: a folder of two JSON files, tables, and a state.
//!
//! ```text
//! plan.json        what is going to be done; written first
//! env.json         where
//! state.json       how far it came: see `Outcome`
//! summary.csv findings.csv throughput.csv stages.csv precision.csv
//! *.csv            tables of single tasks, such as contacts.csv
//! segments.csv     in a part of a run: which bytes of the tables are of which scene
//! costs.csv        how long each scene took on each backend; no digest covers it: see `CostRow`
//! maps/*.png       pictures for the report, if any
//! run.lock         locked by the process that writes the folder
//! ```
//! A table that `state.json` doesn't name and that isn't there is younger than the
//! tool that made the folder: it is read as empty, and started when the run is resumed.
//!
//! The folder says that the run is incomplete until somebody says otherwise. JSON files and pictures are whole or not there; a table
//! counts as far as the state says, and only if it has the digest that the state says; a JSON file has a digest of itself, its seal. So a run can be ended at any moment, and what
//! is left of it is gone on with or refused.

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
