//! Rows of numbers: written out in a suite, or in a CSV file beside it.

use std::path::Path;

use predicament_predicates::Dimension;

use crate::CorpusError;
use crate::coordinate;
use crate::document::{Field, explain};

/// What the rows of a list of numbers are.
pub struct RowKind {
    /// What one is called.
    pub name: &'static str,
    /// How many numbers it has.
    pub widths: std::ops::RangeInclusive<usize>,
    /// What its numbers are called.
    pub numbers: &'static str,
    /// How to mend one that has another number of them.
    pub cure: &'static str,
}

/// A point of two or three coordinates.
pub const POINT: RowKind = RowKind {
    name: "point",
    widths: 2..=3,
    numbers: "coordinates",
    cure: "give all points two or all three coordinates",
};

/// Rows of as many numbers each, one after the other, and the line of each row.
pub struct Rows {
    /// Numbers in a row.
    pub width: usize,
    /// All numbers, row after row.
    pub numbers: Vec<f64>,
    /// The line of each row, from 1.
    pub lines: Vec<usize>,
}

impl Rows {
    /// With the width of the first row, if it is one of the kind's.
    fn check(kind: &RowKind, expected: &mut Option<usize>, index: usize, found: usize) -> Result<(), String> {
        let RowKind { name, numbers, widths, .. } = kind;
        let expected = *expected.get_or_insert(found);
        if !widths.contains(&expected) {
            Err(format!("{name} {index} has {found} {numbers}"))
        } else if found != expected {
            Err(format!("{name} {index} has {found} {numbers}, the {name}s before it {expected}"))
        } else {
            Ok(())
        }
    }

    /// As points.
    #[must_use]
    pub fn points(self) -> (Dimension, Vec<f64>) {
        (if self.width == 2 { Dimension::Two } else { Dimension::Three }, self.numbers)
    }
}

/// Points in a suite, one array each.
pub fn read_points(field: &Field<'_, '_>) -> Result<(Dimension, Vec<f64>), CorpusError> {
    read_rows(field, &POINT).map(Rows::points)
}

/// Rows of numbers in a suite, one array each.
pub fn read_rows(field: &Field<'_, '_>, kind: &RowKind) -> Result<Rows, CorpusError> {
    let RowKind { name, numbers: of, .. } = kind;
    let rows = field.items(&format!("an array of {name}s, or {{ path = \"{name}s.csv\" }}"))?;
    let mut width = None;
    let (mut numbers, mut lines) = (Vec::with_capacity(rows.len() * 3), Vec::with_capacity(rows.len()));
    for (index, row) in rows.enumerate() {
        let cells = row.items(&format!("a {name}: an array of {of}"))?;
        Rows::check(kind, &mut width, index, cells.len()).map_err(|message| row.error(message, kind.cure))?;
        for cell in cells {
            numbers.push(cell.coordinate()?);
        }
        lines.push(row.line());
    }
    let none = || field.error(format!("a scene without {name}s"), format!("write at least one {name}"));
    Ok(Rows { width: width.ok_or_else(none)?, numbers, lines })
}

/// Reads a data file beside a suite.
pub fn read_text(path: &Path) -> Result<String, CorpusError> {
    std::fs::read_to_string(path).map_err(|error| unreadable(path, &error))
}

/// What is in a data file, whatever it is.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, CorpusError> {
    std::fs::read(path).map_err(|error| unreadable(path, &error))
}

fn unreadable(path: &Path, error: &std::io::Error) -> CorpusError {
    CorpusError::file(
        path.display().to_string(),
        format!("the data file can't be read: {}", error.kind()),
        "put the file there or correct `path`",
    )
}

/// A CSV file of points.
pub fn read_csv(path: &Path) -> Result<(Dimension, Vec<f64>), CorpusError> {
    read_csv_rows(path, &POINT).map(Rows::points)
}

/// A CSV file of rows of numbers: one a line, separated by commas, no header;
/// blank lines and lines that start with `#` are skipped.
pub fn read_csv_rows(path: &Path, kind: &RowKind) -> Result<Rows, CorpusError> {
    let file = path.display().to_string();
    let text = read_text(path)?;
    let mut width = None;
    let (mut numbers, mut lines) = (Vec::new(), Vec::new());
    let rows = text.lines().enumerate().filter(|(_, line)| !skipped(line));
    for (index, (at, line)) in rows.enumerate() {
        let error = |message: String, cure: String| CorpusError::file(&file, message, cure).at_line(at + 1);
        let cells: Vec<_> = line.split(',').map(str::trim).collect();
        Rows::check(kind, &mut width, index, cells.len()).map_err(|message| error(message, kind.cure.into()))?;
        for cell in cells {
            let value = coordinate::exact(cell).map_err(|why| {
                let (message, cure) = explain(&file, cell, &why);
                error(message, cure)
            })?;
            numbers.push(value);
        }
        lines.push(at + 1);
    }
    let none = || {
        let RowKind { name, .. } = kind;
        CorpusError::file(&file, format!("the file has no {name}s"), format!("write one {name} a line"))
    };
    Ok(Rows { width: width.ok_or_else(none)?, numbers, lines })
}

/// Whether a line of a data file is blank or a comment.
#[must_use]
pub fn skipped(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}
