//! Points in a tiling of the plane: each should be in exactly one region.

use super::{rank, run_head, run_label};
use crate::RunDir;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let mut table = Table::new("").words(run_head(runs)).words(["scene", "surroundings", "backend"]).numbers([
        "probes",
        "in none",
        "in one",
        "in many",
        "on boundary",
        "violations",
    ]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows: Vec<_> = run.locate.iter().collect();
        rows.sort_by_key(|r| ([&*r.suite, &*r.scene, &*r.scene_id, &*r.surroundings], rank(&order, &r.backend)));
        for row in rows {
            let violated = if row.violations == 0 { Tone::Muted } else { Tone::Bad };
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.surroundings.as_str().into(),
                row.backend.as_str().into(),
                Cell::count(row.probes),
                Cell::count(row.in_none),
                Cell::count(row.in_one),
                Cell::count(row.in_many),
                Cell::count(row.on_boundary),
                Cell::count(row.violations).tone(violated),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    let block = Block::table_or(table, "No point was located in a map.");
    Section {
        id: "locate",
        title: "Points in a map",
        lead: "Probes by what the map is like around them, and in how many regions each backend found them. A \
               violation is an answer that no consistent reading of the map allows."
            .to_owned(),
        blocks: vec![block],
    }
}
