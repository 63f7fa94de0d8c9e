//! CSV files of numbers: read row by row, and made lossless.
//!
//! Commas, semicolons, tabs or blanks separate cells; the first row determines which. Blank lines and lines that start
//! with `#` are skipped. The first row is a header if each of its cells starts with a letter and is not a number. A
//! file may have other columns besides the coordinates if [`Columns`] names the columns to read.
//!
//! The crate `csv` returns the text of cells, but not their positions in the file. The positions are needed to rewrite
//! a number without changing other bytes, and to report the right line after comments and blank lines.

mod cells;
mod columns;
mod commas;
mod rewrite;

use std::ops::Range;

use crate::coordinate::{self, CoordinateError};
use crate::decimals::{Place, explain};
use crate::lines::{Line, lines};
use crate::rows::{POINT, RowKind, Rows};
use crate::{CorpusError, Decimals};

pub use cells::skipped;
use cells::{Scanner, Separator};
use columns::{Chosen, listed};
pub use columns::{Column, Columns, Recognised};
use commas::Commas;
pub use rewrite::fmt_csv;

/// True if a cell of the first row can be the name of a column.
fn is_name(cell: &str) -> bool {
    cell.starts_with(|c: char| c.is_alphabetic() || c == '_') && !is_number(cell)
}

/// True if a cell is a number, even if it is not a double.
fn is_number(cell: &str) -> bool {
    coordinate::read(cell) != Err(CoordinateError::Malformed)
}

/// True if reading the columns in their order would likely read wrong coordinates: another column is among x, y and z,
/// their order differs, or a column numbers the rows.
fn is_misplaced(names: &[&str]) -> bool {
    const AXES: [&str; 3] = ["x", "y", "z"];
    const NUMBERS: [&str; 3] = ["id", "fid", "index"];
    let lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let is = |name: &String, among: [&str; 3]| among.contains(&name.as_str());
    let named = lower.iter().any(|name| is(name, AXES));
    let wrong =
        lower.iter().zip(AXES).any(|(name, axis)| name != axis) || lower.iter().skip(3).any(|name| is(name, AXES));
    let numbered = lower.iter().any(|name| is(name, NUMBERS));
    // Three columns of other names may be a number, a longitude and a latitude.
    let unnamed = !named && names.len() >= 3;
    // Latitude before longitude would be a map on its side.
    const NORTH: [&str; 3] = ["lat", "latitude", "northing"];
    let turned = lower.first().is_some_and(|name| is(name, NORTH));
    numbered || unnamed || turned || named && wrong
}

/// The layout of the rows, by the first row.
enum Layout {
    /// All cells are read; the first row may be a header.
    All { is_header: bool },
    /// Some columns are read.
    Some(Chosen),
}

/// The requested columns.
#[derive(Clone, Copy)]
pub(crate) enum Wanted<'c> {
    /// All columns, in rows that are not points.
    All,
    /// All columns, in rows that are points.
    Points,
    /// Some columns, in rows that are points.
    Some(&'c Columns),
}

impl Layout {
    /// The layout by the first row. An error is a message and its cure.
    fn of(first: &[&str], wanted: Wanted<'_>, kind: &RowKind) -> Result<Layout, (String, String)> {
        let is_header = first.iter().all(|cell| is_name(cell));
        let refused = |cure: String| Err((format!("the columns are {}", listed(first)), cure));
        match wanted {
            Wanted::Some(columns) => Chosen::find(columns, first).map(Layout::Some),
            Wanted::Points if is_header => {
                let is_read = POINT.widths.contains(&first.len()) && !is_misplaced(first);
                if is_read { Ok(Layout::All { is_header }) } else { refused(cure(first)) }
            }
            Wanted::Points if columns::recognised(first).is_some() => refused(cure(first)),
            Wanted::All if is_header && is_misplaced(first) => {
                refused("write the columns x, y and z in this order, without other columns between them".to_owned())
            }
            Wanted::All if is_header && !kind.widths.contains(&first.len()) => {
                Err((format!("the header has {} columns", first.len()), kind.cure.to_owned()))
            }
            Wanted::All | Wanted::Points => Ok(Layout::All { is_header }),
        }
    }

    fn is_header(&self) -> bool {
        match self {
            Layout::All { is_header } => *is_header,
            Layout::Some(chosen) => chosen.is_header,
        }
    }
}

/// The cure for unclear columns: how to name the columns of x and y. If the header names them unambiguously, the text
/// can be copied as it is.
fn cure(first: &[&str]) -> String {
    let (what, columns, option) = match columns::recognised(first) {
        Some(found) => ("name the columns of x and y", found.columns.toml(), found.columns.to_string()),
        None => {
            ("name the columns of x and y, or give their numbers from 1", "[\"…\", \"…\"]".to_owned(), "…,…".to_owned())
        }
    };
    format!("{what}: `columns = {columns}` beside `path`, or `--columns {option}` on the command line")
}

/// The columns of points that the first row of a file names unambiguously. `None` if the file can be read without named
/// columns, or if the names are ambiguous.
pub(crate) fn recognised(text: &str) -> Option<Recognised> {
    let (mut scanner, mut cells) = (Scanner::default(), Vec::new());
    for Line { body, .. } in lines(text) {
        if !scanner.cells(body, &mut cells).ok()? {
            continue;
        }
        let first: Vec<&str> = cells.iter().map(|cell| &body[cell.clone()]).collect();
        return match Layout::of(&first, Wanted::Points, &POINT) {
            Ok(_) => None,
            Err(_) => columns::recognised(&first),
        };
    }
    None
}

/// Replaces the cells of a row by those to read. An error is a message and its cure.
fn pick(layout: &Layout, cells: &mut Vec<Range<usize>>) -> Result<(), (String, String)> {
    if let Layout::Some(chosen) = layout {
        chosen.check(cells.len())?;
        *cells = chosen.at.iter().map(|&at| cells[at].clone()).collect();
    }
    Ok(())
}

/// The error for a cell and its cure, with the name of the cell's column.
fn wrong(
    file: &str,
    layout: &Layout,
    (place, cell): (usize, &str),
    separator: Option<Separator>,
    why: &CoordinateError,
) -> (String, String) {
    let Layout::Some(chosen) = layout else {
        let (message, cure) = explain(Place::Tidied(file), cell, why);
        return (message, commas_or(separator, cell, why, cure));
    };
    let (message, cure) = explain(Place::Columns(file, &chosen.option), cell, why);
    (format!("{}: {message}", chosen.names[place]), commas_or(separator, cell, why, cure))
}

fn commas_or(separator: Option<Separator>, cell: &str, why: &CoordinateError, cure: String) -> String {
    commas::cure(separator, cell).filter(|_| *why == CoordinateError::Malformed).unwrap_or(cure)
}

/// Reads a CSV file of rows of numbers, one row per line.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub(crate) fn read(
    file: &str,
    text: &str,
    kind: &RowKind,
    wanted: Wanted<'_>,
    decimals: &Decimals,
) -> Result<Rows, CorpusError> {
    let (mut scanner, mut commas, mut rows) = (Scanner::default(), Commas::default(), Rows::default());
    let (mut layout, mut width, mut cells) = (None, None, Vec::new());
    for Line { number, body, .. } in lines(text) {
        let error = |(message, cure): (String, String)| CorpusError::file(file, message, cure).at_line(number);
        if !scanner.cells(body, &mut cells).map_err(error)? {
            continue;
        }
        let layout = match &layout {
            Some(layout) => layout,
            None => {
                let first: Vec<&str> = cells.iter().map(|cell| &body[cell.clone()]).collect();
                let found = layout.insert(Layout::of(&first, wanted, kind).map_err(error)?);
                if found.is_header() {
                    width = matches!(found, Layout::All { .. }).then_some(first.len());
                    continue;
                }
                found
            }
        };
        pick(layout, &mut cells).map_err(error)?;
        kind.check(&mut width, rows.lines.len(), cells.len()).map_err(|message| error((message, kind.cure.into())))?;
        for (place, cell) in cells.iter().cloned().enumerate() {
            let cell = &body[cell];
            let number = commas.number(scanner.separator(), cell, number).map_err(error)?;
            let x = decimals
                .read(&number)
                .map_err(|why| error(wrong(file, layout, (place, cell), scanner.separator(), &why)))?;
            rows.numbers.push(x);
        }
        rows.lines.push(number);
    }
    if rows.lines.is_empty() {
        let RowKind { name, .. } = kind;
        return Err(CorpusError::file(file, format!("the file has no {name}s"), format!("write one {name} a line")));
    }
    rows.width = width.unwrap_or_default();
    Ok(rows)
}

#[cfg(test)]
mod tests;
