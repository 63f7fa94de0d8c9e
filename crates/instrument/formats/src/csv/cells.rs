//! The cells of a row: separators, quotes, and lines to skip.

use std::ops::Range;

/// The separator of cells of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Separator {
    /// A semicolon, a comma or a tab.
    Character(u8),
    /// Any number of blanks.
    Blanks,
}

impl Separator {
    /// The first of `;`, `,` and tab that a row has outside of quotes, else blanks.
    fn of(row: &str) -> Separator {
        let has = |c: &u8| split(row, *c).nth(1).is_some();
        [b';', b',', b'\t'].iter().find(|c| has(c)).map_or(Separator::Blanks, |&c| Separator::Character(c))
    }

    /// Adds the positions of a row's cells, without the blanks and quotes around them.
    fn cells(self, row: &str, cells: &mut Vec<Range<usize>>) {
        match self {
            Separator::Character(c) => cells.extend(split(row, c).map(|cell| bare(row, cell))),
            Separator::Blanks => {
                let start = |word: &str| word.as_ptr().addr() - row.as_ptr().addr();
                cells.extend(row.split_whitespace().map(|word| bare(row, start(word)..start(word) + word.len())));
            }
        }
    }
}

/// The parts of a row between separators in ASCII; separators in quotes do not count.
fn split(row: &str, separator: u8) -> impl Iterator<Item = Range<usize>> {
    let mut quoted = false;
    let mut ends = memchr::memchr2_iter(separator, b'"', row.as_bytes()).filter(move |&at| {
        let is_quote = row.as_bytes()[at] == b'"';
        quoted ^= is_quote;
        !is_quote && !quoted
    });
    let mut start = Some(0);
    std::iter::from_fn(move || {
        let from = start?;
        let to = ends.next();
        start = to.map(|at| at + 1);
        Some(from..to.unwrap_or(row.len()))
    })
}

/// A cell without the blanks around it, and without its quotes.
fn bare(row: &str, cell: Range<usize>) -> Range<usize> {
    // Most cells begin and end with a letter or digit.
    if let [first, .., last] = row.as_bytes()[cell.clone()]
        && first.is_ascii_alphanumeric() | (first == b'-')
        && last.is_ascii_alphanumeric()
    {
        return cell;
    }
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
    let is_begun = line.as_bytes().first().is_some_and(u8::is_ascii_alphanumeric);
    !is_begun && (line.trim().is_empty() || line.trim_start().starts_with('#'))
}

/// Splits the lines of a file into cells, in their order. The first row determines the separator.
#[derive(Default)]
pub(super) struct Scanner {
    separator: Option<Separator>,
}

impl Scanner {
    /// Replaces `cells` by those of a line; false for a blank line or a comment. An error is a message and its cure.
    pub(super) fn cells(&mut self, line: &str, cells: &mut Vec<Range<usize>>) -> Result<bool, (String, String)> {
        if skipped(line) {
            return Ok(false);
        }
        let quote = memchr::memchr(b'"', line.as_bytes());
        if quote.is_some_and(|at| memchr::memchr_iter(b'"', &line.as_bytes()[at..]).count() % 2 == 1) {
            let cure = "close it in its line: a row is one line, and its cells have no line breaks";
            return Err(("a quote that is not closed".to_owned(), cure.to_owned()));
        }
        cells.clear();
        self.separator.get_or_insert_with(|| Separator::of(line)).cells(line, cells);
        Ok(true)
    }

    /// The separator; `None` before the first row.
    pub(super) fn separator(&self) -> Option<Separator> {
        self.separator
    }
}
