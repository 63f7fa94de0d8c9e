//! Contacts between two complexes: on which level of the hierarchy pairs were registered, and how many had ended.

use std::collections::BTreeMap;

use super::{rank, run_head, run_label};
use crate::format::percent;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table};
use crate::{ContactRow, RunDir};

/// Levels are sums of two ranks: 0 for two vertices, the dimension for pairs in general position.
const LEVELS: usize = 4;

/// All kinds of pairs of one level.
#[derive(Clone, Copy, Default)]
struct Level {
    registered: u64,
    candidates: u64,
    ended: u64,
}

impl Level {
    fn add(&mut self, row: &ContactRow) {
        self.registered += row.registered;
        self.candidates += row.candidates;
        self.ended += row.ended;
    }

    fn cell(self) -> Cell {
        let cell = Cell::count(self.registered);
        if self.candidates == 0 { cell } else { cell.detail(format!("{} ended", percent(self.ended, self.candidates))) }
    }
}

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let mut table = Table::new("Registered pairs, and the share of the candidates that had ended before")
        .words(run_head(runs))
        .words(["scene", "task", "backend"])
        .numbers((0..LEVELS).map(|level| format!("level {level}")));
    for (index, run) in runs.iter().enumerate() {
        let mut rows: BTreeMap<_, [Option<Level>; LEVELS]> = BTreeMap::new();
        for row in &run.contacts {
            let key = ([&*row.suite, &*row.scene, &*row.scene_id, &*row.task], rank(&order, &row.backend));
            let levels = rows.entry(key).or_default();
            if let Some(level) = levels.get_mut(usize::from(row.rank_a) + usize::from(row.rank_b)) {
                level.get_or_insert_default().add(row);
            }
        }
        for (([suite, scene, _, task], backend), levels) in rows {
            let backend = order.get(backend).copied().unwrap_or_default();
            let cells = [Cell::from(scene).detail(suite), task.into(), backend.into()].into_iter();
            let levels = levels.map(|level| level.map_or_else(|| Cell::from(""), Level::cell));
            table.push(run_label(runs, index).into_iter().chain(cells).chain(levels).collect());
        }
    }
    let block = Block::table_or(table, "No contacts between complexes were asked for.");
    Section {
        id: "contacts",
        title: "Contacts",
        lead: "Pairs of simplices of two complexes by their level, the sum of their ranks: two vertices are level 0; \
               the last level holds the pairs that meet in general position. Candidates have boxes near each other; \
               one has ended where a pair of its faces was registered before, and is not asked about."
            .to_owned(),
        blocks: vec![block],
    }
}
