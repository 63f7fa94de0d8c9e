//! Break points and violations of laws as Markdown.

use std::fmt::Write as _;

use super::{Knob, Stressed};

/// All tables.
pub(super) fn page(stressed: &Stressed) -> String {
    // A String takes everything.
    let mut page = String::from("# Where backends break\n\n");
    page += "For each knob the position at which a backend first answers a scene against its promise (in parentheses the last one before), `-` where \
             it never does, `d` and the position where it only declines. Each is a row of `breaks.csv`; shares with their intervals are in `stress.csv`.\n";
    let mut ways: Vec<(&str, &str)> = Vec::new();
    for row in &stressed.breaks {
        if !ways.contains(&(&row.knob, &row.way)) {
            ways.push((&row.knob, &row.way));
        }
    }
    for (knob, way) in ways {
        let unit = Knob::ALL.iter().find(|of| of.name() == knob).map_or("", |knob| knob.unit());
        let _ = write!(page, "\n## {knob}{}\n\n{unit}\n\n| task |", if way == "down" { ", down" } else { "" });
        for (backend, _) in &stressed.backends {
            let _ = write!(page, " {backend} |");
        }
        let _ = writeln!(page, "\n|---|{}", "---:|".repeat(stressed.backends.len()));
        let mut tasks: Vec<&str> = stressed.breaks.iter().map(|row| row.task.as_str()).collect();
        tasks.dedup();
        let mut seen = Vec::new();
        for task in tasks {
            if seen.contains(&task) {
                continue;
            }
            seen.push(task);
            let _ = write!(page, "| {task} |");
            for (backend, _) in &stressed.backends {
                let is = |row: &&super::BreakPoint| {
                    row.task == task && row.knob == knob && row.way == way && row.backend == *backend
                };
                let cell = stressed.breaks.iter().find(is).map_or_else(String::new, |row| {
                    match (row.breaks_at, row.holds_to, row.declines_at) {
                        (Some(at), Some(before), _) => format!("{at} ({before})"),
                        (Some(at), None, _) => format!("{at}"),
                        (None, _, Some(at)) => format!("d {at}"),
                        (None, Some(_), None) => "-".to_owned(),
                        (None, None, None) => String::new(),
                    }
                });
                let _ = write!(page, " {cell} |");
            }
            page.push('\n');
        }
    }
    laws(&mut page, stressed);
    page
}

fn laws(page: &mut String, stressed: &Stressed) {
    if stressed.violations.is_empty() {
        return;
    }
    page.push_str("\n## Metamorphic laws\n\nViolations of tuples; tuples of which nothing follows are left out.\n\n| law | predicate |");
    for (backend, _) in &stressed.backends {
        let _ = write!(page, " {backend} |");
    }
    let _ = writeln!(page, "\n|---|---|{}", "---:|".repeat(stressed.backends.len()));
    let mut known: Vec<(&str, &str)> = Vec::new();
    for row in &stressed.violations {
        if !known.contains(&(&row.law, &row.predicate)) {
            known.push((&row.law, &row.predicate));
        }
    }
    known.sort_unstable();
    for (law, predicate) in known {
        let _ = write!(page, "| {law} | {predicate} |");
        for (backend, _) in &stressed.backends {
            let is = |row: &&super::Violations| row.law == law && row.predicate == predicate && row.backend == *backend;
            let cell = stressed
                .violations
                .iter()
                .find(is)
                .map_or_else(String::new, |row| format!("{} of {}", row.violations, row.tuples - row.silent));
            let _ = write!(page, " {cell} |");
        }
        page.push('\n');
    }
}
