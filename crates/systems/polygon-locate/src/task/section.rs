//! The table `locate.csv` and its section in a report.

use predicament_records::{Error, Row, RunDir};
use predicament_report::layout::{backends, rank, run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

predicament_records::table! {
    /// `locate.csv`: the number of regions of a tiling in which the probes were found.
    pub struct LocateRow [Clone, PartialEq, Eq, Debug] in "locate.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The kind of map around these probes: `land`, `coast`, `sea`, …
        pub surroundings: String,
        /// The number of probes.
        pub probes: u64,
        /// Probes found in no region.
        pub in_none: u64,
        /// Probes found in exactly one region.
        pub in_one: u64,
        /// Probes found in two or more regions.
        pub in_many: u64,
        /// Probes reported to be on a boundary.
        pub on_boundary: u64,
        /// Probes with an answer that is impossible for a tiling of the plane.
        pub violations: u64,
    }
}

/// The section of a report.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["scene", "surroundings", "backend"])
        .of(Origin::of(LocateRow::FILE).keys(["scene", "surroundings", "backend"]).under("scene", "suite"))
        .numbers(["probes", "in none", "in one", "in many", "on boundary", "violations"]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows = run.rows::<LocateRow>()?;
        rows.sort_by_cached_key(|r| {
            ([&r.suite, &r.scene, &r.scene_id, &r.surroundings].map(String::clone), rank(&order, &r.backend))
        });
        for row in &rows {
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
    let block = Block::table_or(table, "The runs have no points in maps.");
    Ok(Some(Section {
        id: "locate",
        title: "Points in a map",
        lead: "Probes by the surroundings of the probe in the map, and the number of regions in which each backend \
               located them. A violation is an answer that is impossible for the map."
            .to_owned(),
        blocks: vec![block],
    }))
}
