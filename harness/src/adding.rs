//! Adds a scene to a suite file that the user may edit too; all other text stays as it is.

use std::io::ErrorKind;
use std::ops::Range;
use std::path::Path;

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_records::replace;
use predicament_search::shrink::Size;

use crate::exit::Failure;
use crate::line_ends::{is_crlf, to_crlf, to_lf};
use crate::out::hold;
use crate::tool::Tool;

/// The prefix of the `source` of a scene that `shrink` wrote.
const SHRUNK: &str = "shrunk from ";

/// Adds a scene, given as a `[[scene]]` table, to a suite file.
/// A larger scene with the same name is replaced if `shrink` wrote it. If the suite already has the same scene, or a
/// smaller one from `shrink`, a note says so and the file does not change.
///
/// # Errors
/// If the file can't be read or written, or the result is not a valid suite. Then nothing is written.
pub fn add(tool: &Tool, file: &Path, table: &str) -> Result<(), Failure> {
    let _hold = hold(file)?;
    let before = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => "title = \"Shrunk findings\"\n".to_owned(),
        Err(error) => return Err(Failure::io(file)(error)),
    };
    let is_crlf = is_crlf(&before);
    let text = if is_crlf { to_lf(&before) } else { before };
    let new = alone(tool, table)?;
    let mut replaced = None;
    // A suite without scenes does not parse yet. Any other error is reported when the result is parsed.
    for def in parsed(tool, file, &text).into_iter().flat_map(|suite| suite.scenes) {
        if !def.is_written() {
            continue;
        }
        let old = def.load(Level::Quick, &Cache::new(""))?;
        let is_its = def.name == new.name && def.source.starts_with(SHRUNK);
        if old.id == new.id || (is_its && size(&old) <= size(&new)) {
            let has = if old.id == new.id { "has this scene" } else { "has an equally small scene" };
            note!("{}: nothing was added: it already {has} in line {}, `{}`", file.display(), def.line, def.name);
            return Ok(());
        }
        if is_its {
            replaced = Some(table_at(&text, def.line));
        }
    }
    let replaced = replaced.unwrap_or(text.len()..text.len());
    let kept = format!("{}{}", &text[..replaced.start], &text[replaced.end..]);
    let text = format!("{}\n\n{table}", kept.trim_end());
    parsed(tool, file, &text)?;
    let text = if is_crlf { to_crlf(&text) } else { text };
    replace(file, text.as_bytes()).map_err(Failure::usage)
}

fn parsed(tool: &Tool, file: &Path, text: &str) -> Result<Suite, Failure> {
    let name = file.display().to_string();
    Ok(Suite::parse(tool.vocabulary(), &name, text, file.parent(), &Manifest::default())?)
}

/// The only scene of a table.
fn alone(tool: &Tool, table: &str) -> Result<LoadedScene, Failure> {
    let suite = parsed(tool, Path::new("shrunk.toml"), &format!("title = \"One\"\n\n{table}"))?;
    let def = suite.scenes.first().ok_or_else(|| Failure::usage("the run has no scene to add"))?;
    Ok(def.load(Level::Quick, &Cache::new(""))?)
}

/// The size of a scene, or `None` if its task does not write scenes out.
fn size(scene: &LoadedScene) -> Option<Size> {
    scene.spelled().as_ref().map(Size::of)
}

/// The byte range of the table whose header is on this line (from 1), without the comments before the next table.
fn table_at(text: &str, line: usize) -> Range<usize> {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let first = line.saturating_sub(1).min(lines.len());
    let rest = lines.get(first + 1..).unwrap_or_default();
    let mut end = first + 1 + rest.iter().position(|line| is_head(line)).unwrap_or(rest.len());
    while end > first + 1 && is_between(lines[end - 1]) {
        end -= 1;
    }
    let at = |line: usize| lines[..line.min(lines.len())].iter().map(|line| line.len()).sum();
    at(first)..at(end)
}

/// True if a line begins a table, such as `[[generate]] # more`. A row of an array begins with a number.
fn is_head(line: &str) -> bool {
    let name = line.trim_start().trim_start_matches('[').trim_start();
    line.trim_start().starts_with('[') && name.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// True if a line is empty or has only a comment.
fn is_between(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_ends_before_the_next_of_any_kind() {
        let text = "title = \"a\"\n[[scene]]\nname = \"b\"\npoints = [\n[0, 1],\n[[2], 3],\n]\n\n# of the next\n  [[generate]] # c\nn = 1\n";
        let of = |line| &text[table_at(text, line)];
        assert_eq!(of(2), "[[scene]]\nname = \"b\"\npoints = [\n[0, 1],\n[[2], 3],\n]\n");
        assert_eq!(of(10), "  [[generate]] # c\nn = 1\n");
        assert_eq!(of(99), "");
    }
}
