//! Break points and violations of laws as Markdown.

use std::fmt::Write as _;

use predicament_tasks::Knob;

use super::{Asked, BreakPoint, Stressed};
use crate::compare::{short, sweep};

/// The page with all tables.
pub(super) fn page(stressed: &Stressed) -> String {
    // Writing to a String cannot fail.
    let mut page = String::from("# Where backends break\n\n");
    page += "A cell has the position at which a backend first breaks its promise on a scene, and in parentheses the last position before; `-` if it never does; `d` \
             and a position if it only declines; `n/a` if the knob does not fit the task. Then follow the wrong scenes out of those answered there or, if none is wrong, \
             the largest share that this number of scenes leaves possible (Wilson's, 95 %). Scenes: the number of distinct scenes at each position. Each cell is a row \
             of `breaks.csv`; shares with their intervals are in `stress.csv`.\n";
    let Asked { ways, tasks, .. } = Asked::of(&stressed.breaks);
    for [knob, way] in ways {
        let unit = Knob::ALL.iter().find(|of| of.name() == knob).map_or("", |knob| knob.unit());
        let down = if way == "down" { ", down" } else { "" };
        let rounds = stressed.breaks.iter().find(|row| row.knob == knob).map_or("", |row| &row.rounds);
        let _ = write!(page, "\n## {knob}{down}\n\n{unit}. Rounds the scene: {rounds}.\n\n| task | scenes |");
        for (backend, _) in &stressed.backends {
            let _ = write!(page, " {backend} |");
        }
        let _ = writeln!(page, "\n|---|---:|{}", "---:|".repeat(stressed.backends.len()));
        for task in &tasks {
            let scenes = stressed.breaks.iter().filter(|row| row.task == *task && row.knob == knob && row.way == way);
            let _ = write!(page, "| {task} | {} |", scenes.map(|row| row.scenes).max().unwrap_or(0));
            for (backend, _) in &stressed.backends {
                let is = |row: &&super::BreakPoint| {
                    row.task == *task && row.knob == knob && row.way == way && row.backend == *backend
                };
                let cell = stressed.breaks.iter().find(is).map_or_else(String::new, |row| match counts(row) {
                    Some(counts) => format!("{}; {counts}", place(row)),
                    None => place(row),
                });
                let _ = write!(page, " {cell} |");
            }
            page.push('\n');
        }
    }
    limits(&mut page, stressed);
    page += &sweep::page(&stressed.measures);
    times(&mut page, stressed);
    laws(&mut page, stressed);
    page
}

/// The text of a break point in a cell.
pub(super) fn place(row: &BreakPoint) -> String {
    match (row.breaks_at, row.holds_to, row.declines_at) {
        (Some(at), Some(before), _) => format!("{at} ({before})"),
        (Some(at), None, _) => format!("{at}"),
        (None, _, Some(at)) => format!("d {at}"),
        (None, Some(_), None) => "-".to_owned(),
        (None, None, None) => "n/a".to_owned(),
    }
}

/// The number of wrong scenes at a break point.
///
/// Without a break point it is the upper limit that zero wrong scenes leave.
pub(super) fn counts(row: &BreakPoint) -> Option<String> {
    (row.answered > 0).then(|| match row.breaks_at {
        Some(_) => format!("{} of {}", row.wrong, row.answered),
        None => format!("at most {:.0} %", 100.0 * row.wrong_high),
    })
}

/// Writes the knobs that do not fit a task, or not to the end.
fn limits(page: &mut String, stressed: &Stressed) {
    if stressed.limits.is_empty() {
        return;
    }
    page.push_str("\n## Not applicable\n\nSome knobs are not turned for a task, or not to the end, because the scenes would not be valid for the task. The rows are in `limits.csv`.\n\n| task | knob | turned | reason for the limit |\n|---|---|---|---|\n");
    for row in &stressed.limits {
        let to = row.to.map_or_else(|| "not at all".to_owned(), |to| format!("to {to}"));
        let _ = writeln!(page, "| {} | {} | {to} | {} |", row.task, row.knob, row.why);
    }
}

/// Writes the time at rest and at the last position, for each timed knob.
fn times(page: &mut String, stressed: &Stressed) {
    let timed: Vec<&crate::compare::Measure> = stressed.measures.iter().filter(|row| row.measure == "time").collect();
    if timed.is_empty() {
        return;
    }
    page.push_str("\n## Time along the knobs\n\nNanoseconds per query, primitive or triangle at rest, then the slowdown at the slowest position (in parentheses). All times are rows of `stress.csv`.\n\n| knob | task |");
    for (backend, _) in &stressed.backends {
        let _ = write!(page, " {backend} |");
    }
    let _ = writeln!(page, "\n|---|---|{}", "---:|".repeat(stressed.backends.len()));
    let mut of: Vec<(&str, &str)> = Vec::new();
    for row in &timed {
        if !of.contains(&(&row.kind, &row.task)) {
            of.push((&row.kind, &row.task));
        }
    }
    for knob in Knob::ALL.map(Knob::name) {
        for &(_, task) in of.iter().filter(|(of, _)| *of == knob) {
            let _ = write!(page, "| {knob} | {task} |");
            for (backend, _) in &stressed.backends {
                let own =
                    || timed.iter().filter(|row| row.kind == knob && row.task == *task && row.backend == *backend);
                let longest = own().max_by(|a, b| a.value.total_cmp(&b.value));
                let cell = own().next().zip(longest).map_or("–".to_owned(), |(rest, longest)| {
                    let times = short(Some(longest.value / rest.value));
                    format!("{}, {times} ({})", short(Some(rest.value)), longest.family)
                });
                let _ = write!(page, " {cell} |");
            }
            page.push('\n');
        }
    }
}

fn laws(page: &mut String, stressed: &Stressed) {
    if stressed.violations.is_empty() {
        return;
    }
    page.push_str("\n## Metamorphic laws\n\nTuples whose answers violate the law, out of the tuples for which the law has a consequence.\n\n| law | predicate |");
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
