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
        let line = String::from_utf8(bytes).map_err(|error| fail(error.to_string()))?;
        let line = line.strip_suffix('\n').ok_or_else(|| fail("an empty row".to_owned()))?;
        Ok(Record { file: R::FILE, fields: fields(line) })
    }
}

/// The fields of a line as this crate writes it. A reader of any CSV is prepared for longer than a row takes.
fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut is_quoted, mut rest) = (vec![String::new()], false, line.chars().peekable());
    while let Some(next) = rest.next() {
        match next {
            '"' if !is_quoted => is_quoted = true,
            // Two quotes within quotes are one.
            '"' if rest.next_if_eq(&'"').is_none() => is_quoted = false,
            ',' if !is_quoted => fields.push(String::new()),
            _ => fields.last_mut().expect("a first field").push(next),
        }
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_of_a_line_are_those_that_were_written() {
        let texts = ["", "a", "a,b", "\"", "\"\",", "a\"b\nc", "\r\n", " é ", ",,"];
        for first in texts {
            for last in texts {
                let mut writer = WriterBuilder::new().from_writer(Vec::new());
                writer.write_record([first, "1", last]).expect("a row");
                let line = String::from_utf8(writer.into_inner().expect("no file")).expect("text");
                assert_eq!(fields(line.strip_suffix('\n').expect("a line")), [first, "1", last], "{line:?}");
            }
        }
    }
}
