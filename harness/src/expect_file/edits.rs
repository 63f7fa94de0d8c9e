//! Edits of a text by byte ranges, and the resulting difference as a patch.

use std::ops::Range;

use similar::TextDiff;

use crate::line_ends::{is_crlf, to_crlf};

/// Edits of one text; they do not overlap.
#[derive(Default, Debug)]
pub struct Edits(Vec<(Range<usize>, String)>);

impl Edits {
    /// Replaces these bytes by a text.
    pub fn replace(&mut self, bytes: Range<usize>, with: impl Into<String>) {
        self.0.push((bytes, with.into()));
    }

    /// Inserts a text before this byte.
    pub fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(at..at, text);
    }

    /// The edits with CR LF line ends, if all lines of this text end with CR LF, as Windows editors write them.
    pub fn with_line_ends_of(mut self, text: &str) -> Edits {
        if is_crlf(text) {
            self.0.iter_mut().for_each(|(_, with)| *with = to_crlf(with));
        }
        self
    }

    /// True if there are no edits.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The edited text. Insertions at the same place keep their order.
    pub fn apply(&self, text: &str) -> String {
        let mut edits: Vec<_> = self.0.iter().collect();
        edits.sort_by_key(|(bytes, _)| (bytes.start, bytes.end));
        let (mut made, mut at) = (String::new(), 0);
        for (bytes, with) in edits {
            made += text.get(at..bytes.start).unwrap_or_default();
            made += with;
            at = at.max(bytes.end);
        }
        made + text.get(at..).unwrap_or_default()
    }

    /// The edits as a patch, with three lines of context.
    pub fn patch(&self, file: &str, text: &str) -> String {
        let made = self.apply(text);
        let (old, new) = (lines(text), lines(&made));
        let diff = TextDiff::configure().newline_terminated(true).diff_slices(&old, &new);
        diff.unified_diff().header(file, file).to_string()
    }
}

/// The lines of a text as patches count them. (`TextDiff::from_lines` also ends a line at a lone carriage return.)
fn lines(text: &str) -> Vec<&str> {
    text.split_inclusive('\n').collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_has_the_lines_that_change_and_some_around() {
        let text: String = (1..=20).map(|n| format!("line {n}\n")).collect();
        let find = |what: &str| text.find(what).unwrap();
        let mut edits = Edits::default();
        edits.replace(find("line 5\n")..find("line 6\n"), "");
        edits.replace(find("7\n")..find("7\n") + 1, "seven");
        edits.insert(text.len(), "line 21\n");
        assert_eq!(
            edits.patch("f", &text),
            "--- f\n+++ f\n@@ -2,9 +2,8 @@\n line 2\n line 3\n line 4\n-line 5\n line 6\n-line 7\n+line seven\n line 8\n line 9\n \
             line 10\n@@ -18,3 +17,4 @@\n line 18\n line 19\n line 20\n+line 21\n"
        );
        let made = edits.apply(&text);
        assert!(made.contains("line 4\nline 6\nline seven\n") && made.ends_with("line 20\nline 21\n"));
        assert_eq!(Edits::default().patch("f", &text), "");
        let mut first = Edits::default();
        first.insert(0, "a\n");
        assert_eq!(first.patch("f", ""), "--- f\n+++ f\n@@ -0,0 +1 @@\n+a\n");
        assert_eq!(first.apply(""), "a\n");
    }

    /// The text after a patch, which has to fit.
    fn patched(text: &str, patch: &str) -> String {
        let mut lines = text.split_inclusive('\n');
        let (mut made, mut at) = (String::new(), 0);
        let patch = patch.replace("\n\\ No newline at end of file\n", "\0");
        for line in patch.split_inclusive(['\n', '\0']).skip(2) {
            let (mark, line) = line.split_at(1);
            if mark == "@" {
                let range = line.split(['-', ' ']).nth(2).unwrap();
                let (from, length) = range.split_once(',').unwrap_or((range, "1"));
                let (from, length): (usize, usize) = (from.parse().unwrap(), length.parse().unwrap());
                let from = if length == 0 { from } else { from - 1 };
                made.extend(lines.by_ref().take(from - at));
                at = from;
                continue;
            }
            let line = line.trim_end_matches('\0');
            if mark != "+" {
                assert_eq!(lines.next(), Some(line));
                at += 1;
            }
            made += if mark == "-" { "" } else { line };
        }
        made.extend(lines);
        made
    }

    #[test]
    fn a_patch_makes_the_same_change_as_the_edit() {
        let mut edits = Edits::default();
        edits.insert(3, "\nc\n");
        let whole = "--- f\n+++ f\n@@ -1,2 +1,3 @@\n a\n-b\n\\ No newline at end of file\n+b\n+c\n";
        assert_eq!(edits.patch("f", "a\nb"), whole);
        for text in ["a\nb\nc\nd\ne\nf\ng\nh\n", "a\nb\nc\nd\ne\nf\ng\nh", "a", "a\n", "", "a\r\nb\r\nc"] {
            let mut ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).chain([0, text.len()]).collect();
            ends.sort_unstable();
            ends.dedup();
            for (place, &from) in ends.iter().enumerate() {
                for &to in &ends[place..] {
                    for with in ["", "x\n", "\nx\n", "x", "\n"] {
                        let mut edits = Edits::default();
                        edits.replace(from..to, with);
                        edits.insert(text.len(), if text.ends_with('\n') { "y\nz\n" } else { "\ny\nz\n" });
                        let (patch, made) = (edits.patch("f", text), edits.apply(text));
                        assert_eq!(patched(text, &patch), made, "{text:?} {from}..{to} {with:?}\n{patch}");
                    }
                }
            }
        }
    }

    #[test]
    fn new_lines_end_as_the_others_do() {
        let made = |text: &str| {
            let mut edits = Edits::default();
            edits.insert(text.len(), "new\nnewer\n");
            edits.with_line_ends_of(text).apply(text)
        };
        assert_eq!(made("a\r\nb\r\n"), "a\r\nb\r\nnew\r\nnewer\r\n");
        for mixed in ["", "a\nb\n", "a\r\nb\n"] {
            assert_eq!(made(mixed), format!("{mixed}new\nnewer\n"));
        }
    }
}
