//! The rows of any CSV file as text, with their lines.
//!
//! A reader of a report asks for the rows behind a number. For a run, these are the rows that count; for a study, the
//! rows of its file.

use std::path::Path;

use super::csv_file::{self, Extent, Text};
use super::tables::Record;
use super::{RunDir, TableSpec};
use crate::{Error, PrecisionRow, Row, Rows, StageRow, SummaryRow, ThroughputRow};

/// The rows of a CSV file, each with its line.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Lined {
    /// The names of the columns.
    pub columns: Vec<String>,
    /// Each row with its line number; the header is line 1.
    pub rows: Vec<(u64, Vec<String>)>,
}

impl Lined {
    /// All rows of a file.
    ///
    /// # Errors
    /// If the file can't be read or is not CSV.
    pub fn read(path: &Path) -> Result<Lined, Error> {
        let (text, _) = csv_file::read(path, Extent::Lines, None)?;
        Ok(Lined::of(&text))
    }

    fn of(text: &Text) -> Lined {
        let words = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
        Lined {
            columns: words(&text.header),
            rows: text.rows.iter().map(|(line, record)| (*line, words(record))).collect(),
        }
    }

    fn typed<R: Row>(rows: &Rows<R>) -> Result<Lined, Error> {
        let columns = TableSpec::of::<R>().columns.iter().map(|&column| column.to_owned()).collect();
        let from_files = rows.lined().filter_map(|(line, row)| Some((line?, row)));
        let rows = from_files.map(|(line, row)| Ok((line, Record::of(row)?.fields)));
        Ok(Lined { columns, rows: rows.collect::<Result<_, Error>>()? })
    }
}

impl RunDir {
    /// The rows of one of the folder's tables, without repeated ones; `None` if the table does not exist.
    ///
    /// [`RunDir::open_all`] removes rows that an earlier folder has. Findings are not supported here, as there may be
    /// very many.
    ///
    /// # Errors
    /// If a row can't be written as text, which does not happen for rows that were read.
    pub fn lined(&self, file: &str) -> Result<Option<Lined>, Error> {
        Ok(Some(match file {
            SummaryRow::FILE => Lined::typed(&self.summary)?,
            ThroughputRow::FILE => Lined::typed(&self.throughput)?,
            StageRow::FILE => Lined::typed(&self.stages)?,
            PrecisionRow::FILE => Lined::typed(&self.precision)?,
            _ => match self.tables.get(file) {
                Some(text) => Lined::of(text),
                None => return Ok(None),
            },
        }))
    }
}
