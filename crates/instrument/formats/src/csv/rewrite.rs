//! Rewrites the decimals of a CSV file that are not prints of doubles as hex floats.

use super::cells::Scanner;
use super::commas::Commas;
use super::{Chosen, Columns, Layout, columns, is_misplaced, is_name, pick, wrong};
use crate::coordinate::{self, CoordinateError};
use crate::file::BOM;
use crate::lines::{Line, lines};
use crate::{CorpusError, hexfloat};

/// Rewrites the decimals of a CSV file that are not exactly doubles: each becomes the hex float of its nearest
/// double, and a comment line before its row keeps the original text. All other bytes stay. So a file without such
/// decimals, and a file that was already rewritten, are returned unchanged.
///
/// Without `columns` it rewrites all columns. If the header names coordinate columns besides other columns, it rewrites
/// only the coordinate columns.
///
/// # Errors
/// [`CorpusError`] if a cell is not a number in the range of doubles, or a column does not exist.
pub fn fmt_csv(file: &str, text: &str, columns: Option<&Columns>) -> Result<String, CorpusError> {
    let (mark, rest) = text.strip_prefix(BOM).map_or(("", text), |rest| (&text[..BOM.len_utf8()], rest));
    let (mut scanner, mut commas) = (Scanner::default(), Commas::default());
    let (mut layout, mut cells) = (None, Vec::new());
    let mut out = String::with_capacity(text.len());
    out.push_str(mark);
    // A last line without an end takes that of the line before it.
    let mut usual_end = "\n";
    for Line { number, body, end } in lines(rest) {
        let error = |(message, cure): (String, String)| CorpusError::file(file, message, cure).at_line(number);
        if !scanner.cells(body, &mut cells).map_err(error)? {
            out.extend([body, end]);
            continue;
        }
        let layout = match &layout {
            Some(layout) => layout,
            None => {
                let first: Vec<&str> = cells.iter().map(|cell| &body[cell.clone()]).collect();
                let found = layout.insert(of(&first, columns).map_err(error)?);
                if found.is_header() {
                    out.extend([body, end]);
                    continue;
                }
                found
            }
        };
        usual_end = if end.is_empty() { usual_end } else { end };
        let (mut decimals, mut edits) = (Vec::new(), Vec::new());
        pick(layout, &mut cells).map_err(error)?;
        for (place, cell) in cells.iter().cloned().enumerate() {
            let text = &body[cell.clone()];
            let decimal = commas.number(scanner.separator(), text, number).map_err(error)?;
            match coordinate::read(&decimal) {
                Ok(_) => {}
                Err(CoordinateError::Inexact { nearest }) => {
                    edits.push((cell, hexfloat::format(nearest)));
                    decimals.push(text);
                }
                Err(why) => return Err(error(wrong(file, layout, (place, text), scanner.separator(), &why))),
            }
        }
        if !decimals.is_empty() {
            let between = if commas.are_decimal() { "; " } else { ", " };
            out.extend(["# ", &decimals.join(between), usual_end]);
        }
        // Columns may be named in another order than that of the file.
        edits.sort_by_key(|(cell, _)| cell.start);
        let mut at = 0;
        for (cell, hex) in edits {
            out.extend([&body[at..cell.start], &hex]);
            at = cell.end;
        }
        out.extend([&body[at..], end]);
    }
    Ok(out)
}

/// The columns to rewrite. An error is a message and its cure.
fn of(first: &[&str], columns: Option<&Columns>) -> Result<Layout, (String, String)> {
    let is_header = first.iter().all(|cell| is_name(cell));
    // Columns such as x, y, z and an edge are all numbers.
    let recognised = columns::recognised(first).filter(|_| !is_header || is_misplaced(first));
    match columns.or(recognised.as_ref().map(|found| &found.columns)) {
        Some(columns) => Chosen::find(columns, first).map(Layout::Some),
        None => Ok(Layout::All { is_header }),
    }
}
