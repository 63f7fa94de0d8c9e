//! The formats, and what each has to do.

use crate::error::WriteError;
use std::fs::File;

use crate::comma::Comma;
use crate::row_groups::RowGroups;
use crate::value::{Typed, Value};

/// A format of files.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Apache Parquet: typed columns, compressed.
    Parquet,
    /// Comma-separated values, as run folders have them, with the columns in front.
    Csv,
}

impl Format {
    /// The ending of its files.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Format::Parquet => "parquet",
            Format::Csv => "csv",
        }
    }

    /// An empty table in a file.
    pub(crate) fn start(self, file: File, columns: &[Typed]) -> Result<Box<dyn Sink>, WriteError> {
        Ok(match self {
            Format::Parquet => Box::new(RowGroups::new(file, columns)?),
            Format::Csv => Box::new(Comma::new(file, columns)?),
        })
    }
}

/// A table that rows are added to. The same rows give the same bytes.
pub(crate) trait Sink {
    /// Adds a row: its cells as text, and what they say.
    fn push(&mut self, cells: &[&str], values: &[Value<'_>]) -> Result<(), WriteError>;

    /// Writes what is left.
    fn finish(self: Box<Self>) -> Result<(), WriteError>;
}
