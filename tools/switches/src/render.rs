//! A file with its edits, and where each of them went.

use std::ops::Range;

use crate::sites::{Edit, Piece};

/// Lines between an error and the statement that causes it.
const NEAR: usize = 3;

/// The text of a file with all edits, and the bytes that each switch covers in it.
pub struct Rendered {
    pub text: String,
    pub places: Vec<(Range<usize>, usize)>,
}

/// Applies the edits; edits nest or are apart, and of two with the same bytes the first is outside.
pub fn render(source: &str, edits: &[Edit]) -> Rendered {
    let mut sorted: Vec<&Edit> = edits.iter().collect();
    sorted.sort_by_key(|edit| (edit.range.start, std::cmp::Reverse(edit.range.end)));
    let mut rendered = Rendered { text: String::new(), places: Vec::new() };
    rendered.range(source, 0..source.len(), &sorted);
    rendered
}

impl Rendered {
    /// Adds some bytes with the edits that are in them, which are sorted.
    fn range(&mut self, source: &str, range: Range<usize>, edits: &[&Edit]) {
        let mut at = range.start;
        let mut rest = edits;
        while let Some((edit, after)) = rest.split_first() {
            let inside = after.iter().take_while(|inner| inner.range.start < edit.range.end).count();
            self.text.push_str(&source[at..edit.range.start]);
            let start = self.text.len();
            for piece in &edit.pieces {
                match piece {
                    Piece::Text(text) => self.text.push_str(text),
                    Piece::Source(part) => {
                        let within = |inner: &&&Edit| part.start <= inner.range.start && inner.range.end <= part.end;
                        let inner: Vec<&Edit> = after[..inside].iter().filter(within).copied().collect();
                        self.range(source, part.clone(), &inner);
                    }
                }
            }
            self.places.push((start..self.text.len(), edit.number));
            at = edit.range.end;
            rest = &after[inside..];
        }
        self.text.push_str(&source[at..range.end]);
    }

    /// The switch of the fewest bytes around a line and column, as a compiler counts them; if there is none, the
    /// statements that can be left out near the line.
    ///
    /// (An assignment that may be left out makes the value moved before, which is an error elsewhere.)
    pub fn culprits(&self, line: usize, column: usize) -> Vec<usize> {
        let lines: Vec<usize> = self.text.split_inclusive('\n').map(str::len).collect();
        let start_of = |line: usize| lines.iter().take(line).sum::<usize>();
        let start = start_of(line - 1);
        let mut columns = self.text[start..].char_indices().map(|(at, _)| at);
        let at = start + columns.nth(column - 1).unwrap_or(0);
        let around = self.places.iter().filter(|(range, _)| range.contains(&at));
        if let Some((_, number)) = around.min_by_key(|(range, _)| range.len()) {
            return vec![*number];
        }
        let near = start_of(line.saturating_sub(NEAR + 1))..start_of(line + NEAR);
        let statements = self.places.iter().filter(|(range, _)| {
            near.contains(&range.start) && self.text[range.start..].starts_with("if !crate::switch")
        });
        statements.map(|(_, number)| *number).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_nest_and_are_found_again() {
        let text = "fn f(a: i32, é: bool) -> bool { if é && a + 1 < 3 { g(-a); } a == 4 }";
        let (switches, edits) = crate::sites::of(text, 0, &[]).unwrap();
        let what: Vec<&str> = switches.iter().map(|switch| switch.what.as_str()).collect();
        assert_eq!(what.len(), 8, "{what:?}");
        let rendered = render(text, &edits);
        syn::parse_file(&rendered.text).unwrap_or_else(|why| panic!("{why}: {}", rendered.text));
        let column = rendered.text.chars().collect::<String>().find(" - (1)").unwrap();
        assert_eq!(rendered.culprits(1, column), [what.iter().position(|&what| what == "+ becomes -").unwrap()]);
        let [all, none] = [vec![], (0..8).collect::<Vec<_>>()]
            .map(|dropped| render(text, &crate::sites::of(text, 0, &dropped).unwrap().1).text);
        assert!(all.len() > text.len());
        assert_eq!(none, text);
    }
}
