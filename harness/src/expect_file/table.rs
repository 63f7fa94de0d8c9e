//! The `[[expect]]` tables of a file, with the byte ranges of their parts.

use std::ops::Range;

use predicament_formats::{CorpusError, Document, Field, Fields, TableKind};

use super::array::ListText;

/// A table as it stands in the file.
#[derive(Clone, Debug)]
pub struct TableText {
    /// The bytes of its lines, from the header to the last value.
    pub lines: Range<usize>,
    /// The line number of its header, from 1.
    pub line: usize,
    pub scenes: ListText,
    pub backends: ListText,
    pub classes: ListText,
    /// The level, as a value and in TOML syntax.
    pub level: Option<(String, String)>,
    /// The reason, as a value and in TOML syntax.
    pub reason: (String, String),
}

static FILE: TableKind = TableKind::new("file of expectations", &["expect"]);
static EXPECT: TableKind = TableKind::new("table [[expect]]", &["scene", "backend", "class", "reason", "level"]);

/// The tables of a file, in their order.
///
/// # Errors
/// If the file is not a valid file of expectations, or a table is not written as `[[expect]]`.
pub fn tables(file: &str, text: &str) -> Result<Vec<TableText>, CorpusError> {
    let document = Document::new(file, text);
    let root = document.parse()?;
    let fields = Fields::new(&document, &FILE, root.get_ref(), 0);
    let mut all = Vec::new();
    if let Some(list) = fields.get("expect") {
        for table in list.items("[[expect]] tables")? {
            all.push(read(text, &table)?);
        }
    }
    fields.finish()?;
    Ok(all)
}

fn read(text: &str, table: &Field<'_, '_>) -> Result<TableText, CorpusError> {
    let fields = table.fields(&EXPECT)?;
    let start = text[..table.span().start].rfind('\n').map_or(0, |end| end + 1);
    if !text[start..].trim_start().starts_with("[[") {
        return Err(table.error("it is not a separate table", "write it as [[expect]], so that it can be edited"));
    }
    let list = |key: &'static str| -> Result<ListText, CorpusError> {
        let field = fields.required(key)?;
        let items = field.one_or_more()?;
        let items = items.iter().map(|item| Ok((item.string()?, item.span()))).collect::<Result<_, CorpusError>>()?;
        Ok(ListText { span: field.span(), items, is_array: field.is_array() })
    };
    let (scenes, backends, classes) = (list("scene")?, list("backend")?, list("class")?);
    let written = |field: Field<'_, '_>| Ok((field.string()?, field.written().to_owned()));
    let reason = fields.required("reason")?;
    let level = fields.get("level");
    let spans = [Some(scenes.span.end), Some(backends.span.end), Some(classes.span.end), Some(reason.span().end)];
    let last = spans.into_iter().flatten().chain(level.map(|level| level.span().end)).max().unwrap_or(start);
    let end = text[last..].find('\n').map_or(text.len(), |at| last + at + 1);
    let (line, reason, level) = (fields.line(), written(reason)?, level.map(written).transpose()?);
    fields.finish()?;
    Ok(TableText { lines: start..end, line, scenes, backends, classes, level, reason })
}

impl TableText {
    /// The byte range of the table, the comment directly above it, and the empty line below it.
    pub fn with_its_comment(&self, text: &str) -> Range<usize> {
        let mut start = self.lines.start;
        while let Some(above) = text[..start].strip_suffix('\n') {
            let line = above.rfind('\n').map_or(0, |end| end + 1);
            if !above[line..].trim_start().starts_with('#') {
                break;
            }
            start = line;
        }
        // A comment at the start of the file is about the whole file.
        let start = if start == 0 { self.lines.start } else { start };
        let below = text[self.lines.end..].find('\n').map_or(self.lines.end, |at| self.lines.end + at + 1);
        let is_empty = text[self.lines.end..below].trim().is_empty();
        start..if is_empty { below } else { self.lines.end }
    }
}
