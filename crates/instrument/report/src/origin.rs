//! The sources of a table's numbers.
//!
//! Readers trust only numbers that they can trace. A table names its CSV file and the columns that contain its words; a
//! browser finds the rows, and shows their lines. The page contains only these names and, once for all tables, the
//! columns that they use: a table of ten thousand cells needs no more than one of ten.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use serde_json::{Map, Value, json};

use crate::columns::dictionary;
use crate::table::{Block, Section};
use crate::{Error, RunDir, figures};
use predicament_records::Lined;

/// The source rows of a table's cells in a CSV file: rows with the words of the cell's row and of its column's head.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Origin {
    file: Cow<'static, str>,
    path: Option<PathBuf>,
    /// Heads, each with the column of the file that has their words.
    keys: Vec<(String, String)>,
    /// Heads, each with the column that has the small second lines under the words.
    under: Vec<(String, String)>,
    across: Option<String>,
    /// The words of some heads in that column; if there are any, other heads are not words of the column.
    named: Vec<(String, String)>,
    only: Vec<(String, String)>,
}

impl Origin {
    /// An origin in a table of the run folders, such as `summary.csv`.
    #[must_use]
    pub fn of(file: &'static str) -> Origin {
        Origin { file: file.into(), path: None, keys: vec![], under: vec![], across: None, named: vec![], only: vec![] }
    }

    /// An origin in another file, such as one that a study has written.
    #[must_use]
    pub fn at(path: impl Into<PathBuf>) -> Origin {
        let path = path.into();
        Origin { file: path.display().to_string().into(), path: Some(path), ..Origin::of("") }
    }

    /// Maps these heads to columns with the same names.
    #[must_use]
    pub fn keys<'h>(mut self, heads: impl IntoIterator<Item = &'h str>) -> Origin {
        self.keys.extend(heads.into_iter().map(|head| (head.to_owned(), head.to_owned())));
        self
    }

    /// Maps this head to this column.
    #[must_use]
    pub fn key(mut self, head: &str, column: &str) -> Origin {
        self.keys.push((head.to_owned(), column.to_owned()));
        self
    }

    /// Maps the small second lines under this head to this column.
    #[must_use]
    pub fn under(mut self, head: &str, column: &str) -> Origin {
        self.under.push((head.to_owned(), column.to_owned()));
        self
    }

    /// Maps the heads of the numbers to words of this column.
    #[must_use]
    pub fn across(self, column: &str) -> Origin {
        Origin { across: Some(column.to_owned()), ..self }
    }

    /// Maps the numbers under these heads to rows with these words in this column; numbers under other heads match any
    /// row.
    #[must_use]
    pub fn named<'h>(self, column: &str, heads: impl IntoIterator<Item = (&'h str, &'h str)>) -> Origin {
        let named = heads.into_iter().map(|(head, word)| (head.to_owned(), word.to_owned())).collect();
        Origin { named, ..self.across(column) }
    }

    /// Limits the origin to rows with this word in this column.
    #[must_use]
    pub fn only(mut self, column: &str, word: &str) -> Origin {
        self.only.push((column.to_owned(), word.to_owned()));
        self
    }

    /// The data of the origin beside its table in the page.
    pub(crate) fn json(&self) -> Value {
        let pairs = |of: &[(String, String)]| -> Map<String, Value> {
            of.iter().map(|(name, other)| (name.clone(), json!(other))).collect()
        };
        let mut of = Map::from_iter([("file".to_owned(), json!(self.file))]);
        for (name, pairs) in [
            ("keys", pairs(&self.keys)),
            ("under", pairs(&self.under)),
            ("named", pairs(&self.named)),
            ("only", pairs(&self.only)),
        ] {
            if !pairs.is_empty() {
                of.insert(name.to_owned(), pairs.into());
            }
        }
        of.extend(self.across.iter().map(|column| ("across".to_owned(), json!(column))));
        Value::Object(of)
    }

    fn columns(&self) -> impl Iterator<Item = &str> {
        let pairs = self.keys.iter().chain(&self.under).map(|(_, column)| column.as_str());
        pairs.chain(self.only.iter().map(|(column, _)| column.as_str())).chain(self.across.as_deref())
    }
}

/// The source data of these sections' tables: the columns that they use, with the lines of the rows, by file.
///
/// # Errors
/// If the file of a study can't be read any more.
pub(crate) fn sources(runs: &[RunDir], sections: &[Section]) -> Result<Value, Error> {
    let mut asked: BTreeMap<&str, (&Origin, BTreeSet<&str>)> = BTreeMap::new();
    for block in sections.iter().flat_map(|section| &section.blocks) {
        if let Block::Table(table) = block {
            for origin in table.origins() {
                asked.entry(&origin.file).or_insert_with(|| (origin, BTreeSet::new())).1.extend(origin.columns());
            }
        }
    }
    let mut sources = Map::new();
    for (file, (origin, columns)) in asked {
        let mut parts = Vec::new();
        if let Some(path) = &origin.path {
            parts.push(part(0, file, &Lined::read(path)?, &columns));
        } else if file == figures::FILE {
            parts.push(part(0, file, &figures::lined(runs)?, &columns));
        } else {
            for (at, run) in runs.iter().enumerate() {
                if let Some(lined) = run.lined(file)? {
                    parts.push(part(at + 1, &run.path.join(file).display().to_string(), &lined, &columns));
                }
            }
        }
        sources.insert(file.to_owned(), parts.into());
    }
    Ok(sources.into())
}

/// The rows of one file: their lines as differences between consecutive rows, and the used columns.
fn part(run: usize, path: &str, lined: &Lined, columns: &BTreeSet<&str>) -> Value {
    let mut rows: Vec<&(u64, Vec<String>)> = lined.rows.iter().collect();
    rows.sort_by_key(|(line, _)| *line);
    let ends = std::iter::once(0).chain(rows.iter().map(|(line, _)| *line));
    let steps: Vec<u64> = rows.iter().zip(ends).map(|((line, _), last)| line - last).collect();
    let words = columns.iter().filter_map(|&column| {
        let place = lined.columns.iter().position(|name| name == column)?;
        let words = rows.iter().map(|(_, row)| row.get(place).cloned().unwrap_or_default());
        Some((column.to_owned(), dictionary(words)))
    });
    json!({ "run": run, "path": path, "steps": steps, "columns": words.collect::<Map<_, _>>() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_origin_says_what_it_is_asked_and_no_more() {
        let of =
            Origin::of("summary.csv").keys(["suite"]).key("input", "kind").under("scene", "suite").across("backend");
        let all = r#"{"across":"backend","file":"summary.csv","keys":{"input":"kind","suite":"suite"},"under":{"scene":"suite"}}"#;
        assert_eq!(of.json().to_string(), all);
        assert_eq!(of.columns().collect::<Vec<_>>(), ["suite", "kind", "suite", "backend"]);
        let of = Origin::at("a/b.csv").only("knob", "scale");
        assert_eq!(of.json().to_string(), r#"{"file":"a/b.csv","only":{"knob":"scale"}}"#);
    }

    #[test]
    fn lines_are_steps() {
        let row = |line, words: [&str; 2]| (line, words.map(str::to_owned).to_vec());
        let columns = ["a", "b"].map(str::to_owned).to_vec();
        let lined = Lined { columns, rows: vec![row(7, ["x", "y"]), row(3, ["x", "z"])] };
        let expected = json!({
            "run": 2, "path": "p", "steps": [3, 4], "columns": { "b": { "words": ["z", "y"], "at": [0, 1] } }
        });
        assert_eq!(part(2, "p", &lined, &["b", "missing"].into_iter().collect()), expected);
    }
}
