//! The table `mesh_intersect.csv` and its section in a report.

use predicament_overlay::algorithm::overlay::Operation;
use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{backends, rank, run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

use super::{MeshIntersect, Overlaid};
use predicament_tasks::{Asked, Case, Outcome};

predicament_records::table! {
    /// `mesh_intersect.csv`: the result of an operation on two meshes, after the limit of the perturbation and after
    /// rounding to doubles. All columns are counts.
    pub struct MeshIntersectRow [Clone, PartialEq, Eq, Debug, Default] in "mesh_intersect.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The operation: `union`, `intersection`, …
        pub operation: String,
        /// Triangles of both meshes.
        pub given: u64,
        /// Points where an edge of one mesh passes through a triangle of the other.
        pub points: u64,
        /// Triangles of the perturbed result.
        pub perturbed: u64,
        /// Triangles of the result in the limit of a perturbation that goes to zero.
        pub limit: u64,
        /// Vertices of the limit that were merged with another vertex at the same place.
        pub merged: u64,
        /// Triangles that were dropped because they have no area in the limit.
        pub flat: u64,
        /// Triangles that were cancelled by an opposite triangle.
        pub cancelled: u64,
        /// Triangles that were replaced by the part that facing triangles do not cover.
        pub covered: u64,
        /// Triangles of the limit after rounding to doubles.
        pub rounded: u64,
        /// Vertices of the limit that are not doubles.
        pub moved: u64,
        /// Triangles that collapsed by rounding.
        pub collapsed: u64,
        /// Triangles that turn over when all vertices are rounded to the nearest doubles.
        pub turned: u64,
        /// Pairs of triangles that then fold onto each other.
        pub folded: u64,
        /// Pairs of triangles that then pass through each other.
        pub crossing: u64,
        /// Vertices that were rounded to other doubles than the nearest, to reduce these flaws.
        pub mended: u64,
        /// The remaining flaws.
        pub left: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        let flaws = self.turned.saturating_add(self.folded).saturating_add(self.crossing);
        if self.left > flaws {
            return Err(RowError::Contradiction("`left` exceeds the number of flaws"));
        }
        if self.flat.saturating_add(self.cancelled) > self.perturbed {
            return Err(RowError::Contradiction("`flat` and `cancelled` exceed `perturbed`"));
        }
        Ok(())
    }
}

impl MeshIntersectRow {
    /// A row for each operation; empty if there is no limit.
    pub(super) fn all(case: &Case<'_, MeshIntersect>, asked: &Asked<'_>, answer: &Overlaid) -> Vec<MeshIntersectRow> {
        let Some(Ok(settled)) = &answer.settled else { return Vec::new() };
        let row = |at: usize| {
            let (result, rounding) = (&settled.results[at], settled.results[at].rounded.counts);
            let count = |n: usize| n as u64;
            MeshIntersectRow {
                suite: case.loaded.suite.clone(),
                scene: case.loaded.name.clone(),
                scene_id: case.loaded.id.clone(),
                backend: asked.backend.name(),
                operation: Operation::ALL[at].name().to_owned(),
                given: count(case.content.triangles()),
                points: count(answer.constructions.len()),
                perturbed: count(answer.solids[at].len()),
                limit: count(result.solid.triangles.len()),
                merged: count(result.counts.merged),
                flat: count(result.counts.flat),
                cancelled: count(result.counts.cancelled),
                covered: count(result.counts.covered),
                rounded: count(result.rounded.closed.triangles.len()),
                moved: count(rounding.moved),
                collapsed: count(rounding.collapsed),
                turned: count(rounding.turned),
                folded: count(rounding.folded),
                crossing: count(rounding.crossing),
                mended: count(rounding.mended),
                left: count(rounding.left),
            }
        };
        (0..Operation::ALL.len()).map(row).collect()
    }
}

/// Adds the rows of an answer.
pub(super) fn rows(case: &Case<'_, MeshIntersect>, asked: &Asked<'_>, answer: &Overlaid, outcome: &mut Outcome) {
    MeshIntersectRow::all(case, asked, answer).iter().for_each(|row| outcome.row(row));
}

/// The section of a report; `None` if no mesh was cut.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("Results of operations on meshes")
        .words(run_head(runs))
        .words(["scene", "operation", "backend"])
        .of(Origin::of(MeshIntersectRow::FILE).keys(["scene", "operation", "backend"]).under("scene", "suite"))
        .numbers(["triangles", "points", "perturbed", "limit", "in doubles", "moved", "flaws", "left"]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows = run.rows::<MeshIntersectRow>()?;
        rows.sort_by_cached_key(|r| {
            ([&r.suite, &r.scene, &r.scene_id, &r.operation].map(String::clone), rank(&order, &r.backend))
        });
        for row in &rows {
            let left = if row.left == 0 { Tone::Muted } else { Tone::Bad };
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.operation.as_str().into(),
                row.backend.as_str().into(),
                Cell::count(row.given),
                Cell::count(row.points),
                Cell::count(row.perturbed),
                Cell::count(row.limit),
                Cell::count(row.rounded),
                Cell::count(row.moved),
                Cell::count(row.turned + row.folded + row.crossing),
                Cell::count(row.left).tone(left),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok((!table.is_empty()).then(|| Section {
        id: "mesh-intersect",
        title: "Operations on meshes",
        lead: "The number of triangles of each result, while perturbed, in the limit, and in the limit in doubles. A \
               flaw is a triangle that turns over, folds or crosses another if all vertices are rounded to the nearest \
               doubles. `left` counts the flaws that other doubles do not mend."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}
