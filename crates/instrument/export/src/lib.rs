//! Run folders as typed tables for other programs: what does a database ask, and how does it get it?
//!
//! A run folder is CSV, which is appended to and survives a kill. To ask many runs together, such as a year of nightly ones, [`export`] makes one
//! file of each table of all of them, with columns in front that tell the runs apart. The types of the columns are those of the published
//! schema (`records::schema`). There is a file for each format: [`Format`].
//!
//! This crate judges nothing: a row of a run folder is a row of the export. It leaves out one kind of row, and says how many: a judgement in a
//! bench that is a copy of one in a run (`copies`). It holds as much of a table as one row group of Parquet, whatever the size of the runs.

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
