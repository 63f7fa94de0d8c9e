//! CSV files of numbers: a row-by-row reader, and a lossless rewriter.
//!
//! Commas, semicolons, tabs or blanks separate cells: the first row determines which. Blank lines and lines that start
//! with `#` are skipped. The first row is a header if each of its cells starts with a letter and none is a number.
//!
//! The crate `csv` gives the text of cells but not their positions in the file. Positions are needed to rewrite a
//! number and leave all other bytes unchanged, and to report the line of an error after comments and blank lines.

use std::ops::Range;

use crate::coordinate::{self, CoordinateError};
use crate::decimals::{Place, explain, shown};
use crate::file::BOM;
use crate::lines::{Line, lines};
use crate::rows::{RowKind, Rows};
use crate::{CorpusError, Decimals, hexfloat};

/// The separator of a file's cells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Separator {
    Character(char),
    Blanks,
}

impl Separator {
    /// The separator of a row: the first of `;`, `,` and tab that occurs outside of quotes, else blanks.
    fn of(row: &str) -> Separator {
        let has = |c: &char| split(row, *c).nth(1).is_some();
        [';', ',', '\t'].iter().find(|c| has(c)).map_or(Separator::Blanks, |&c| Separator::Character(c))
    }

    /// The byte ranges of a row's cells, without blanks and quotes around them.
    fn cells(self, row: &str) -> Vec<Range<usize>> {
        match self {
            Separator::Character(c) => split(row, c).map(|cell| bare(row, cell)).collect(),
            Separator::Blanks => {
                let start = |word: &str| word.as_ptr().addr() - row.as_ptr().addr();
                row.split_whitespace().map(|word| bare(row, start(word)..start(word) + word.len())).collect()
            }
        }
    }
}

/// The parts of a row between separators that are not in quotes.
fn split(row: &str, separator: char) -> impl Iterator<Item = Range<usize>> {
    let mut quoted = false;
    let mut ends = row.char_indices().filter(move |&(_, c)| {
        quoted ^= c == '"';
        c == separator && !quoted
    });
    let mut start = Some(0);
    std::iter::from_fn(move || {
        let from = start?;
        let to = ends.next();
        start = to.map(|(at, c)| at + c.len_utf8());
        Some(from..to.map_or(row.len(), |(at, _)| at))
    })
}

/// The range of a cell without surrounding blanks and quotes.
fn bare(row: &str, cell: Range<usize>) -> Range<usize> {
    let trimmed = |cell: Range<usize>| {
        let text = &row[cell.clone()];
        let start = cell.start + (text.len() - text.trim_start().len());
        start..start + text.trim().len()
    };
    let cell = trimmed(cell);
    let quoted = &row[cell.clone()];
    if quoted.len() >= 2 && quoted.starts_with('"') && quoted.ends_with('"') {
        trimmed(cell.start + 1..cell.end - 1)
    } else {
        cell
    }
}

/// True if a line of a data file is blank or a comment.
#[must_use]
pub fn skipped(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}

/// The kind of a line, with its cells if it has any.
enum Kind {
    Skipped,
    Header(Vec<Range<usize>>),
    Row(Vec<Range<usize>>),
}

/// A scanner that classifies the lines of a file in order.
#[derive(Default)]
struct Scanner {
    separator: Option<Separator>,
}

impl Scanner {
    /// The kind of a line; the error is a message and its fix.
    fn kind(&mut self, line: &str) -> Result<Kind, (String, String)> {
        if skipped(line) {
            return Ok(Kind::Skipped);
        }
        if line.matches('"').count() % 2 == 1 {
            let cure = "close it in its line: a row is one line, and its cells have no line breaks";
            return Err(("a quote that is not closed".to_owned(), cure.to_owned()));
        }
        if let Some(separator) = self.separator {
            return Ok(Kind::Row(separator.cells(line)));
        }
        let cells = self.separator.insert(Separator::of(line)).cells(line);
        let names = cells.iter().all(|cell| is_name(&line[cell.clone()]));
        Ok(if names { Kind::Header(cells) } else { Kind::Row(cells) })
    }
}

/// True if a cell of the first row can be the name of a column.
fn is_name(cell: &str) -> bool {
    let starts = cell.starts_with(|c: char| c.is_alphabetic() || c == '_');
    starts && coordinate::read(cell) == Err(CoordinateError::Malformed)
}

/// The error for a header with another name among x, y and z, with these in another order, or with a column that
/// numbers the rows. Reading such a file would misinterpret it.
fn misplaced(names: &[&str]) -> Option<String> {
    const AXES: [&str; 3] = ["x", "y", "z"];
    const NUMBERS: [&str; 3] = ["id", "fid", "index"];
    let lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let is = |name: &String, among: [&str; 3]| among.contains(&name.as_str());
    let named = lower.iter().any(|name| is(name, AXES));
    let wrong =
        lower.iter().zip(AXES).any(|(name, axis)| name != axis) || lower.iter().skip(3).any(|name| is(name, AXES));
    let numbered = lower.iter().any(|name| is(name, NUMBERS));
    // Three columns with other names may be a row number, a longitude and a latitude.
    let unnamed = !named && names.len() >= 3;
    // Latitude before longitude would turn the map on its side.
    const NORTH: [&str; 3] = ["lat", "latitude", "northing"];
    let turned = lower.first().is_some_and(|name| is(name, NORTH));
    (numbered || unnamed || turned || named && wrong).then(|| format!("the columns are {}", shown(&names.join(", "))))
}

/// Reads a CSV file with one row of numbers per line.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub(crate) fn read(file: &str, text: &str, kind: &RowKind, decimals: &Decimals) -> Result<Rows, CorpusError> {
    let mut scanner = Scanner::default();
    let mut rows = Rows::default();
    let mut width = None;
    for Line { number, body, .. } in lines(text) {
        let error = |(message, cure): (String, String)| CorpusError::file(file, message, cure).at_line(number);
        let cells = match scanner.kind(body).map_err(error)? {
            Kind::Skipped => continue,
            Kind::Header(cells) => {
                let names: Vec<&str> = cells.into_iter().map(|cell| &body[cell]).collect();
                if let Some(message) = misplaced(&names) {
                    let cure = "write the columns x, y and z in this order and no other among them; x is the longitude, y the latitude";
                    return Err(error((message, cure.into())));
                }
                width = Some(names.len());
                if !kind.widths.contains(&names.len()) {
                    let message = format!("the header has {} columns", names.len());
                    return Err(error((message, kind.cure.into())));
                }
                continue;
            }
            Kind::Row(cells) => cells,
        };
        kind.check(&mut width, rows.lines.len(), cells.len()).map_err(|message| error((message, kind.cure.into())))?;
        for cell in cells {
            let cell = &body[cell];
            let x = decimals.read(cell).map_err(|why| error(explain(Place::Tidied(file), cell, &why)))?;
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

/// Rewrites the decimals of a CSV file that are not exactly doubles: each becomes the hex float of its nearest double,
/// and a `#` line before its row keeps the original text. All other bytes stay. Files without such decimals, and files
/// that were already rewritten, are returned unchanged.
///
/// # Errors
/// [`CorpusError`] if a cell is not a number within the range of doubles.
pub fn fmt_csv(file: &str, text: &str) -> Result<String, CorpusError> {
    let (mark, rest) = text.strip_prefix(BOM).map_or(("", text), |rest| (&text[..BOM.len_utf8()], rest));
    let mut scanner = Scanner::default();
    let mut out = String::with_capacity(text.len());
    out.push_str(mark);
    // A last line without an end uses the end of the line before it.
    let mut usual_end = "\n";
    for Line { number, body, end } in lines(rest) {
        let error = |(message, cure): (String, String)| CorpusError::file(file, message, cure).at_line(number);
        let Kind::Row(cells) = scanner.kind(body).map_err(error)? else {
            out.extend([body, end]);
            continue;
        };
        usual_end = if end.is_empty() { usual_end } else { end };
        let (mut decimals, mut row, mut at) = (Vec::new(), String::new(), 0);
        for cell in cells {
            match coordinate::read(&body[cell.clone()]) {
                Ok(_) => {}
                Err(CoordinateError::Inexact { nearest }) => {
                    row.extend([&body[at..cell.start], &hexfloat::format(nearest)]);
                    at = cell.end;
                    decimals.push(&body[cell]);
                }
                Err(why) => return Err(error(explain(Place::Tidied(file), &body[cell], &why))),
            }
        }
        if !decimals.is_empty() {
            out.extend(["# ", &decimals.join(", "), usual_end]);
        }
        out.extend([&row, &body[at..], end]);
    }
    Ok(out)
}

#[cfg(test)]
mod tests;
