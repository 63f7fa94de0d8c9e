//! The cells of a row: separators, quotes, and lines to skip.

use std::ops::Range;

/// The separator of cells of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Separator {
    /// A semicolon, a comma or a tab.
    Character(char),
    /// Any number of blanks.
    Blanks,
}

impl Separator {
    /// The first of `;`, `,` and tab that a row has outside of quotes, else blanks.
    fn of(row: &str) -> Separator {
        let has = |c: &char| split(row, *c).nth(1).is_some();
        [';', ',', '\t'].iter().find(|c| has(c)).map_or(Separator::Blanks, |&c| Separator::Character(c))
    }

    /// The positions of a row's cells, without the blanks and quotes around them.
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

/// The parts of a row between separators; separators in quotes do not count.
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

/// A cell without the blanks around it, and without its quotes.
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

/// Splits the lines of a file into cells, in their order. The first row determines the separator.
#[derive(Default)]
pub(super) struct Scanner {
    separator: Option<Separator>,
}

impl Scanner {
    /// The cells of a line; `None` for a blank line or a comment. An error is a message and its cure.
    pub(super) fn cells(&mut self, line: &str) -> Result<Option<Vec<Range<usize>>>, (String, String)> {
        if skipped(line) {
            return Ok(None);
        }
        if line.matches('"').count() % 2 == 1 {
            let cure = "close it in its line: a row is one line, and its cells have no line breaks";
            return Err(("a quote that is not closed".to_owned(), cure.to_owned()));
        }
        Ok(Some(self.separator.get_or_insert_with(|| Separator::of(line)).cells(line)))
    }

    /// The separator; `None` before the first row.
    pub(super) fn separator(&self) -> Option<Separator> {
        self.separator
    }
}
