//! The table of the study, as Markdown.

use std::fmt::Write as _;

use predicament_records::format::significant;

use super::Row;

/// The page.
pub(super) fn page(rows: &[Row]) -> String {
    let mut page = "| task | backend | elements | seconds | ns an element | bytes an element | stated | outcome |\n\
                    |---|---|---:|---:|---:|---:|---:|---|\n"
        .to_owned();
    let number = |x: f64| if x.is_nan() { "-".to_owned() } else { significant(x, 3) };
    for row in rows {
        let [bytes, stated] = row.bytes_each().map(number);
        let [seconds, each] = [row.seconds, row.nanoseconds()].map(number);
        let Row { task, backend, size, outcome, message, .. } = row;
        let outcome = if message.is_empty() { outcome.clone() } else { format!("{outcome}: {message}") };
        // Writing to a String cannot fail.
        let _ = writeln!(page, "| {task} | {backend} | {size} | {seconds} | {each} | {bytes} | {stated} | {outcome} |");
    }
    page
}
