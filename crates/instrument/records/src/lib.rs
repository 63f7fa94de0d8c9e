//! Run folders: the files that a run writes and that every later step reads.
//!
//! The CSV and JSON files are the interchange format: every number of a report can be traced to one of their rows. This
//! crate writes, checks and reads the files. It does not depend on geometry or backends: a backend is a name in a
//! column, a truth is a symbol in a cell. It does not draw; the crate `report` makes pages and plots.
//!
//! * [`RunWriter`] makes a run folder and appends to it; a killed run can be resumed. [`RunDir`] reads a run folder.
//! * [`SummaryRow`], [`FindingRow`], [`ThroughputRow`], [`StageRow`] and [`PrecisionRow`] are the rows that every run
//!   has; tasks add their own tables through [`Row`]. [`Rows`] keep the line numbers of their rows.
//! * [`Plan`] lists the work of a run, and [`Env`] describes its machine.
//! * [`table!`] makes a row, its table and its schema from one definition; [`schema_markdown`] prints the schema.
//! * [`RunFolder`] reads a folder row by row, however large.
//! * [`junit`] writes the report for build servers.

mod answers;
mod balance;
mod decimals;
mod env;
mod error;
pub mod format;
mod hold;
mod imported;
mod junit;
pub mod moment;
mod phases;
mod plan;
mod replace;
mod row_error;
mod rows;
mod rows_with_lines;
mod run_dir;
mod sampled;
mod schema;
mod stats;
mod work;

pub use answers::AnswerRow;
pub use balance::{Basis, Costs, balance, part_of_id};
pub use decimals::DecimalsRow;
pub use env::Env;
pub use error::{Error, with_cure};
pub use hold::Hold;
pub use imported::ImportRow;
pub use junit::junit;
pub use phases::PhaseRow;
pub use plan::{
    EngineFile, ExpectedFile, FORMAT, Level, NotSelected, ParseShardError, Plan, PlannedScene, Shard, Whole,
};
pub use predicament_predicates::{Class, Severity, Status};
pub use replace::{Beside, abandon_files, make_folder, replace};
pub use row_error::RowError;
pub use rows::{FindingRow, Interface, PrecisionRow, Row, StageRow, SummaryRow, ThroughputRow, is_predicate};
pub use rows_with_lines::Rows;
pub use run_dir::{
    CostRow, Lined, NotMerged, NotRun, Outcome, Record, RunDir, RunFolder, RunWriter, SegmentRow, TABLES, TableSpec,
    merge,
};
pub use sampled::SampledRow;
pub use schema::{Column, Kind, Typed, schema_json, schema_markdown};
/// The crate `serde`, for deriving a [`Row`] in a crate that does not depend on `serde` itself.
pub use serde;
pub use stats::{Spread, approximately, geometric_mean, wilson};
pub use work::{Build, Share, WorkPlan, WrongParts};
