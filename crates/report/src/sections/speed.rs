//! Speed beside error, as a plot and as the numbers behind it.

use super::{run_head, run_label};
use crate::groups::marks;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Error, RunDir, scatter};
use predicament_records::format::{length, nanoseconds, per_million, significant, thousands};

pub fn section(runs: &[RunDir]) -> Result<Section, Error> {
    let mut blocks = Vec::new();
    match scatter(runs)? {
        None => {
            let note = "No backend was both checked and timed on the same task and family.";
            blocks.push(Block::Note(note.to_owned(), Tone::Notable));
        }
        Some(svg) => {
            let alt = "Nanoseconds per query against wrong answers per million queries, a panel for each task";
            blocks.push(Block::Plot { svg, file: "scatter.svg", alt });
            blocks.push(Block::Table(table(runs)));
        }
    }
    Ok(Section {
        id: "speed",
        title: "Speed against error",
        lead: "One mark for each backend and task, over the families that were both checked and timed: the geometric \
               mean of the families' median times, and wrong answers per million of their queries. The dashed line is \
               the Pareto frontier: what is above or to the right of it is beaten by a backend on it."
            .to_owned(),
        blocks,
    })
}

fn table(runs: &[RunDir]) -> Table {
    let mut table = Table::new("The marks of the plot")
        .words(run_head(runs))
        .words(["task", "backend"])
        .numbers(["families", "queries", "wrong", "wrong per million", "ns per query"])
        .words(["frontier"]);
    for mark in marks(runs) {
        let rate = per_million(mark.errors.wrong, mark.errors.queries);
        let wrong = if mark.errors.wrong == 0 { Tone::Muted } else { Tone::Plain };
        let cells = [
            mark.task.into(),
            mark.backend.into(),
            thousands(length(mark.families)).into(),
            Cell::count(mark.errors.queries),
            Cell::count(mark.errors.wrong),
            Cell::from(rate.map_or_else(String::new, |rate| significant(rate, 3))).tone(wrong),
            nanoseconds(mark.ns).into(),
            if mark.on_frontier { Cell::from("yes") } else { Cell::default() },
        ];
        table.push(run_label(runs, mark.run).into_iter().chain(cells).collect());
    }
    table
}
