//! Unions of cubes: what was measured, and how far off it is.

use super::{rank, run_head, run_label};
use crate::RunDir;
use crate::format::significant;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let mut table = Table::new("").words(run_head(runs)).words(["scene", "backend"]).numbers([
        "cubes",
        "volume",
        "area",
        "edge length",
        "corners",
        "edge-face",
        "three-face",
    ]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows: Vec<_> = run.masses.iter().collect();
        rows.sort_by_key(|r| ([&*r.suite, &*r.scene, &*r.scene_id], rank(&order, &r.backend)));
        for row in rows {
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.backend.as_str().into(),
                Cell::count(row.cubes),
                against(row.volume, row.true_volume),
                against(row.area, row.true_area),
                against(row.edge_length, row.true_edge_length),
                Cell::count(row.corners),
                Cell::count(row.edge_faces),
                Cell::count(row.three_faces),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    let block = Block::table_or(table, "No union of cubes was measured.");
    Section {
        id: "cubes",
        title: "Unions of cubes",
        lead: "Volume, area and edge length as sums over the vertices of the union, and the vertices by kind. Where a \
               sum is not the true one, both are shown. Area and edge length are those of the perturbed cubes, in the \
               limit."
            .to_owned(),
        blocks: vec![block],
    }
}

/// A measure, with the true one where it is another.
fn against(found: f64, truth: f64) -> Cell {
    #[allow(clippy::float_cmp)] // equal sums are rounded to equal doubles
    if found == truth {
        return Cell::from(significant(found, 6));
    }
    let found = if found < 0.0 { format!("−{}", significant(-found, 6)) } else { significant(found, 6) };
    Cell::from(found).detail(format!("true: {}", significant(truth, 6))).tone(Tone::Bad)
}
