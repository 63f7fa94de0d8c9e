//! Export of run folders as typed tables for databases and other programs.
//!
//! A run folder is CSV, which can be appended to and survives a kill. For queries over many runs, such as a year of
//! nightly runs, [`export`] writes one file per table for all of them, with columns in front that identify the run. The
//! types of the columns are those of the published schema (`records::schema`). There is a writer for each [`Format`].
//!
//! This crate judges nothing: a row of a run folder is a row of the export. It omits one kind of row, and reports their
//! number: a judgement in a bench that is a copy of one in a run (`copies`). Its memory is one row group of Parquet per
//! table, whatever the size of the runs.

mod comma;
mod copies;
mod error;
mod export;
mod find;
mod format;
mod front;
mod place;
mod row_groups;
mod sink;
mod value;

pub use export::{Exported, Watch, Written, export};
pub use find::{Found, Runs, find};
pub use format::Format;
pub use front::{FRONT, OWN_TABLES, RunRow};
pub use predicament_records::Error;
