//! Which rung of a backend's ladder settled how many queries.

use std::collections::BTreeMap;

use super::{rank, run_head, run_label};
use crate::RunDir;
use crate::format::percent;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};

/// Rungs and how many queries each settled.
type Ladder<'r> = Vec<(&'r str, u64)>;

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["task", "family", "backend"])
        .numbers(["queries settled"])
        .words(["by stage"]);
    for (index, run) in runs.iter().enumerate() {
        let mut groups: BTreeMap<(&str, &str, usize), Ladder> = BTreeMap::new();
        for row in &run.stages {
            let stages = groups.entry((&row.task, &row.family, rank(&order, &row.backend))).or_default();
            // Rungs keep the order of the file, which is that of the ladder.
            match stages.iter_mut().find(|(stage, _)| *stage == row.stage) {
                Some((_, settled)) => *settled += row.settled,
                None => stages.push((&row.stage, row.settled)),
            }
        }
        for ((task, family, backend), stages) in groups {
            let all = stages.iter().map(|(_, settled)| settled).sum();
            let shares = stages.iter().filter(|(_, settled)| *settled > 0);
            let shares: Vec<String> = shares.map(|(stage, n)| format!("{stage} {}", percent(*n, all))).collect();
            let cells =
                [task.into(), family.into(), order[backend].into(), Cell::count(all), shares.join(" · ").into()];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    let block = if table.is_empty() {
        Block::Note("No stage was counted.".to_owned(), Tone::Notable)
    } else {
        Block::Table(table)
    };
    Section {
        id: "stages",
        title: "Stages",
        lead: "A query climbs a backend's ladder, cheapest rung first, until one can settle it.".to_owned(),
        blocks: vec![block],
    }
}
