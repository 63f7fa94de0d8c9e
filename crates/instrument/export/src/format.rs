//! The file formats, and the writer for each.

use std::fs::File;

use crate::comma::Comma;
use crate::error::WriteError;
use crate::row_groups::RowGroups;
use crate::sink::Sink;
use crate::value::Typed;

/// A file format of exported tables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// Apache Parquet: typed columns, compressed.
    Parquet,
    /// Comma-separated values, as in run folders, with the columns in front.
    Csv,
}

impl Format {
    /// The ending of the format's file names.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Format::Parquet => "parquet",
            Format::Csv => "csv",
        }
    }

    /// Starts an empty table in a file.
    pub(crate) fn start(self, file: File, columns: &[Typed]) -> Result<Box<dyn Sink>, WriteError> {
        Ok(match self {
            Format::Parquet => Box::new(RowGroups::new(file, columns)?),
            Format::Csv => Box::new(Comma::new(file, columns)?),
        })
    }
}
