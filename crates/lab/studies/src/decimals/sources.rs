//! The branch by the source of the data, for the page "which backend for what".

use std::fmt::Write as _;

use super::Answered;
use super::row::{columns, sum};
use super::table::cell;

/// A source of data as users know it, and the rows of the study that are like it.
struct Source {
    name: &'static str,
    place: &'static str,
    digits: &'static [u32],
}

/// The sources whose numbers were written; of other data the doubles are all there is.
const SOURCES: [Source; 5] = [
    Source { name: "integers: pixels, database units", place: "metres", digits: &[0] },
    Source { name: "typed decimals, one to four digits", place: "metres", digits: &[1, 2, 3, 4] },
    Source { name: "GIS: degrees, six or eight digits", place: "degrees", digits: &[6, 8] },
    Source { name: "GIS: survey coordinates in metres, two to four digits", place: "survey", digits: &[2, 3, 4] },
    Source { name: "CAD: fractions of an inch in millimetres", place: "inches", digits: &[1, 2, 3, 4, 6] },
];

/// The table by the source of the data, from the rows of the study: shares of right answers, and the backend with most.
#[must_use]
pub fn sources(rows: &[Answered]) -> String {
    let all: Vec<&Answered> = rows.iter().collect();
    let mut table = String::new();
    for source in SOURCES {
        let is = |row: &&&Answered| row.place == source.place && source.digits.contains(&row.digits);
        let here: Vec<&Answered> = all.iter().filter(is).copied().collect();
        let columns = columns(&here);
        let of = |backend: &str| here.iter().copied().filter(move |row| row.column() == backend).collect::<Vec<_>>();
        let right = |backend: &&String| {
            let of = sum(of(backend));
            // In billionths: shares of few answers and of many are comparable.
            of.written * 1_000_000_000 / of.answers.max(1)
        };
        // Of equal backends the first.
        let Some(best) = columns.iter().rev().max_by_key(right) else { continue };
        let shares = columns.iter().map(|backend| format!("`{backend}` {}", cell(of(backend))));
        let _ = writeln!(table, "| {} | `{best}` | {} |", source.name, shares.collect::<Vec<_>>().join("; "));
    }
    format!(
        "| source | most often right | right about the decimals (ties, other signs) |\n| --- | --- | --- |\n{table}"
    )
}
