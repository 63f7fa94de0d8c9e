//! The tables of the study, as Markdown.

use std::fmt::Write as _;

use predicament_records::format::significant;

use super::Row;
use super::row::{Group, columns};
use crate::folder::FolderError;

/// The page with all tables.
pub(super) fn page(rows: &[Row]) -> String {
    let columns = columns(rows);
    let mut page = format!("{}\n{}\n\n", summary(rows), MEANING);
    // Writing to a String cannot fail.
    let head = format!("| input | ns, whole | {} |\n|---|---:|{}", columns.join(" | "), "---:|".repeat(columns.len()));
    let _ = writeln!(page, "{head}");
    let of_input = |row: &&Row| [row.task.clone(), row.kind.clone(), row.family.clone(), row.interface.clone()];
    let all: Vec<&Row> = rows.iter().collect();
    for rows in all.chunk_by(|a, b| of_input(a) == of_input(b)) {
        let cells = columns.iter().map(|column| {
            rows.iter().find(|row| row.column() == *column).map_or_else(|| "-".to_owned(), |row| cell(row))
        });
        let Row { task, kind, family, interface, whole_ns, .. } = rows[0];
        let cells = cells.collect::<Vec<_>>().join(" | ");
        let ns = if whole_ns.is_nan() { "-".to_owned() } else { significant(*whole_ns, 3) };
        let _ = writeln!(page, "| {task}, {kind} ({family}), {interface} | {ns} | {cells} |");
    }
    page += "\nA cell has the median of the ratios of one input, and their quartiles.\n";
    page
}

fn cell(row: &Row) -> String {
    let [ratio, low, high] = [row.ratio, row.low, row.high].map(|x| significant(x, 3));
    match row.answers.as_str() {
        "equal" => format!("{ratio} ({low} to {high})"),
        other => other.to_owned(),
    }
}

/// The meaning of the summary's cells.
pub(super) const MEANING: &str = "A cell has the time without the device over the time with all devices: the geometric \
    mean over the inputs of a row, and the smallest and the largest.";

/// The ratios by the kind of scenes and the interface.
pub(super) fn summary(rows: &[Row]) -> String {
    let columns = columns(rows);
    let mut table =
        format!("| input | inputs | {} |\n|---|---:|{}\n", columns.join(" | "), "---:|".repeat(columns.len()));
    for group in Group::all(rows) {
        let cells = columns.iter().map(|column| match group.of(column) {
            Some((mean, [low, high])) => {
                let [mean, low, high] = [mean, low, high].map(|x| significant(x, 3));
                format!("{mean} ({low} to {high})")
            }
            None => "-".to_owned(),
        });
        let cells = cells.collect::<Vec<_>>().join(" | ");
        let _ = writeln!(table, "| {} | {} | {cells} |", group.name, group.inputs());
    }
    table
}

/// The table for the page "which backend for what".
///
/// # Errors
/// [`FolderError`] if an answer has changed without a device: then the times mean nothing.
pub fn saved(rows: &[Row]) -> Result<String, FolderError> {
    if rows.iter().any(|row| row.answers == "unequal") {
        return Err(FolderError::Lacks {
            file: "ablation/ablation.csv",
            what: "equal answers in every row".to_owned(),
        });
    }
    Ok(format!("{}\n{MEANING}", summary(rows)))
}
