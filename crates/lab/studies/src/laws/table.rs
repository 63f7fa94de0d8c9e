//! The page of the study: violations of each law by each backend, as Markdown.

use std::fmt::Write as _;

use super::{Laws, Row, Surveyed};
use predicament_report::text::{in_order, markdown};

/// The table, and the first violation of each law that a backend breaks.
pub(super) fn page(laws: &Laws, surveyed: &[Surveyed]) -> String {
    let names: Vec<&str> = surveyed.iter().map(|one| one.backend.as_str()).collect();
    let mut page = format!(
        "`predicament study laws -b {} --tuples {} --seed {}`\n",
        names.join(","),
        laws.tuples,
        laws.common.seed
    );
    let all = in_order(surveyed.iter().flat_map(|one| &one.rows).map(|row| (row.law, row.subject.as_str())));
    let heads = ["law", "predicates", "tuples"].into_iter().chain(names).map(ToOwned::to_owned).collect();
    let mut rows: Vec<Vec<String>> = Vec::new();
    for (law, subject) in all {
        let of = |one: &Surveyed| one.rows.iter().find(|row| row.law == law && row.subject == subject).cloned();
        let rows_of: Vec<Option<Row>> = surveyed.iter().map(of).collect();
        let most = rows_of.iter().flatten().map(|row| row.tuples).max().unwrap_or(0);
        let cells = rows_of.iter().map(|row| row.as_ref().map_or_else(|| "-".to_owned(), |row| cell(row, most)));
        rows.push([law.name().to_owned(), subject.to_owned(), most.to_string()].into_iter().chain(cells).collect());
    }
    let total = |one: &Surveyed| one.rows.iter().map(|row| row.tuples).sum::<u64>().to_string();
    let totals = surveyed.iter().map(total);
    rows.push(["tuples of all laws", "", ""].into_iter().map(ToOwned::to_owned).chain(totals).collect());
    markdown(&mut page, "Violations", 2, heads, rows);
    for Surveyed { backend, rows } in surveyed {
        for (at, row) in rows.iter().filter(|row| !row.holds()).enumerate() {
            if at == 0 {
                let _ = writeln!(page, "\nFirst of `{backend}`\n");
            }
            if let Some(first) = &row.first {
                let _ = writeln!(page, "* {}: {first}", row.subject);
            }
        }
    }
    page
}

fn cell(row: &Row, most: u64) -> String {
    if row.is_declined() {
        return "-".to_owned();
    }
    let of = if row.tuples == most { String::new() } else { format!("/{}", row.tuples) };
    let panics = if row.panics == 0 { String::new() } else { format!(" + {}p", row.panics) };
    format!("{}{of}{panics}", row.violations)
}
