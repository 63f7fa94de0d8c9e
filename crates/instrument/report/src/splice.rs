//! Splicing parts of a report into the user's own page: the text between two marks is replaced.
//!
//! `<!-- predicament: glance -->` and `<!-- /predicament -->` enclose the section `glance`; `glance tables` means only
//! its tables. The caller may provide its own parts, such as the tables and sentences of a study.

use crate::page::section_markdown;
use crate::sections::sections;
use crate::table::{Block, Section};
use crate::{Error, RunDir};

const OPEN: &str = "<!-- predicament: ";
const CLOSE: &str = "<!-- /predicament -->";
const END: &str = " -->";

/// A function from the name of a part to its Markdown: `None` for an unknown name, a one-line error for a part that
/// can't be made.
pub type Part<'a> = dyn Fn(&str) -> Option<Result<String, String>> + 'a;

/// The page with the text between its marks replaced by the named sections or parts, in Markdown, and the number of
/// replacements.
///
/// A page whose lines all end with CR LF keeps these line ends.
///
/// # Errors
/// If there is no mark, or a mark has no end or is not closed before the next one. Also if a mark names an unknown
/// section or part, or one that can't be made.
pub fn splice(page: &str, runs: &[RunDir], of_tasks: &[Section], part: &Part<'_>) -> Result<(String, usize), Error> {
    let all = sections(runs, of_tasks)?;
    let (mut text, mut rest, mut count) = (String::new(), page, 0);
    while let Some(start) = rest.find(OPEN) {
        let line = page[..page.len() - rest.len() + start].matches('\n').count() + 1;
        let (before, marked) = rest.split_at(start);
        let (name, after) = held(marked, line)?;
        let filled = match part(name.trim()) {
            Some(part) => part.map_err(|why| fail(line, &why))?,
            None => section_markdown(&named(name, &all, line)?)?,
        };
        text += &format!("{before}{OPEN}{name}{END}\n{}\n{CLOSE}", filled.trim());
        (rest, count) = (after, count + 1);
    }
    if count == 0 {
        return Err(Error::new("page".as_ref(), format!("there is no mark; write `{OPEN}glance{END}` and `{CLOSE}`")));
    }
    Ok((with_line_ends_of(page, text + rest), count))
}

fn fail(line: usize, message: &str) -> Error {
    Error::new("page".as_ref(), format!("line {line}: {message}"))
}

/// The name in the mark at the start of a text, and the text after its closing mark.
fn held(marked: &str, line: usize) -> Result<(&str, &str), Error> {
    let (name, after) =
        marked[OPEN.len()..].split_once(END).ok_or_else(|| fail(line, &format!("`{OPEN}` has no `{END}` after it")))?;
    // An unclosed mark may span many lines.
    let shown = name.lines().next().unwrap_or_default();
    let open = |before: &str| {
        fail(line, &format!("`{OPEN}{shown}{END}` is not closed{before}; write `{CLOSE}` where its part ends"))
    };
    let (part, after) = after.split_once(CLOSE).ok_or_else(|| open(""))?;
    match part.find(OPEN) {
        // All text up to there is the user's own.
        Some(next) => {
            let lines = name.matches('\n').count() + part[..next].matches('\n').count();
            Err(open(&format!(" before line {}, where the next mark is", line + lines)))
        }
        None => Ok((name, after)),
    }
}

/// The section that a mark names, or only its tables.
fn named(name: &str, all: &[Section], line: usize) -> Result<Section, Error> {
    let (id, only_tables) =
        name.trim().split_once(' ').map_or((name.trim(), false), |(id, what)| (id, what == "tables"));
    let section = all.iter().find(|section| section.id == id).ok_or_else(|| {
        let ids: Vec<&str> = all.iter().map(|section| section.id).collect();
        fail(line, &format!("no section is called `{id}`; there are {}", ids.join(", ")))
    })?;
    let mut section = section.clone();
    if only_tables {
        section.lead.clear();
        section.blocks.retain(|block| matches!(block, Block::Table(_)));
    }
    Ok(section)
}

/// The text with CR LF line ends, if all lines of the page have them.
fn with_line_ends_of(page: &str, text: String) -> String {
    let [all, windows] = ["\n", "\r\n"].map(|end| page.matches(end).count());
    if all > 0 && all == windows { text.replace("\r\n", "\n").replace('\n', "\r\n") } else { text }
}
