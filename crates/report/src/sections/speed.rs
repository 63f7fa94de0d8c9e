//! The section about speed and error: the scatter plot and its numbers.

use super::{run_head, run_label};
use crate::figures::{FILE, Mark, panels};
use crate::groups::{REFERENCE, backends};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Error, Origin, RunDir, scatter};
use predicament_records::format::{factor, nanoseconds, per_million, significant};

pub fn section(runs: &[RunDir]) -> Result<Section, Error> {
    let mut blocks = Vec::new();
    match scatter(runs)? {
        None => {
            let note = "No backend was both checked and timed on the same task and family.";
            blocks.push(Block::Note(note.to_owned(), Tone::Notable));
        }
        Some(picture) => {
            let alt = "Wrong answers per million queries against nanoseconds per query, a panel for each task";
            blocks.push(Block::Plot { picture, file: "scatter.svg".into(), alt: alt.into() });
            blocks.push(Block::Table(table(runs)));
            let partial = partial(runs);
            if !partial.is_empty() {
                blocks.push(Block::Table(partial));
            }
        }
    }
    Ok(Section {
        id: "speed",
        title: "Speed against error",
        lead: format!(
            "One mark for each backend and task: the geometric mean of the families' times, and wrong answers per million \
             of their queries, over the families that all compared backends of the panel were checked and timed on; the \
             title says how many of how many these are. A mark has lines from its shortest to its longest samples, and over Wilson's interval at 95 % of what is wrong; what was never wrong stands on the \
             shelf at the bottom. In the table {REFERENCE} stands beside it on the very same families. A \
             backend that did too few of them is partial: a hollow mark over its own families; a table of its own \
             has all that did the same. The dashed line is the Pareto frontier: of the compared backends, what is above or \
             to the right of it is beaten by one on it. figures.csv, beside this page, has the same figures in full."
        ),
        blocks,
    })
}

fn table(runs: &[RunDir]) -> Table {
    let mut table = Table::new("The marks of the plot")
        .words(run_head(runs))
        .words(["task", "backend"])
        .of(Origin::of(FILE).key("task", "panel").keys(["run", "backend"]))
        .numbers(["families", "queries", "wrong", "wrong per million", "ns per query"])
        .numbers([format!("{REFERENCE} on the same"), "ratio".to_owned()])
        .words(["frontier"]);
    for panel in panels(runs) {
        for mark in panel.marks {
            let rate = per_million(mark.errors.wrong, mark.errors.queries);
            let wrong = if mark.errors.wrong == 0 { Tone::Muted } else { Tone::Plain };
            let none = || Cell::from("—").tone(Tone::Muted);
            let cells = [
                panel.task.into(),
                mark.backend.into(),
                format!("{} of {}", mark.families, panel.of).into(),
                Cell::count(mark.errors.queries),
                Cell::count(mark.errors.wrong),
                Cell::from(rate.map_or_else(String::new, |rate| significant(rate, 3))).tone(wrong),
                nanoseconds(mark.ns).into(),
                mark.reference.map_or_else(none, |reference| nanoseconds(reference).into()),
                mark.reference.map_or_else(none, |reference| factor(mark.ns / reference).into()),
                match mark {
                    Mark { is_partial: true, .. } => Cell::from("partial").tone(Tone::Muted),
                    Mark { on_frontier: true, .. } => Cell::from("yes"),
                    _ => Cell::default(),
                },
            ];
            table.push(run_label(runs, panel.run).into_iter().chain(cells).collect());
        }
    }
    table
}

/// What each partial backend did, and what that took the others.
fn partial(runs: &[RunDir]) -> Table {
    let panels = panels(runs);
    let does = |backend: &str| panels.iter().flat_map(|panel| &panel.partial).any(|of| of.ns.contains_key(backend));
    let columns: Vec<&str> = backends(runs).into_iter().filter(|backend| does(backend)).collect();
    let mut table = Table::new("Partial backends: ns per query over the families that each of them did")
        .words(run_head(runs))
        .words(["task", "partial"])
        .of(Origin::of("throughput.csv").keys(["task"]).key("partial", "backend"))
        .numbers(["families"])
        .of(Origin::of("throughput.csv").keys(["task"]).across("backend"))
        .numbers(columns.iter().copied());
    for panel in &panels {
        for of in &panel.partial {
            let families = format!("{} of {}", of.families, panel.of);
            let cells = [panel.task.into(), of.backend.into(), families.into()].into_iter();
            let times = columns.iter().map(|backend| match of.ns.get(backend) {
                None => Cell::from("—").tone(Tone::Muted),
                Some(&ns) => nanoseconds(ns).into(),
            });
            table.push(run_label(runs, panel.run).into_iter().chain(cells).chain(times).collect());
        }
    }
    table
}
