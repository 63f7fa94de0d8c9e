//! Lines of a text: a fast search for their numbers, and their unchanged line ends.

/// The starts of a text's lines; bisection finds the line of any byte.
#[derive(Debug)]
pub struct Lines {
    /// The offset of each newline.
    newlines: Vec<usize>,
}

impl Lines {
    /// Scans the whole text once.
    #[must_use]
    pub fn new(text: &str) -> Lines {
        Lines { newlines: memchr::memchr_iter(b'\n', text.as_bytes()).collect() }
    }

    /// The line of a byte offset, counted from 1.
    #[must_use]
    pub fn of(&self, at: usize) -> usize {
        1 + self.newlines.partition_point(|&newline| newline < at)
    }
}

/// A line of a text without its end, and the end: `\n`, `\r\n`, `\r`, or nothing in the last line.
pub(crate) struct Line<'t> {
    /// The line number, counted from 1.
    pub(crate) number: usize,
    pub(crate) body: &'t str,
    pub(crate) end: &'t str,
}

/// The lines of a data file. A lone carriage return also ends a line.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut rest = text;
    (1..).map_while(move |number| {
        if rest.is_empty() {
            return None;
        }
        let length = memchr::memchr2(b'\n', b'\r', rest.as_bytes()).unwrap_or(rest.len());
        let (body, behind) = rest.split_at(length);
        let end = &behind[..if behind.starts_with("\r\n") { 2 } else { behind.len().min(1) }];
        rest = &behind[end.len()..];
        Some(Line { number, body, end })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_have_lines() {
        let lines = Lines::new("ab\n\ncd\n");
        let of: Vec<usize> = (0..8).map(|at| lines.of(at)).collect();
        assert_eq!(of, [1, 1, 1, 2, 3, 3, 3, 4]);
        assert_eq!(Lines::new("").of(0), 1);
    }

    #[test]
    fn every_kind_of_end_is_one() {
        let text = "a\nb\r\nc\rd\n\re";
        let found: Vec<_> = lines(text).map(|line| (line.number, line.body, line.end)).collect();
        let expected = [(1, "a", "\n"), (2, "b", "\r\n"), (3, "c", "\r"), (4, "d", "\n"), (5, "", "\r"), (6, "e", "")];
        assert_eq!(found, expected);
        assert_eq!(lines("").count(), 0);
    }
}
