//! Parts of a report in a page of your own: what stands between two marks is replaced.
//!
//! `<!-- predicament: glance -->` and `<!-- /predicament -->` hold the section `glance`; `glance tables` only its tables. Whoever splices
//! may have parts of its own, such as the tables and sentences of a study.

use crate::page::section_markdown;
use crate::sections::sections;
use crate::table::{Block, Section};
use crate::{Error, RunDir};

const OPEN: &str = "<!-- predicament: ";
const CLOSE: &str = "<!-- /predicament -->";
const END: &str = " -->";

/// What makes a part by its name, in Markdown: none for a name that it does not know, an error in one line for a part that can't be made.
pub type Part<'a> = dyn Fn(&str) -> Option<Result<String, String>> + 'a;

/// The page with what stands between its marks replaced by the sections or parts that they name, in Markdown, and how many there were.
///
/// A page whose lines all end by CR LF stays one.
///
/// # Errors
/// If a mark names no section and no part, names one that can't be made, has no end, is not closed before the next one, or there is none.
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

/// What the mark in this line names, where a text begins by it, and what comes after its closing mark.
fn held(marked: &str, line: usize) -> Result<(&str, &str), Error> {
    let (name, after) =
        marked[OPEN.len()..].split_once(END).ok_or_else(|| fail(line, &format!("`{OPEN}` has no `{END}` after it")))?;
    // What is not closed may go on for lines.
    let shown = name.lines().next().unwrap_or_default();
    let open = |before: &str| {
        fail(line, &format!("`{OPEN}{shown}{END}` is not closed{before}; write `{CLOSE}` where its part ends"))
    };
    let (part, after) = after.split_once(CLOSE).ok_or_else(|| open(""))?;
    match part.find(OPEN) {
        // All up to there is the user's own text.
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

/// A text with CR LF at the end of each line where all lines of the page end so.
fn with_line_ends_of(page: &str, text: String) -> String {
    let [all, windows] = ["\n", "\r\n"].map(|end| page.matches(end).count());
    if all > 0 && all == windows { text.replace("\r\n", "\n").replace('\n', "\r\n") } else { text }
}
