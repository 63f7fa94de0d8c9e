//! A CSV table of a run folder, appended to and cut back to a valid length.

use std::collections::HashMap;
use std::fs::OpenOptions;
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, StringRecord, WriterBuilder};

use super::hashed::{Hashed, digest};
use super::regular::{header_length, read_regular};
use super::state::{Outcome, State};
use super::tables::{Record, TableSpec};
use crate::error::with_cure;
use crate::{Error, Row, Rows};

/// An open CSV table, for appending.
pub(super) struct CsvFile {
    path: PathBuf,
    writer: csv::Writer<Hashed>,
}

impl CsvFile {
    /// A new table with only its header.
    pub fn create(path: PathBuf, columns: &[&str]) -> Result<CsvFile, Error> {
        let file = OpenOptions::new().append(true).create_new(true).open(&path).map_err(Error::io(&path))?;
        let mut table = CsvFile::over(path, Hashed::new(file));
        table.writer.write_record(columns).map_err(|e| failed(&table.path, &e))?;
        Ok(table)
    }

    /// An existing table, cut back to its committed length; refused if its bytes differ from the committed ones.
    pub fn reopen(path: PathBuf, columns: &[&str], length: u64, written: Option<&String>) -> Result<CsvFile, Error> {
        let mut bytes = read_regular(&path)?;
        if (bytes.len() as u64) < length {
            return Err(shortened(&path, bytes.len() as u64, length));
        }
        bytes.truncate(usize::try_from(length).unwrap_or(usize::MAX));
        if written.is_some_and(|written| *written != digest(&bytes)) {
            return Err(Error::new(&path, CHANGED));
        }
        check_columns(&path, &bytes, columns)?;
        let file = OpenOptions::new().append(true).open(&path).map_err(Error::io(&path))?;
        file.set_len(length).map_err(Error::io(&path))?;
        Ok(CsvFile::over(path, Hashed::after(file, &bytes)))
    }

    fn over(path: PathBuf, file: Hashed) -> CsvFile {
        CsvFile { path, writer: WriterBuilder::new().has_headers(false).from_writer(file) }
    }

    pub fn append<R: Row>(&mut self, row: &R) -> Result<(), Error> {
        row.check().map_err(|error| Error::new(&self.path, error.to_string()))?;
        self.writer.serialize(row).map_err(|e| failed(&self.path, &e))
    }

    /// Appends a row that is already text.
    pub fn append_fields(&mut self, fields: &[String]) -> Result<(), Error> {
        self.writer.write_record(fields).map_err(|e| failed(&self.path, &e))
    }

    /// Appends rows byte for byte.
    pub fn append_bytes(&mut self, rows: &[u8]) -> Result<(), Error> {
        self.writer.flush().map_err(Error::io(&self.path))?;
        self.writer.get_ref().append(rows).map_err(Error::io(&self.path))
    }

    /// Flushes everything to the operating system and returns the table's length.
    pub fn flush(&mut self) -> Result<u64, Error> {
        self.writer.flush().map_err(Error::io(&self.path))?;
        Ok(self.writer.get_ref().length())
    }

    /// Asks the disk to keep all that the last [`flush`](CsvFile::flush) has written.
    pub fn sync(&self) -> Result<(), Error> {
        self.writer.get_ref().sync().map_err(Error::io(&self.path))
    }

    /// Refuses a table whose file was replaced or changed.
    pub fn check(&self) -> Result<(), Error> {
        let bytes = read_regular(&self.path)?;
        if bytes.len() as u64 == self.writer.get_ref().length() && digest(&bytes) == self.digest() {
            return Ok(());
        }
        let cure = "its rows are lost; start a new run, and leave its folder alone";
        Err(Error::new(&self.path, format!("another program changed it while the run was writing it: {cure}")))
    }

    /// Removes the bytes beyond this length. Nothing can be appended after that.
    pub fn cut(&mut self, length: u64) -> Result<(), Error> {
        self.flush()?;
        self.writer.get_ref().cut(length).map_err(Error::io(&self.path))
    }

    /// The SHA-256, in hex digits, of all that the last [`flush`](CsvFile::flush) has written.
    pub fn digest(&self) -> String {
        self.writer.get_ref().digest()
    }
}

/// Refuses to add rows to a table that another version of the tool began: its rows have fewer fields.
pub(super) fn check_columns(path: &Path, bytes: &[u8], columns: &[&str]) -> Result<(), Error> {
    let length = usize::try_from(header_length(bytes)).unwrap_or(bytes.len());
    if bytes[..length].trim_ascii_end() == columns.join(",").as_bytes() {
        return Ok(());
    }
    let message = "another version of the tool wrote this table, with other columns; only that version can add rows";
    Err(Error::at(path, 1, message))
}

/// The message about a file that is not as the run has left it.
pub(super) const CHANGED: &str = "its content differs from what the run wrote, according to state.json; \
     restore both files from a copy, or start a new run";

fn shortened(path: &Path, found: u64, length: u64) -> Error {
    let cure = "restore both files from a copy, or start a new run";
    Error::new(
        path,
        format!(
            "{found} bytes are left of the {length} that the run wrote, according to state.json; \
                              {cure}"
        ),
    )
}

/// A table as text.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Text {
    path: PathBuf,
    pub header: StringRecord,
    /// Each row with its line.
    pub rows: Vec<(u64, StringRecord)>,
    /// True if the file has rows that are missing here.
    pub is_part: bool,
}

impl Text {
    /// The rows, parsed into their type.
    pub fn typed<R: Row>(&self) -> Result<Rows<R>, Error> {
        let Text { path, header, rows, is_part } = self;
        let is_later = |column: &&str| R::LATER.contains(column) && *header != *R::COLUMNS;
        let (later, written): (Vec<&str>, Vec<&str>) = R::COLUMNS.iter().partition(|column| is_later(column));
        if *header != *written {
            let expected = R::COLUMNS.join(",");
            return Err(Error::at(path, 1, format!("the columns must be {expected}")));
        }
        let whole: StringRecord = written.iter().chain(&later).collect();
        let typed = rows.iter().map(|(line, record)| {
            let mut record = record.clone();
            later.iter().for_each(|_| record.push_field("0"));
            let row: R = record.deserialize(Some(&whole)).map_err(|e| failed(path, &e))?;
            row.check().map_err(|error| Error::at(path, *line, error.to_string()))?;
            Ok((*line, row))
        });
        Ok(Rows::read(typed.collect::<Result<Vec<_>, Error>>()?, *is_part))
    }
}

impl Text {
    /// Refuses two rows with equal cells in these columns.
    pub fn check_unique(&self, columns: &[&str]) -> Result<(), Error> {
        let places: Option<Vec<usize>> =
            columns.iter().map(|column| self.header.iter().position(|head| head == *column)).collect();
        let Some(places) = places else { return Ok(()) };
        let mut seen = HashMap::new();
        for (line, row) in &self.rows {
            let key: Vec<&str> = places.iter().map(|&place| row.get(place).unwrap_or_default()).collect();
            let named = key.join(", ");
            if let Some(first) = seen.insert(key, line) {
                let message = format!("{named} is in line {first} already; two processes have written this run");
                return Err(Error::at(&self.path, *line, message));
            }
        }
        Ok(())
    }

    /// The rows as text, if the table has these columns.
    pub fn records(&self, table: TableSpec) -> Vec<Record> {
        let rows = self.rows.iter().filter(|_| self.header == *table.columns);
        rows.map(|(_, row)| Record { file: table.file, fields: row.iter().map(str::to_owned).collect() }).collect()
    }
}

/// The extent of a table that is to be read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Extent {
    /// This number of bytes, and the file has to end there: the run is complete.
    All(u64),
    /// The first bytes, by number: the rest belongs to an unfinished scene.
    First(u64),
    /// All whole lines; an incomplete last line is left out. The length is not recorded.
    Lines,
}

impl Extent {
    /// The extent of a table that the run has written.
    pub fn of(state: &State, file: &str) -> Extent {
        match state.committed.get(file) {
            Some(&length) if state.outcome == Outcome::Complete => Extent::All(length),
            Some(&length) => Extent::First(length),
            None => Extent::Lines,
        }
    }

    /// Refuses a file of another length.
    pub fn check(self, found: u64, path: &Path) -> Result<(), Error> {
        match self {
            Extent::All(length) | Extent::First(length) if found < length => Err(shortened(path, found, length)),
            Extent::All(length) if found > length => {
                let message = format!(
                    "{} bytes were added after the run was complete, according to state.json; restore both files \
                     from a copy",
                    found - length
                );
                Err(Error::new(path, message))
            }
            _ => Ok(()),
        }
    }
}

/// Reads a table and checks its digest if one is given. The second value describes what was left out.
pub(super) fn read(path: &Path, extent: Extent, written: Option<&String>) -> Result<(Text, Option<String>), Error> {
    let mut bytes = read_regular(path)?;
    let found = bytes.len() as u64;
    let mut warning = None;
    extent.check(found, path)?;
    match extent {
        Extent::All(_) => {}
        Extent::First(length) => {
            if found > length {
                let message = format!("{} bytes of an unfinished scene were left out", found - length);
                warning = Some(Error::new(path, message).to_string());
            }
            bytes.truncate(usize::try_from(length).unwrap_or(usize::MAX));
        }
        Extent::Lines => {
            let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |last| last + 1);
            if whole < bytes.len() {
                let lines = bytes[..whole].iter().filter(|&&b| b == b'\n').count() as u64;
                warning = Some(Error::at(path, lines + 1, "the last line is cut off and was left out").to_string());
            }
            bytes.truncate(whole);
        }
    }
    if written.is_some_and(|written| *written != digest(&bytes)) {
        return Err(Error::new(path, CHANGED));
    }
    let mut reader = ReaderBuilder::new().from_reader(bytes.as_slice());
    let header = reader.headers().map_err(|e| failed(path, &e))?.clone();
    let mut rows = Vec::new();
    let mut record = StringRecord::new();
    let mut lines = Lines { bytes: &bytes, at: 0, line: 1 };
    loop {
        let start = reader.position().byte();
        match reader.read_record(&mut record) {
            Ok(false) => break,
            Ok(true) => rows.push((lines.of(start), record.clone())),
            Err(error) => return Err(failed(path, &error)),
        }
    }
    Ok((Text { path: path.to_owned(), header, rows, is_part: false }, warning))
}

/// Line numbers as an editor counts them. The CSV reader starts a record at the end of the previous one: before the
/// line feed of a two-character line end, and before empty lines.
struct Lines<'b> {
    bytes: &'b [u8],
    at: usize,
    line: u64,
}

impl Lines<'_> {
    /// The line of a record that starts here, or after line ends that are here. Starts must be given in ascending
    /// order.
    fn of(&mut self, start: u64) -> u64 {
        let start = usize::try_from(start).unwrap_or(usize::MAX);
        while let Some(byte) = self.bytes.get(self.at)
            && (self.at < start || matches!(byte, b'\r' | b'\n'))
        {
            self.line += u64::from(*byte == b'\n');
            self.at += 1;
        }
        self.line
    }
}

pub(super) fn failed(path: &Path, error: &csv::Error) -> Error {
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("there are {len} fields, and there should be {expected_len}")
        }
        csv::ErrorKind::Deserialize { err, .. } => err.to_string(),
        csv::ErrorKind::Io(err) => with_cure(err),
        _ => error.to_string(),
    };
    match error.position() {
        Some(position) => Error::at(path, position.line(), message),
        None => Error::new(path, message),
    }
}
