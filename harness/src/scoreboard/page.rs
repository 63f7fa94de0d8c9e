//! The pages of a scoreboard, in Markdown, and its figures as CSV.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::figures::{Board, Cell, Grade, Row};
use super::smallest::Shown;

/// The text above the index.
pub(super) const LEAD: &str = "Each cell has the scenes that a library got right, of those that it answered; declined \
                               scenes are not among them. A page for each task has the rest.";
/// The text above the figures of a task.
pub(super) const KEY: &str = "Scenes by their worst finding. Broken is a wrong answer, rounded one that is off by its \
                              rounding, failed a crash or a timeout, refused an error for valid input, accepted an \
                              answer to invalid input. Distances are those of the farthest vertex of each result.";

/// The index: a table of all libraries and tasks.
pub fn index(board: &Board) -> String {
    let mut text = format!("# Scoreboard\n\n{LEAD}\n\n");
    let names: BTreeSet<&String> = board.tasks.values().flat_map(|task| task.keys()).collect();
    let tasks: Vec<&String> = board.tasks.keys().collect();
    let links: Vec<String> = tasks.iter().map(|task| format!("[{task}]({task}.md)")).collect();
    let _ = writeln!(text, "| library | {} |", links.join(" | "));
    let _ = writeln!(text, "|---|{}", "---:|".repeat(tasks.len()));
    for name in names {
        let cells = tasks.iter().map(|task| board.tasks[*task].get(name).map_or_else(String::new, count));
        let _ = writeln!(text, "| `{name}` | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    text
}

/// The right scenes of a library on a task, of those that it answered.
pub(super) fn count(row: &Row) -> String {
    let all = row.all();
    format!("{} of {}", all.count(Grade::Right), all.total() - all.count(Grade::Declined))
}

/// The figures of each library on a task: the heads of the columns after the name, and the cells of each row.
pub(super) fn figures<'r>(
    rows: &'r BTreeMap<String, Row>,
    reference: Option<&str>,
    of: Option<&Row>,
) -> (Vec<String>, Vec<(&'r str, Vec<String>)>) {
    let unit = reference.map_or_else(|| "time".to_owned(), |name| format!("time / `{name}` (families)"));
    let heads = ["scenes"].into_iter().chain(Grade::ALL.map(Grade::name)).chain(["median", "worst", "worst / L"]);
    let heads = heads.map(str::to_owned).chain([unit, "memory".to_owned()]).collect();
    let line = |(name, row): (&'r String, &Row)| {
        let all = row.all();
        let counts = [all.total()].into_iter().chain(Grade::ALL.map(|grade| all.count(grade))).map(|n| n.to_string());
        let ulps = |ulps: Option<f64>| ulps.map_or_else(String::new, |ulps| format!("{} ulp", short(ulps)));
        let rest = [
            ulps(row.median_ulps()),
            ulps(row.ulps.last().copied()),
            if row.ulps.is_empty() { String::new() } else { format!("{:.1e}", row.worst_over_l) },
            of.and_then(|of| row.ratio(of)).map_or_else(String::new, |(ratio, n)| format!("{ratio:.2} ({n})")),
            if row.bytes == 0 { String::new() } else { format!("{} MiB", row.bytes >> 20) },
        ];
        (name.as_str(), counts.chain(rest).collect())
    };
    (heads, rows.iter().map(line).collect())
}

/// The library whose times are the unit: `exact` where it was timed, so that a ratio does not depend on the other
/// libraries of a run; otherwise the library with most right scenes.
pub(super) fn reference(board: &Board, task: &str) -> Option<String> {
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
    let _ = writeln!(
        text,
        "{}\n",
        KEY.replace("Broken", "*Broken*")
            .replace(" rounded", " *rounded*")
            .replace(" failed", " *failed*")
            .replace(" refused", " *refused*")
            .replace(" accepted", " *accepted*")
    );
    let (heads, lines) = figures(rows, reference.as_deref(), of);
    let _ = writeln!(text, "| library | {} |\n|---|{}", heads.join(" | "), "---:|".repeat(heads.len()));
    for (name, cells) in lines {
        let _ = writeln!(text, "| `{name}` | {} |", cells.join(" | "));
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
        let _ = write!(text, "\n### `{library}`: {}, {scene}\n\n{}\n\n", grade.name(), literal(got));
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

/// Markdown that shows a text as it is: a program's message may hold what reads as a link, as HTML or as emphasis.
fn literal(text: &str) -> String {
    let escaped = |sign| if "\\`*_[<&".contains(sign) { vec!['\\', sign] } else { vec![sign] };
    text.chars().flat_map(escaped).collect()
}

/// A cell in a few words.
pub(super) fn brief(cell: &Cell) -> String {
    let mut text = format!("{} of {}", cell.count(Grade::Right), cell.total());
    for grade in Grade::ALL.into_iter().filter(|grade| *grade != Grade::Right) {
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
    let mut text = format!("task,library,suite,scenes,{}\n", Grade::ALL.map(Grade::name).join(","));
    for (task, rows) in &board.tasks {
        for (library, Row { suites, .. }) in rows {
            for (suite, cell) in suites {
                let counts = Grade::ALL.map(|grade| cell.count(grade).to_string()).join(",");
                let _ = writeln!(text, "{task},{library},{suite},{},{counts}", cell.total());
            }
        }
    }
    text
}

#[test]
fn what_a_program_says_is_no_markup() {
    assert_eq!(literal(r"Of<v8::F> [a](b) *c_d* `e` &lt; \f"), r"Of\<v8::F> \[a](b) \*c\_d\* \`e\` \&lt; \\f");
}
