//! The knob positions at which backends break, and the metamorphic laws that they break.

use crate::folder::FolderError;
use predicament_report::{Cell, Table};
use predicament_tasks::Knob;

use super::files::Files;
use crate::compare::words::{counted, listed, percents};
use crate::compare::{Share, ranking};
use crate::stress::{Asked, BreakPoint, Violations};
use predicament_records::format::thousands;
use predicament_records::is_predicate;

/// The first position of each knob at which a backend breaks: in predicates, then in algorithms.
pub(super) fn breaks(files: &Files) -> Result<String, FolderError> {
    let rows = files.breaks()?;
    let Asked { ways, backends, .. } = Asked::of(&rows);
    let mut table =
        Table::new("").words(["knob", "rounds the scene", "scenes a position"]).numbers(backends.iter().copied());
    for [name, way] in ways {
        let own = || rows.iter().filter(|row| row.knob == name && row.way == way && row.scenes > 0);
        let Some(first) = own().next() else { continue };
        let down = if way == "down" { ", down" } else { "" };
        let unit = Knob::ALL.iter().find(|knob| knob.name() == name).map_or("", |knob| knob.unit());
        let (least, most) = (own().map(|row| row.scenes).min(), own().map(|row| row.scenes).max());
        let scenes = match (least.unwrap_or(0), most.unwrap_or(0)) {
            (least, most) if least == most => least.to_string(),
            (least, most) => format!("{least} to {most}"),
        };
        let cells = backends.iter().map(|backend| {
            let of = |of_predicates: bool| {
                let is = |row: &&BreakPoint| row.backend == *backend && is_predicate(&row.task) == of_predicates;
                earliest(&own().filter(is).collect::<Vec<_>>())
            };
            Cell::from(format!("{}; {}", of(true), of(false)))
        });
        let words = [format!("{name}{down}: {unit}"), first.rounds.clone(), scenes].map(Cell::from);
        table.push(words.into_iter().chain(cells).collect());
    }
    Ok(format!(
        "{}\n\nEach cell has two entries: for predicates, then for algorithms. An entry is the first position at which a scene is wrong, the earliest over all tasks that the knob fits, and in parentheses the wrong scenes out of those answered there. \
         -: no scene is wrong at any position. d: the backend declines scenes, in all tasks from the given position on or in the given number of tasks. If none of the n scenes at a position is wrong, the true share is below Wilson's upper end: {}.",
        ranking::markdown(table),
        upper_ends(&rows)
    ))
}

/// The upper end of the interval of a zero share, for each number of scenes that occurs.
fn upper_ends(rows: &[BreakPoint]) -> String {
    let mut counts: Vec<u64> = rows.iter().map(|row| row.scenes).filter(|&n| n > 0).collect();
    counts.sort_unstable();
    counts.dedup();
    let ends = counts.into_iter().map(|of| format!("{} for n = {of}", percents(Share { count: 0, of })));
    listed(&ends.collect::<Vec<_>>())
}

/// The earliest break point of some tasks; if there is none, the first declined position.
fn earliest(rows: &[&BreakPoint]) -> String {
    let place = |knob: &str, position: i32| {
        let knob = Knob::ALL.into_iter().find(|of| of.name() == knob);
        knob.and_then(|knob| knob.positions().iter().position(|at| *at == position)).unwrap_or(usize::MAX)
    };
    let broken = rows.iter().filter_map(|row| Some((place(&row.knob, row.breaks_at?), row.breaks_at?, row)));
    // Of the tasks that break first, the one with the largest share of wrong scenes.
    let worst = broken.min_by(|(a, _, row), (b, _, other)| {
        a.cmp(b).then((other.wrong * row.answered).cmp(&(row.wrong * other.answered)))
    });
    if let Some((_, at, row)) = worst {
        return format!("{at} ({})", counted(Share { count: row.wrong, of: row.answered }));
    }
    if rows.is_empty() {
        return "n/a".to_owned();
    }
    let declining = rows.iter().filter(|row| row.declines_at.is_some()).count();
    if rows.iter().any(|row| row.holds_to.is_some()) {
        // A declined task says nothing about the others.
        return if declining == 0 { "-".to_owned() } else { format!("-, d in {declining} of {} tasks", rows.len()) };
    }
    let declined = rows.iter().filter_map(|row| Some((place(&row.knob, row.declines_at?), row.declines_at?)));
    declined.min().map_or("n/a".to_owned(), |(_, at)| format!("d {at}"))
}

/// The table of violations of metamorphic laws by each backend.
pub(super) fn laws(files: &Files) -> Result<String, FolderError> {
    let rows = files.violations()?;
    let mut backends: Vec<&str> = Vec::new();
    for row in &rows {
        if !backends.contains(&row.backend.as_str()) {
            backends.push(&row.backend);
        }
    }
    let line = |backend: &&str| {
        let own: Vec<&Violations> = rows.iter().filter(|row| row.backend == **backend).collect();
        let sum = |rows: &[&Violations]| {
            rows.iter().fold(Share::default(), |sum, row| Share {
                count: sum.count + row.violations,
                of: sum.of + row.tuples - row.silent,
            })
        };
        let all = sum(&own);
        let mut laws: Vec<&str> = own.iter().filter(|row| row.violations > 0).map(|row| row.law.as_str()).collect();
        laws.sort_unstable();
        laws.dedup();
        let of_law = |law: &&str| {
            let of: Vec<&Violations> = own.iter().filter(|row| row.law == *law).copied().collect();
            format!("{law} {}", counted(sum(&of)))
        };
        if all.count == 0 {
            format!("* `{backend}` violates no metamorphic law in {} tuples ({}).", thousands(all.of), percents(all))
        } else {
            let laws: Vec<String> = laws.iter().map(of_law).collect();
            format!("* `{backend}` violates a law in {} tuples ({}): {}.", counted(all), percents(all), listed(&laws))
        }
    };
    Ok(backends.iter().map(line).collect::<Vec<_>>().join("\n"))
}
