//! One CSV table of a run folder, appended to and cut back to a valid length.

use std::fs::{File, OpenOptions};
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, StringRecord, WriterBuilder};

use super::tables::{Record, TableSpec};
use crate::{Error, Row};

/// A table that is appended to.
pub(super) struct CsvFile {
    path: PathBuf,
    writer: csv::Writer<File>,
}

impl CsvFile {
    /// A new table with nothing but its header.
    pub fn create(path: PathBuf, columns: &[&str]) -> Result<CsvFile, Error> {
        let file = OpenOptions::new().append(true).create_new(true).open(&path).map_err(Error::io(&path))?;
        let mut table = CsvFile::over(path, file);
        table.writer.write_record(columns).map_err(|e| failed(&table.path, &e))?;
        Ok(table)
    }

    /// An existing table, cut back to the length that it had when all was well.
    pub fn reopen(path: PathBuf, length: u64) -> Result<CsvFile, Error> {
        let file = OpenOptions::new().append(true).open(&path).map_err(Error::io(&path))?;
        let found = file.metadata().map_err(Error::io(&path))?.len();
        if found < length {
            let message = format!("{found} bytes are left of the {length} that the run had written");
            return Err(Error::new(&path, message));
        }
        file.set_len(length).map_err(Error::io(&path))?;
        Ok(CsvFile::over(path, file))
    }

    fn over(path: PathBuf, file: File) -> CsvFile {
        CsvFile { path, writer: WriterBuilder::new().has_headers(false).from_writer(file) }
    }

    pub fn append<R: Row>(&mut self, row: &R) -> Result<(), Error> {
        row.check().map_err(|message| Error::new(&self.path, message))?;
        self.writer.serialize(row).map_err(|e| failed(&self.path, &e))
    }

    /// Appends a row that is text already.
    pub fn append_fields(&mut self, fields: &[String]) -> Result<(), Error> {
        self.writer.write_record(fields).map_err(|e| failed(&self.path, &e))
    }

    /// Hands everything to the operating system and returns the file's length.
    pub fn flush(&mut self) -> Result<u64, Error> {
        self.writer.flush().map_err(Error::io(&self.path))?;
        let metadata = self.writer.get_ref().metadata().map_err(Error::io(&self.path))?;
        Ok(metadata.len())
    }
}

/// A table as text.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Text {
    path: PathBuf,
    pub header: StringRecord,
    /// Each row with its line.
    pub rows: Vec<(u64, StringRecord)>,
}

impl Text {
    /// The rows by their type.
    pub fn typed<R: Row>(&self) -> Result<Vec<R>, Error> {
        let Text { path, header, rows } = self;
        if *header != *R::COLUMNS {
            let expected = R::COLUMNS.join(",");
            return Err(Error::at(path, 1, format!("the columns must be {expected}")));
        }
        let typed = rows.iter().map(|(line, record)| {
            let row: R = record.deserialize(Some(header)).map_err(|e| failed(path, &e))?;
            row.check().map_err(|message| Error::at(path, *line, message))?;
            Ok(row)
        });
        typed.collect()
    }
}

impl Text {
    /// The rows as text, if these are the columns.
    pub fn records(&self, table: TableSpec) -> Vec<Record> {
        let rows = self.rows.iter().filter(|_| self.header == *table.columns);
        rows.map(|(_, row)| Record { file: table.file, fields: row.iter().map(str::to_owned).collect() }).collect()
    }
}

/// Reads a table. With `may_be_cut`, a last line that was only half written is
/// left out, and a sentence about it comes back with the rows.
pub(super) fn read(path: &Path, may_be_cut: bool) -> Result<(Text, Option<String>), Error> {
    let mut bytes = std::fs::read(path).map_err(Error::io(path))?;
    // A line without its end may be short of digits even where it parses.
    let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |last| last + 1);
    let mut cut = whole < bytes.len();
    bytes.truncate(whole);

    let mut reader = ReaderBuilder::new().from_reader(bytes.as_slice());
    let header = reader.headers().map_err(|e| failed(path, &e))?.clone();
    let mut rows = Vec::new();
    let mut record = StringRecord::new();
    let line = loop {
        let line = reader.position().line();
        match reader.read_record(&mut record) {
            Ok(false) => break line,
            Ok(true) => rows.push((line, record.clone())),
            Err(error) => {
                // Cut within quotes, after a line break that is part of a value?
                let lacks_fields = matches!(error.kind(), csv::ErrorKind::UnequalLengths { .. });
                let is_last = usize::try_from(reader.position().byte()) == Ok(bytes.len());
                if may_be_cut && lacks_fields && is_last {
                    cut = true;
                    break line;
                }
                return Err(failed(path, &error));
            }
        }
    };
    if cut && !may_be_cut {
        return Err(Error::at(path, line, "the last line is cut off, yet the run says that it is complete"));
    }
    let warning = cut.then(|| Error::at(path, line, "the last line is cut off and was left out").to_string());
    Ok((Text { path: path.to_owned(), header, rows }, warning))
}

fn failed(path: &Path, error: &csv::Error) -> Error {
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("there are {len} fields, and there should be {expected_len}")
        }
        csv::ErrorKind::Deserialize { err, .. } => err.to_string(),
        csv::ErrorKind::Io(err) => err.to_string(),
        _ => error.to_string(),
    };
    match error.position() {
        Some(position) => Error::at(path, position.line(), message),
        None => Error::new(path, message),
    }
}
