//! The pages of a scoreboard, in Markdown, and its figures as CSV.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::figures::{Board, Cell, Grade, Row};
use super::smallest::Shown;

/// The index: a table of all libraries and tasks.
pub fn index(board: &Board) -> String {
    let mut text = "# Scoreboard\n\nEach cell has the scenes that a library got right, of those that it answered; \
                    declined scenes are not among them. A page for each task has the rest.\n\n"
        .to_owned();
    let names: BTreeSet<&String> = board.tasks.values().flat_map(|task| task.keys()).collect();
    let tasks: Vec<&String> = board.tasks.keys().collect();
    let links: Vec<String> = tasks.iter().map(|task| format!("[{task}]({task}.md)")).collect();
    let _ = writeln!(text, "| library | {} |", links.join(" | "));
    let _ = writeln!(text, "|---|{}", "---:|".repeat(tasks.len()));
    for name in names {
        let cells = tasks.iter().map(|task| match board.tasks[*task].get(name) {
            None => String::new(),
            Some(row) => {
                let all = row.all();
                let answered = all.total() - all.count(Grade::Declined);
                format!("{} of {answered}", all.count(Grade::Right))
            }
        });
        let _ = writeln!(text, "| `{name}` | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    text
}

/// The library whose times are the unit: `exact` where it was timed, so that a ratio does not depend on the other
/// libraries of a run; otherwise the library with most right scenes.
fn reference(board: &Board, task: &str) -> Option<String> {
    let libraries = board.tasks.get(task)?.iter().filter(|(_, row)| !row.nanoseconds.is_empty());
    let best = libraries.max_by_key(|(name, row)| {
        (*name == "exact", row.all().count(Grade::Right), std::cmp::Reverse((*name).clone()))
    });
    best.map(|(name, _)| name.clone())
}

/// The page of one task; `shown` are the smallest scenes of its cells.
pub fn page(board: &Board, task: &str, shown: &[Shown]) -> String {
    let mut text = format!("# {task}\n\n");
    let Some(rows) = board.tasks.get(task) else { return text };
    let reference = reference(board, task);
    let of = reference.as_ref().and_then(|name| rows.get(name));
    text += "Scenes by their worst finding. *Broken* is a wrong answer, *rounded* one that is off by its rounding, \
             *failed* an exception, a crash or a timeout. Distances are those of the farthest vertex of each result.\n\n";
    let unit = reference.as_deref().map_or_else(|| "time".to_owned(), |name| format!("time / `{name}` (families)"));
    let _ = writeln!(
        text,
        "| library | scenes | right | rounded | broken | failed | declined | median | worst | worst / L | {unit} | memory |"
    );
    let _ = writeln!(text, "|---|{}", "---:|".repeat(11));
    for (name, row) in rows {
        let all = row.all();
        let counts: Vec<String> = [Grade::Right, Grade::Rounded, Grade::Broken, Grade::Failed, Grade::Declined]
            .into_iter()
            .map(|grade| all.count(grade).to_string())
            .collect();
        let time = of.and_then(|of| row.ratio(of)).map_or_else(String::new, |(ratio, n)| format!("{ratio:.2} ({n})"));
        let _ = writeln!(
            text,
            "| `{name}` | {} | {} | {} | {} | {} | {time} | {} |",
            all.total(),
            counts.join(" | "),
            row.median_ulps().map_or_else(String::new, |ulps| format!("{} ulp", short(ulps))),
            row.ulps.last().map_or_else(String::new, |ulps| format!("{} ulp", short(*ulps))),
            if row.ulps.is_empty() { String::new() } else { format!("{:.1e}", row.worst_over_l) },
            if row.bytes == 0 { String::new() } else { format!("{} MiB", row.bytes >> 20) },
        );
    }
    text += "\n## By suite\n\nRight scenes of all, then what else there is.\n\n";
    let suites: BTreeSet<&String> = rows.values().flat_map(|row| row.suites.keys()).collect();
    let names: Vec<String> = suites.iter().map(|suite| format!("`{suite}`")).collect();
    let _ = writeln!(text, "| library | {} |\n|---|{}", names.join(" | "), "---|".repeat(suites.len()));
    for (name, row) in rows {
        let cells = suites.iter().map(|suite| row.suites.get(*suite).map_or_else(String::new, brief));
        let _ = writeln!(text, "| `{name}` | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    if !shown.is_empty() {
        text += "\n## The smallest scene of each kind\n";
    }
    for Shown { library, grade, scene, got, suite, picture, command } in shown {
        let _ = write!(text, "\n### `{library}`: {}, {scene}\n\n{got}\n\n", grade.name());
        if let Some(picture) = picture {
            let _ = writeln!(text, "![{scene}]({picture})\n");
        }
        if let Some(suite) = suite {
            let _ = writeln!(text, "[The scene as a suite]({suite}), and the command that shows it:\n");
        }
        let _ = writeln!(text, "```sh\n{command}\n```");
    }
    text
}

/// A cell in a few words.
fn brief(cell: &Cell) -> String {
    let mut text = format!("{} of {}", cell.count(Grade::Right), cell.total());
    for grade in [Grade::Broken, Grade::Failed, Grade::Rounded, Grade::Declined] {
        if cell.count(grade) > 0 {
            let _ = write!(text, ", {} {}", cell.count(grade), grade.name());
        }
    }
    text
}

/// A number of at most four digits.
fn short(x: f64) -> String {
    if x == 0.0 || (0.01..10_000.0).contains(&x) { format!("{x:.2}") } else { format!("{x:.1e}") }
}

/// All figures as CSV: a row for each task, library and suite.
pub fn csv(board: &Board) -> String {
    let mut text = "task,library,suite,scenes,right,rounded,broken,failed,declined\n".to_owned();
    for (task, rows) in &board.tasks {
        for (library, Row { suites, .. }) in rows {
            for (suite, cell) in suites {
                let of = |grade| cell.count(grade);
                let _ = writeln!(
                    text,
                    "{task},{library},{suite},{},{},{},{},{},{}",
                    cell.total(),
                    of(Grade::Right),
                    of(Grade::Rounded),
                    of(Grade::Broken),
                    of(Grade::Failed),
                    of(Grade::Declined)
                );
            }
        }
    }
    text
}
