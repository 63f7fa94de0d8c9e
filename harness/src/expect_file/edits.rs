//! Changes of a text by byte ranges, and the difference that they make, as a patch.

use std::ops::Range;

use crate::line_ends::{is_crlf, to_crlf};

/// Changes of one text; they do not overlap.
#[derive(Default, Debug)]
pub struct Edits(Vec<(Range<usize>, String)>);

/// Lines before and after a change in a patch.
const AROUND: usize = 3;

/// Some bytes and what comes in their place.
type Edit<'e> = (Range<usize>, &'e str);

/// Some lines that are replaced by others.
struct Change<'t> {
    /// The first line, from 0.
    at: usize,
    old: Vec<&'t str>,
    new: Vec<String>,
}

impl Edits {
    /// Puts a text in the place of these bytes.
    pub fn replace(&mut self, bytes: Range<usize>, with: impl Into<String>) {
        self.0.push((bytes, with.into()));
    }

    /// Inserts a text before this byte.
    pub fn insert(&mut self, at: usize, text: impl Into<String>) {
        self.replace(at..at, text);
    }

    /// The same changes with the line ends of a text, where all of its lines end by CR LF: an editor on Windows has written it.
    pub fn with_line_ends_of(mut self, text: &str) -> Edits {
        if is_crlf(text) {
            self.0.iter_mut().for_each(|(_, with)| *with = to_crlf(with));
        }
        self
    }

    /// Whether nothing is changed.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The changes from the first to the last; of several in one place the one that came first is first.
    fn sorted(&self) -> Vec<Edit<'_>> {
        let mut edits: Vec<Edit<'_>> = self.0.iter().map(|(range, text)| (range.clone(), &**text)).collect();
        edits.sort_by_key(|(range, _)| (range.start, range.end));
        edits
    }

    /// The text with the changes.
    pub fn apply(&self, text: &str) -> String {
        part(text, 0..text.len(), &self.sorted())
    }

    /// The changes as a patch, with some lines around each.
    pub fn patch(&self, file: &str, text: &str) -> String {
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let mut starts = vec![0];
        starts.extend(lines.iter().scan(0, |at, line| {
            *at += line.len();
            Some(*at)
        }));
        // What is put behind a last line without an end changes that line.
        let is_open = !text.is_empty() && !text.ends_with('\n');
        let line_of = |byte: usize| match starts.partition_point(|&start| start <= byte) - 1 {
            line if is_open => line.min(lines.len() - 1),
            line => line,
        };
        // Changes that touch the same lines become one.
        let mut groups: Vec<(Range<usize>, Vec<Edit<'_>>)> = Vec::new();
        for (bytes, with) in self.sorted() {
            let first = line_of(bytes.start);
            let last = if bytes.end > bytes.start { line_of(bytes.end - 1) + 1 } else { first };
            // What is put between two lines changes neither.
            let is_between = starts[first] == bytes.start && with.ends_with('\n');
            let last = if is_between { last } else { last.max(first + 1) }.min(lines.len());
            match groups.last_mut().filter(|(of, _)| first < of.end || (first == of.end && of.is_empty())) {
                Some((of, edits)) => {
                    of.end = of.end.max(last);
                    edits.push((bytes, with));
                }
                None => groups.push((first.min(lines.len())..last, vec![(bytes, with)])),
            }
        }
        let changes = groups.into_iter().map(|(of, edits)| {
            let new = part(text, starts[of.start]..starts[of.end], &edits);
            let new = new.split_inclusive('\n').map(str::to_owned).collect();
            trimmed(Change { at: of.start, old: lines[of].to_vec(), new })
        });
        hunks(file, &lines, &changes.collect::<Vec<_>>())
    }
}

/// A part of a text with these changes, all of which are in it.
fn part(text: &str, of: Range<usize>, edits: &[Edit<'_>]) -> String {
    let (mut made, mut at) = (String::new(), of.start);
    for (bytes, with) in edits {
        made += text.get(at..bytes.start).unwrap_or_default();
        made += with;
        at = at.max(bytes.end);
    }
    made + text.get(at..of.end).unwrap_or_default()
}

/// The change without the lines at its ends that stay.
fn trimmed(mut change: Change<'_>) -> Change<'_> {
    while change.old.last().zip(change.new.last()).is_some_and(|(old, new)| old == new) {
        change.old.pop();
        change.new.pop();
    }
    let same = change.old.iter().zip(&change.new).take_while(|(old, new)| old == new).count();
    change.old.drain(..same);
    change.new.drain(..same);
    Change { at: change.at + same, ..change }
}

fn hunks(file: &str, lines: &[&str], changes: &[Change<'_>]) -> String {
    let mut text = String::new();
    let mut shift = 0_i64;
    let mut rest = changes;
    while let Some(first) = rest.first() {
        // Changes whose surroundings touch are shown together.
        let near = |pair: &[Change<'_>]| pair[1].at <= pair[0].at + pair[0].old.len() + 2 * AROUND;
        let count = 1 + rest.windows(2).take_while(|pair| near(pair)).count();
        let (these, others) = rest.split_at(count);
        rest = others;
        let last = &these[count - 1];
        let from = first.at.saturating_sub(AROUND);
        let to = (last.at + last.old.len() + AROUND).min(lines.len());
        let mut body = Vec::new();
        let mut at = from;
        for change in these {
            body.extend(lines[at..change.at].iter().map(|line| (' ', (*line).to_owned())));
            body.extend(change.old.iter().map(|line| ('-', (*line).to_owned())));
            body.extend(change.new.iter().map(|line| ('+', line.clone())));
            at = change.at + change.old.len();
        }
        body.extend(lines[at..to].iter().map(|line| (' ', (*line).to_owned())));
        let count = |without: char| body.iter().filter(|(mark, _)| *mark != without).count();
        let (old, new) = (count('+'), count('-'));
        // A hunk without lines is said to be at the line before.
        let start = |length: usize, at: i64| if length == 0 { at } else { at + 1 };
        let from = i64::try_from(from).unwrap_or(i64::MAX);
        text += &format!("@@ -{},{old} +{},{new} @@\n", start(old, from), start(new, from + shift));
        for (mark, line) in &body {
            text.push(*mark);
            text += line;
            if !line.ends_with('\n') {
                text += "\n\\ No newline at end of file\n";
            }
        }
        shift += i64::try_from(new).unwrap_or(0) - i64::try_from(old).unwrap_or(0);
    }
    if text.is_empty() { text } else { format!("--- {file}\n+++ {file}\n{text}") }
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
        assert_eq!(first.patch("f", ""), "--- f\n+++ f\n@@ -0,0 +1,1 @@\n+a\n");
        assert_eq!(first.apply(""), "a\n");
    }

    /// The text with a patch, which has to fit.
    fn patched(text: &str, patch: &str) -> String {
        let mut lines = text.split_inclusive('\n');
        let (mut made, mut at) = (String::new(), 0);
        let patch = patch.replace("\n\\ No newline at end of file\n", "\0");
        for line in patch.split_inclusive(['\n', '\0']).skip(2) {
            let (mark, line) = line.split_at(1);
            if mark == "@" {
                let range = line.split(['-', ' ']).nth(2).unwrap();
                let (from, length) = range.split_once(',').unwrap();
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
