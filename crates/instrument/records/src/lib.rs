//! Run folders: the files that a run leaves and that every later step reads.
//!
//! A run leaves CSV and JSON files; they are the interchange format, and every
//! number of a report can be traced to one of their rows. This crate writes,
//! checks and reads them. It knows no geometry and no backend: a backend is a
//! name in a column, a truth is a symbol in a cell. It draws nothing; pages and
//! plots are the crate `report`.
//!
//! * [`RunWriter`] makes a run folder and appends to it; a run that was killed
//!   explains itself and can be resumed. [`RunDir`] reads one.
//! * [`SummaryRow`], [`FindingRow`], [`ThroughputRow`], [`StageRow`] and [`PrecisionRow`]
//!   are the rows that every run has; tasks add tables of their own through [`Row`]. [`Rows`] know their lines.
//! * [`Plan`] and [`Env`] say what was to be done, and where.
//! * [`table!`] makes a row, its table and its schema from one definition; [`schema_markdown`] prints it.
//! * [`RunFolder`] reads a folder row by row, however large.
//! * [`junit`] is what build servers read.

mod answers;
mod balance;
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
pub use replace::{Beside, make_folder, replace};
pub use row_error::RowError;
pub use rows::{FindingRow, Interface, PrecisionRow, Row, StageRow, SummaryRow, ThroughputRow, is_predicate};
pub use rows_with_lines::Rows;
pub use run_dir::{
    CostRow, Lined, NotMerged, NotRun, Outcome, Record, RunDir, RunFolder, RunWriter, SegmentRow, TABLES, TableSpec,
    merge,
};
pub use sampled::SampledRow;
pub use schema::{Column, Kind, Typed, schema_json, schema_markdown};
/// For deriving a [`Row`] in a crate that does not depend on `serde` itself.
pub use serde;
pub use stats::{Spread, approximately, geometric_mean, wilson};
pub use work::{Build, Share, WorkPlan, WrongParts};
