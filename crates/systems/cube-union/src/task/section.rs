//! `masses.csv`, and its section of a report.

use predicament_records::format::significant;
use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{backends, rank, run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

predicament_records::table! {
    /// `masses.csv`: the measures of a union of cubes.
    pub struct MassRow [Clone, PartialEq, Debug] in "masses.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The number of cubes.
        pub cubes: u64,
        /// The volume found by the backend, in the scene's units, rounded once.
        pub volume: f64 ["cubed units"],
        /// The true volume, rounded once.
        pub true_volume: f64 ["cubed units"],
        /// The area of the boundary found by the backend.
        pub area: f64 ["squared units"],
        /// The area that is expected: if the backend breaks ties, that of the perturbed union, in the limit of a
        /// perturbation that goes to zero; otherwise that of the union of closed cubes.
        pub limit_area: f64 ["squared units"],
        /// The total length of the boundary's edges found by the backend.
        pub edge_length: f64 ["units"],
        /// The total length of edges that is expected, of the same union.
        pub limit_edge_length: f64 ["units"],
        /// Corners of cubes that the backend found on the boundary.
        pub corners: u64,
        /// Points where an edge of one cube meets a face of another.
        pub edge_faces: u64,
        /// Points where the faces of three cubes meet.
        pub three_faces: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        // As doubles, measures of tiny cubes are zero and those of huge cubes infinite. (The judgement is in
        // rationals.)
        if [self.true_volume, self.limit_area, self.limit_edge_length].iter().all(|&x| x >= 0.0) {
            Ok(())
        } else {
            Err(RowError::Contradiction("an expected measure is negative or NaN"))
        }
    }
}

/// The section of a report about unions of cubes.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["scene", "backend"])
        .of(Origin::of(MassRow::FILE).keys(["scene", "backend"]).under("scene", "suite"))
        .numbers(["cubes", "volume", "area", "edge length", "corners", "edge-face", "three-face"]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows = run.rows::<MassRow>()?;
        rows.sort_by_cached_key(|r| ([r.suite.clone(), r.scene.clone(), r.scene_id.clone()], rank(&order, &r.backend)));
        for row in &rows {
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.backend.as_str().into(),
                Cell::count(row.cubes),
                against(row.volume, row.true_volume),
                against(row.area, row.limit_area),
                against(row.edge_length, row.limit_edge_length),
                Cell::count(row.corners),
                Cell::count(row.edge_faces),
                Cell::count(row.three_faces),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    let block = Block::table_or(table, "The runs have no union of cubes.");
    Ok(Some(Section {
        id: "cubes",
        title: "Unions of cubes",
        lead: "Volume, area and edge length of the union, as sums over its vertices, and the number of vertices of \
               each kind. If a sum is not as expected, the table shows both values. Of a backend that breaks ties, area \
               and edge length are the limits of the measures of the perturbed cubes; of any other backend, those of \
               closed cubes."
            .to_owned(),
        blocks: vec![block],
    }))
}

/// A measure, with the expected one if they differ.
fn against(found: f64, truth: f64) -> Cell {
    #[allow(clippy::float_cmp)] // equal sums are rounded to equal doubles
    if found == truth {
        return Cell::from(significant(found, 6));
    }
    let found = if found < 0.0 { format!("−{}", significant(-found, 6)) } else { significant(found, 6) };
    Cell::from(found).detail(format!("expected: {}", significant(truth, 6))).tone(Tone::Bad)
}
