//! Parts of a report in a page of your own: what stands between two marks is replaced.
//!
//! `<!-- predicament: glance -->` and `<!-- /predicament -->` hold the section `glance`; `glance tables` only its tables.

use crate::page::section_markdown;
use crate::sections::sections;
use crate::table::{Block, Section};
use crate::{Error, RunDir};

const OPEN: &str = "<!-- predicament: ";
const CLOSE: &str = "<!-- /predicament -->";
const END: &str = " -->";

/// The page with what stands between its marks replaced by the sections that they name, in Markdown, and how many there were.
///
/// # Errors
/// If a mark names no section, has no end, or there is none.
pub fn splice(page: &str, runs: &[RunDir], of_tasks: &[Section]) -> Result<(String, usize), Error> {
    let fail = |line: usize, message: String| Error::new("page".as_ref(), format!("line {line}: {message}"));
    let all = sections(runs, of_tasks)?;
    let (mut text, mut rest, mut count) = (String::new(), page, 0);
    while let Some(start) = rest.find(OPEN) {
        let line = page[..page.len() - rest.len() + start].lines().count() + 1;
        let (before, marked) = rest.split_at(start);
        let (name, after) = marked[OPEN.len()..]
            .split_once(END)
            .ok_or_else(|| fail(line, format!("`{OPEN}` has no `{END}` after it")))?;
        let (_, after) =
            after.split_once(CLOSE).ok_or_else(|| fail(line, format!("there is no `{CLOSE}` after it")))?;
        let (id, only_tables) =
            name.trim().split_once(' ').map_or((name.trim(), false), |(id, what)| (id, what == "tables"));
        let section = all.iter().find(|section| section.id == id).ok_or_else(|| {
            let ids: Vec<&str> = all.iter().map(|section| section.id).collect();
            fail(line, format!("no section is called `{id}`; there are {}", ids.join(", ")))
        })?;
        let mut section = section.clone();
        if only_tables {
            section.lead.clear();
            section.blocks.retain(|block| matches!(block, Block::Table(_)));
        }
        text += &format!("{before}{OPEN}{name}{END}\n{}\n{CLOSE}", section_markdown(&section)?.trim());
        (rest, count) = (after, count + 1);
    }
    if count == 0 {
        return Err(Error::new("page".as_ref(), format!("there is no mark; write `{OPEN}glance{END}` and `{CLOSE}`")));
    }
    Ok((text + rest, count))
}
