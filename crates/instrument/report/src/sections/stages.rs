//! The section on the numbers of queries that each rung of a backend's ladder settled.

use std::collections::{BTreeMap, BTreeSet};

use super::{rank, run_head, run_label};
use crate::groups::backends;
use crate::rungs::{rung, rungs};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Origin, RunDir};
use predicament_records::format::percent;

/// The number of queries that a rung settled, and its deepest stage if stages are numbered.
#[derive(Clone, Copy, Default)]
struct Settled {
    queries: u64,
    deepest: Option<u64>,
}

/// The section, or `None` if no stage was counted.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let order = backends(runs);
    let mut climbed: BTreeMap<usize, BTreeSet<&str>> = BTreeMap::new();
    for row in runs.iter().flat_map(|run| &run.stages).filter(|row| row.settled > 0) {
        climbed.entry(rank(&order, &row.backend)).or_default().insert(rung(&row.stage).0);
    }
    // A backend with only one rung has no shares.
    let (flat, ladders): (BTreeMap<_, _>, BTreeMap<_, _>) =
        climbed.into_iter().partition(|(_, rungs)| rungs.len() == 1);
    let columns: Vec<&str> =
        rungs(runs).into_iter().filter(|rung| ladders.values().any(|rungs| rungs.contains(rung))).collect();

    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["task", "family", "backend"])
        .of(Origin::of("stages.csv").keys(["task", "family", "backend"]))
        .numbers(["queries settled"])
        .numbers(columns.iter().copied());
    for (index, run) in runs.iter().enumerate() {
        let mut groups: BTreeMap<(&str, &str, usize), BTreeMap<&str, Settled>> = BTreeMap::new();
        for row in &run.stages {
            let backend = rank(&order, &row.backend);
            if row.settled > 0 && ladders.contains_key(&backend) {
                let (rung, number) = rung(&row.stage);
                let rungs = groups.entry((&row.task, &row.family, backend)).or_default();
                let settled = rungs.entry(rung).or_default();
                settled.queries += row.settled;
                settled.deepest = settled.deepest.max(number);
            }
        }
        for ((task, family, backend), rungs) in groups {
            let all = rungs.values().map(|settled| settled.queries).sum();
            let cells = [task.into(), family.into(), order[backend].into(), Cell::count(all)];
            let shares = columns.iter().map(|rung| share(rungs.get(rung), all));
            table.push(run_label(runs, index).into_iter().chain(cells).chain(shares).collect());
        }
    }

    let mut blocks = Vec::new();
    if !table.is_empty() {
        blocks.push(Block::Table(table));
    }
    if !flat.is_empty() {
        let names = flat.iter().flat_map(|(&backend, rungs)| rungs.iter().map(move |rung| (backend, rung)));
        let names: Vec<String> = names.map(|(backend, rung)| format!("{} ({rung})", order[backend])).collect();
        blocks.push(Block::Note(format!("One stage settled every query: {}.", names.join(", ")), Tone::Muted));
    }
    (!blocks.is_empty()).then(|| Section {
        id: "stages",
        title: "Stages",
        lead: "A query climbs a backend's ladder, cheapest rung first, until a rung can settle it. Columns are the \
               rungs of the exact backend from left to right, then the rungs of other backends. Stages that differ \
               only by a number share a column; the deepest stage is beside the share."
            .to_owned(),
        blocks,
    })
}

fn share(settled: Option<&Settled>, all: u64) -> Cell {
    match settled {
        None => Cell::from("—").tone(Tone::Muted),
        Some(&Settled { queries, deepest }) => {
            let share = Cell::from(percent(queries, all));
            deepest.into_iter().fold(share, |share, deepest| share.detail(format!("to {deepest}")))
        }
    }
}
