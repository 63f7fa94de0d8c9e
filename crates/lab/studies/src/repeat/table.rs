//! The table of the study, as Markdown: unstable answers by backend and way.

use std::fmt::Write as _;

use predicament_predicates::Class;

use super::{Row, Way};

/// The page.
pub(super) fn page(rows: &[Row]) -> String {
    let mut backends: Vec<&str> = rows.iter().map(|row| row.backend.as_str()).collect();
    backends.dedup();
    let ways = Way::ALL.map(|way| way.to_string());
    // Writing to a String cannot fail.
    let mut page = format!("| backend | scenes | {} |\n|---|---:|{}\n", ways.join(" | "), "---|".repeat(ways.len()));
    for backend in backends {
        let of = |row: &&Row| row.backend == backend && row.class != Class::Declined;
        let scenes = rows.iter().filter(of).filter(|row| row.way == ways[0]).count();
        let cells = ways.iter().map(|way| {
            let here: Vec<&Row> = rows.iter().filter(of).filter(|row| row.way == *way).collect();
            let unstable: u64 = here.iter().map(|row| row.unstable).sum();
            match (here.is_empty(), unstable) {
                (true, _) => "-".to_owned(),
                (false, 0) => "0".to_owned(),
                (false, n) => format!("{n} of {}", here.iter().map(|row| row.answers).sum::<u64>()),
            }
        });
        let _ = writeln!(page, "| `{backend}` | {scenes} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    let mut unstable = rows.iter().filter(|row| row.class == Class::Unstable).peekable();
    if unstable.peek().is_some() {
        page += "\n| unstable | task | scene | way | query | first | second |\n|---|---|---|---|---|---|---|\n";
    }
    for Row { backend, task, scene, way, query, first, second, .. } in unstable {
        let _ = writeln!(page, "| `{backend}` | {task} | {scene} | {way} | {query} | {first} | {second} |");
    }
    page
}
