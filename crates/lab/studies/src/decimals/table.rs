//! The tables of the study, as Markdown.

use std::fmt::Write as _;

use predicament_records::Spread;
use predicament_records::format::percent;

use super::Answered;
use super::row::{EPSILON, columns, sum};
use super::study::Measured;

/// A function that returns the value of a row by which a table is divided.
type Key = fn(&Answered) -> String;

/// The page with all tables.
pub(super) fn page(measured: &Measured) -> String {
    let rows: Vec<&Answered> = measured.answered.iter().collect();
    let digits: Key = |row| row.digits.to_string();
    // Writing to a String cannot fail.
    let mut page = String::new();
    for place in values(&rows, |row| row.place.clone()) {
        let here: Vec<&Answered> = rows.iter().copied().filter(|row| row.place == place).collect();
        let _ = writeln!(page, "## {place}\n\n{}", by(&here, "digits", digits));
    }
    let _ = writeln!(page, "## Predicates\n\n{}", by(&rows, "predicate", |row| row.predicate.clone()));
    let _ = writeln!(page, "## Figures\n\n{}", by(&rows, "figure", |row| row.figure.clone()));
    let _ = writeln!(page, "## Epsilons\n\n{}", epsilons(&rows));
    if !measured.timed.is_empty() {
        let _ = writeln!(page, "## Times\n\n{}", times(measured));
    }
    page += "A cell is the share of all answers that are right about the decimals; in parentheses the share of ties that \
             are answered by zero, and of other signs that are right. The column of an epsilon is the best of the swept \
             ones over the rows of its table.\n";
    page
}

/// The values of a key, in the order of the rows.
pub(super) fn values(rows: &[&Answered], key: impl Fn(&Answered) -> String) -> Vec<String> {
    let mut values = Vec::new();
    for row in rows {
        let value = key(row);
        if !values.contains(&value) {
            values.push(value);
        }
    }
    values
}

/// The share of right answers, and of ties and other signs among them.
pub(super) fn cell<'r>(rows: impl IntoIterator<Item = &'r Answered>) -> String {
    let of = sum(rows);
    if of.answers == 0 {
        return "declined".to_owned();
    }
    let [ties, others] = [percent(of.ties_found, of.ties), percent(of.written - of.ties_found, of.answers - of.ties)];
    format!("{} ({ties}, {others})", percent(of.written, of.answers))
}

/// A table with a line for each value of a key, and a column for each backend.
pub(super) fn by(rows: &[&Answered], head: &str, key: Key) -> String {
    let columns = columns(rows);
    let mut table = format!("| {head} | {} |\n|---|{}\n", columns.join(" | "), "---:|".repeat(columns.len()));
    for value in values(rows, key) {
        let cells = columns
            .iter()
            .map(|backend| cell(rows.iter().copied().filter(|row| key(row) == value && row.column() == backend)));
        let _ = writeln!(table, "| {value} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}

/// The epsilons, by predicate and place: one line for each.
fn epsilons(rows: &[&Answered]) -> String {
    let swept: Vec<&Answered> = rows.iter().copied().filter(|row| row.backend.starts_with(EPSILON)).collect();
    let places = values(&swept, |row| row.place.clone());
    let mut table = format!("| epsilon | {} |\n|---|{}\n", places.join(" | "), "---:|".repeat(places.len()));
    for backend in values(&swept, |row| row.backend.clone()) {
        let cells = places
            .iter()
            .map(|place| cell(swept.iter().copied().filter(|row| row.backend == backend && row.place == *place)));
        let _ = writeln!(table, "| {backend} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}

/// The median time of each backend over all kinds, by predicate.
fn times(measured: &Measured) -> String {
    let name =
        |backend: &str| if backend.starts_with("grid:") { super::row::GRID.to_owned() } else { backend.to_owned() };
    let mut backends: Vec<String> = Vec::new();
    let mut predicates: Vec<&str> = Vec::new();
    for row in &measured.timed {
        if !backends.contains(&name(&row.backend)) {
            backends.push(name(&row.backend));
        }
        if !predicates.contains(&row.predicate.as_str()) {
            predicates.push(&row.predicate);
        }
    }
    let mut table = format!("| ns/query | {} |\n|---|{}\n", predicates.join(" | "), "---:|".repeat(predicates.len()));
    for backend in backends {
        let cells = predicates.iter().map(|predicate| {
            let of = measured.timed.iter().filter(|row| row.predicate == *predicate && name(&row.backend) == backend);
            Spread::of(of.map(|row| row.ns_per_query))
                .map_or_else(String::new, |spread| format!("{:.1}", spread.median))
        });
        let _ = writeln!(table, "| {backend} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}
