//! Tables by name: the tables of a folder besides the tables that every run has.
//!
//! A task writes its own results to its own table. The folder's code does not know tasks, so such rows come as text.
//! They are checked where their type is known.

use std::path::Path;

use csv::WriterBuilder;

use crate::{Column, Error, Row};

/// A table's file and columns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TableSpec {
    /// The file's name.
    pub file: &'static str,
    /// The columns, in order.
    pub columns: &'static [&'static str],
    /// A description of a row.
    pub about: &'static str,
    /// The schema of the columns, in order; empty if it is not given.
    pub schema: &'static [Column],
}

impl TableSpec {
    /// The specification of the table with these rows.
    #[must_use]
    pub const fn of<R: Row>() -> TableSpec {
        TableSpec { file: R::FILE, columns: R::COLUMNS, about: R::ABOUT, schema: R::SCHEMA }
    }
}

/// A row as text, with the table that it belongs to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Record {
    /// The table's file.
    pub file: &'static str,
    /// One field for each column.
    pub fields: Vec<String>,
}

impl Record {
    /// A row as text.
    ///
    /// # Errors
    /// If the row fails its [`check`](Row::check).
    pub fn of<R: Row>(row: &R) -> Result<Record, Error> {
        let path = Path::new(R::FILE);
        row.check().map_err(|error| Error::new(path, error.to_string()))?;
        let fail = |message: String| Error::new(path, message);
        let mut writer = WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        writer.serialize(row).map_err(|error| fail(error.to_string()))?;
        let bytes = writer.into_inner().map_err(|error| fail(error.to_string()))?;
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(bytes.as_slice());
        let record = reader.records().next().ok_or_else(|| fail("an empty row".to_owned()))?;
        let record = record.map_err(|error| fail(error.to_string()))?;
        Ok(Record { file: R::FILE, fields: record.iter().map(str::to_owned).collect() })
    }
}
