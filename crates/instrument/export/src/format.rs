//! The formats, and the table that each starts.

use std::fs::File;

use crate::comma::Comma;
use crate::error::WriteError;
use crate::row_groups::RowGroups;
use crate::sink::Sink;
use crate::value::Typed;

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
