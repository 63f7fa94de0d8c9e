//! Edits of an array in a TOML file that keep its lines and comments.

use std::ops::Range;

use super::edits::Edits;
use super::quoted;

/// A TOML value: one string, or an array of strings.
#[derive(Clone, Debug)]
pub struct ListText {
    /// The byte range of the value.
    pub span: Range<usize>,
    /// Each string with its byte range.
    pub items: Vec<(String, Range<usize>)>,
    /// True if the value is an array.
    pub is_array: bool,
}

impl ListText {
    /// The strings.
    pub fn values(&self) -> Vec<String> {
        self.items.iter().map(|(value, _)| value.clone()).collect()
    }

    /// Appends items to the array.
    pub fn append(&self, text: &str, more: &[String], edits: &mut Edits) {
        let new: Vec<String> = more.iter().map(|item| quoted(item)).collect();
        let Some((_, last)) = self.items.last().filter(|_| !new.is_empty()) else { return };
        if !self.is_array {
            let old = text.get(self.span.clone()).unwrap_or_default();
            let items: String =
                std::iter::once(old.to_owned()).chain(new).map(|item| format!("    {item},\n")).collect();
            edits.replace(self.span.clone(), format!("[\n{items}]"));
        } else if text.get(self.span.clone()).is_some_and(|array| array.contains('\n')) {
            let line = text[..last.start].rfind('\n').map_or(0, |end| end + 1);
            let indent: String = text[line..].chars().take_while(|c| c.is_whitespace() && *c != '\n').collect();
            let indent = if line <= self.span.start { "    ".to_owned() } else { indent };
            let rest = &text[last.end..self.span.end];
            if !rest.trim_start().starts_with(',') {
                edits.insert(last.end, ",");
            }
            let items: String = new.iter().map(|item| format!("{indent}{item},\n")).collect();
            // Insert after the line of the last item, because it may have a comment; insert before the bracket if it is
            // on that line.
            match rest.find('\n') {
                Some(end) => edits.insert(last.end + end + 1, items),
                None => edits.insert(self.span.end - 1, format!("\n{items}")),
            }
        } else {
            edits.insert(last.end, new.iter().map(|item| format!(", {item}")).collect::<String>());
        }
    }

    /// Removes all items except these, of which there is at least one.
    pub fn keep(&self, text: &str, kept: impl Fn(&str) -> bool, edits: &mut Edits) {
        if self.items.iter().all(|(value, _)| kept(value)) {
            return;
        }
        let array = text.get(self.span.clone()).unwrap_or_default();
        if !array.contains('\n') {
            let left = self.items.iter().filter(|(value, _)| kept(value)).map(|(_, span)| &text[span.clone()]);
            edits.replace(self.span.clone(), format!("[{}]", left.collect::<Vec<_>>().join(", ")));
            return;
        }
        for (_, span) in self.items.iter().filter(|(value, _)| !kept(value)) {
            edits.replace(with_its_line(text, span), "");
        }
    }
}

/// The byte range of an item with its comma, and of its whole line if the line has only a comment besides.
fn with_its_line(text: &str, span: &Range<usize>) -> Range<usize> {
    let behind = &text[span.end..];
    let blank = behind.len() - behind.trim_start().len();
    let end = if behind[blank..].starts_with(',') { span.end + blank + 1 } else { span.end };
    let line = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
    let line_end = text[end..].find('\n').map_or(text.len(), |at| end + at + 1);
    let rest = text[end..line_end].trim();
    if text[line..span.start].trim().is_empty() && (rest.is_empty() || rest.starts_with('#')) {
        line..line_end
    } else {
        let spaces = text[end..line_end].len() - text[end..line_end].trim_start_matches(' ').len();
        span.start..end + spaces
    }
}
