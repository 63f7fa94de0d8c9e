//! Rewrites inexact decimals of a suite to hex floats; all other bytes stay.

use std::ops::Range;

use predicament_formats::{
    CoordinateError, CorpusError, Document, Field, Fields, TableKind, hexfloat, read_coordinate,
};

use crate::Vocabulary;
use crate::suite::SUITE;

/// Rewrites the decimals of a suite that are not exactly doubles: each becomes the hex float of its nearest double, and
/// a comment at the end of its line keeps the original text. All other bytes stay. Suites without such decimals, and
/// suites that were already rewritten, are returned unchanged.
///
/// # Errors
/// [`CorpusError`] if the text is not TOML, or a coordinate is not a number within the range of doubles.
pub fn fmt(vocabulary: &Vocabulary, file: &str, text: &str) -> Result<String, CorpusError> {
    let document = Document::new(file, text);
    let root = document.parse()?;
    let fields = Fields::new(&document, &SUITE, root.get_ref(), 0);
    let mut keys: Vec<&'static str> =
        vocabulary.tasks().iter().flat_map(|task| task.coordinate_keys()).copied().collect();
    keys.push(WRITTEN);
    keys.sort_unstable();
    keys.dedup();
    let mut edits = Vec::new();
    for (tables, kind) in [("scene", &vocabulary.scene), ("generate", &vocabulary.generator)] {
        for table in array(&fields, tables)? {
            let fields = table.fields(kind)?;
            for field in keys.iter().filter(|key| kind.keys.contains(key)).filter_map(|key| fields.get(key)) {
                collect(&field, &keys, &mut edits)?;
            }
        }
    }
    edits.sort_by_key(|edit| edit.span.start);
    let rewritten = apply(text, &edits);
    let again = Document::new(file, &rewritten);
    // A comment inside a multi-line string would become part of the string.
    again.parse().map_err(|error| CorpusError { cure: "write each point on a line of its own".into(), ..error })?;
    Ok(rewritten)
}

/// The key of every generator for written points.
const WRITTEN: &str = "coordinates";

/// A literal and its replacement.
struct Edit<'t> {
    span: Range<usize>,
    decimal: &'t str,
    hex: String,
}

fn array<'d, 't>(fields: &Fields<'d, 't>, key: &'static str) -> Result<Vec<Field<'d, 't>>, CorpusError> {
    fields.get(key).map_or(Ok(Vec::new()), |field| Ok(field.items("tables")?.collect()))
}

/// Collects the coordinates in a value: the value itself, its items, or the values of these keys in a table. Other
/// keys, such as `path`, hold no coordinates.
fn collect<'t>(field: &Field<'_, 't>, keys: &[&'static str], edits: &mut Vec<Edit<'t>>) -> Result<(), CorpusError> {
    if field.is_array() {
        for item in field.items("coordinates")? {
            collect(&item, keys, edits)?;
        }
    } else if field.is_table() {
        let kind = TableKind { name: "table", keys: keys.to_vec().into() };
        let table = field.fields(&kind)?;
        for key in keys {
            if let Some(field) = table.get(key) {
                collect(&field, keys, edits)?;
            }
        }
    } else {
        edits.extend(edit(field)?);
    }
    Ok(())
}

fn edit<'t>(field: &Field<'_, 't>) -> Result<Option<Edit<'t>>, CorpusError> {
    let text = field.coordinate_text()?;
    match read_coordinate(text) {
        Ok(_) => Ok(None),
        Err(CoordinateError::Inexact { nearest }) => Ok(Some(Edit {
            span: field.span(),
            decimal: field.written().trim_matches(['"', '\'']),
            hex: hexfloat::format(nearest),
        })),
        Err(error) => Err(field.coordinate_error(text, &error)),
    }
}

/// Replaces the literals from left to right, and appends a comment to each line that had any.
fn apply(text: &str, edits: &[Edit<'_>]) -> String {
    let mut out = String::with_capacity(text.len() + 64 * edits.len());
    let mut start = 0;
    let mut left = edits.iter().peekable();
    for line in text.split_inclusive('\n') {
        let end = start + line.len();
        let body = line.trim_end_matches(['\n', '\r']);
        let mut at = start;
        let mut decimals = Vec::new();
        while let Some(edit) = left.next_if(|edit| edit.span.start < end) {
            out.push_str(&text[at..edit.span.start]);
            out.push('"');
            out.push_str(&edit.hex);
            out.push('"');
            at = edit.span.end;
            decimals.push(edit.decimal);
        }
        out.push_str(&text[at..start + body.len()]);
        if !decimals.is_empty() {
            out.push_str("  # ");
            out.push_str(&decimals.join(", "));
        }
        out.push_str(&line[body.len()..]);
        start = end;
    }
    out
}
