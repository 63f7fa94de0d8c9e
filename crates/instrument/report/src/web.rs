//! The data of a page in a browser: scripts, and rows as compressed columns.
//!
//! A row of a table is far more expensive for a browser than a row of data. A page with all findings as a table would
//! be tens of megabytes and take minutes to open. So rows are stored as compressed columns, words as indices in a
//! dictionary, and the table creates only the visible rows. Everything is inside the page: it works from a disk without
//! a network.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde_json::{Map, Value, json};

use crate::columns::{dictionary, numbers};
use crate::drawing;
use crate::origin::sources;
use crate::pixel_map::base64;
use crate::table::Section;
use crate::{Error, RunDir};

/// The libraries of a page, in this order. They are embedded in compressed form, as they are a third of a page of a few
/// megabytes.
pub(crate) const LIBRARIES: [&str; 3] =
    [include_str!("../web/vendor/tabulator.js"), include_str!("../web/vendor/uplot.js"), drawing::SCRIPTS[0]];
/// The page's own scripts, in this order.
pub const SCRIPTS: [&str; 5] = [
    include_str!("../web/libraries.js"),
    drawing::SCRIPTS[1],
    include_str!("../web/plots.js"),
    include_str!("../web/sources.js"),
    include_str!("../web/app.js"),
];
/// The style sheet of a page.
pub const STYLE: &str = concat!(include_str!("../web/style.css"), include_str!("../web/vendor/uplot.css"));

/// The text and pictures about one finding, which a page shows on demand.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Detail {
    /// The finding's id.
    pub finding: String,
    /// The points, the truth and all answers, line by line.
    pub lines: Vec<String>,
    /// Pictures as SVG, each with its alternative text.
    pub pictures: Vec<(String, String)>,
    /// Drawings in space as data ([`Drawing::json`](crate::drawing::Drawing::json)) for a view that turns, each with
    /// its alternative text.
    pub views: Vec<(String, Value)>,
    /// Strips of signs: the signs of one query for all orders of its vertices.
    pub strips: Vec<Strip>,
}

/// The signs of one query for all orders of its vertices, with a row for the truth and for each backend.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Strip {
    /// The names of the vertices, in the order of the query.
    pub vertices: Vec<String>,
    /// A name and its signs, `+`, `0` or `-`, in the lexicographic order of permutations.
    pub rows: Vec<(String, String)>,
}

/// The data of a page: the findings of all runs, the details of some, the origins of tables, and the hidden rows of
/// long tables.
///
/// The format is JSON in columns, compressed (raw DEFLATE) and in base 64.
///
/// # Errors
/// If writing to memory fails, which does not happen.
pub fn rows(runs: &[RunDir], sections: &[Section], details: &[Detail], rest: &[String]) -> Result<String, Error> {
    let sources = sources(runs, sections)?;
    packed(
        &json!({ "findings": findings(runs), "details": told(details), "sources": sources, "rest": rest }).to_string(),
    )
}

/// The libraries, compressed like [`rows`].
///
/// # Errors
/// If writing to memory fails, which does not happen.
pub fn libraries() -> Result<String, Error> {
    packed(&LIBRARIES.concat())
}

fn packed(text: &str) -> Result<String, Error> {
    let failed = |error: std::io::Error| Error::new("rows of the page".as_ref(), error.to_string());
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes()).map_err(failed)?;
    Ok(base64(&encoder.finish().map_err(failed)?))
}

/// The relevant columns of `findings.csv`, with the number of the run.
fn findings(runs: &[RunDir]) -> Value {
    let mut rows: Vec<(usize, &crate::FindingRow, Option<u64>)> = Vec::new();
    for (run, folder) in runs.iter().enumerate() {
        rows.extend(folder.findings.lined().map(|(line, row)| (run, row, line)));
    }
    rows.sort_by_key(|(run, f, _)| (*run, [&f.suite, &f.scene, &f.scene_id, &f.task, &f.backend, &f.finding_id]));
    let mut columns = Map::new();
    let mut words = |name: &str, of: &dyn Fn(usize, &crate::FindingRow) -> String| {
        columns.insert(name.to_owned(), dictionary(rows.iter().map(|(run, row, _)| of(*run, row))));
    };
    words("run", &|run, _| (run + 1).to_string());
    words("folder", &|run, _| runs[run].path.display().to_string());
    words("finding", &|_, row| row.finding_id.clone());
    words("class", &|_, row| row.class.name().to_owned());
    words("backend", &|_, row| row.backend.clone());
    words("suite", &|_, row| row.suite.clone());
    words("scene", &|_, row| row.scene.clone());
    words("task", &|_, row| row.task.clone());
    words("check", &|_, row| row.check.clone());
    words("query", &|_, row| row.query.clone());
    words("got", &|_, row| row.got.clone());
    words("truth", &|_, row| row.truth.clone());
    words("stage", &|_, row| row.stage.clone());
    columns.insert("degeneracy".to_owned(), numbers(rows.iter().map(|(_, row, _)| row.log2_relative_det)));
    columns.insert("distance".to_owned(), numbers(rows.iter().map(|(_, row, _)| row.distance_over_l)));
    columns.insert("line".to_owned(), json!({ "numbers": rows.iter().map(|(_, _, line)| *line).collect::<Vec<_>>() }));
    json!({ "rows": rows.len(), "columns": columns })
}

/// Details by the ids of their findings.
fn told(details: &[Detail]) -> Value {
    let told = details.iter().map(|detail| {
        let pictures: Vec<Value> = detail.pictures.iter().map(|(alt, svg)| json!({ "alt": alt, "svg": svg })).collect();
        let views: Vec<Value> = detail.views.iter().map(|(alt, of)| json!({ "alt": alt, "drawing": of })).collect();
        let strips: Vec<Value> =
            detail.strips.iter().map(|strip| json!({ "vertices": strip.vertices, "rows": strip.rows })).collect();
        let of = json!({ "text": detail.lines.join("\n"), "pictures": pictures, "views": views, "strips": strips });
        (detail.finding.clone(), of)
    });
    Value::Object(told.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_script_ends_the_element_that_it_is_in() {
        for script in SCRIPTS.into_iter().chain(drawing::SCRIPTS) {
            assert!(!script.to_lowercase().contains("</script"), "a page would end there");
        }
    }
}
