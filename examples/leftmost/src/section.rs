//! The table `leftmost.csv`, with a row for each scene and backend, and the section of a report that shows it.

use predicament::predicates::Vertex;
use predicament::records::{Error, RowError, RunDir, serde};
use predicament::report::layout::{backends, rank, run_head, run_label};
use predicament::report::{Block, Cell, Section, Table, Tone};
use predicament::tasks::{Asked, Case, ids};

use crate::Leftmost;

predicament::records::table! {
    /// `leftmost.csv`: the vertices that one backend found in one scene.
    pub struct LeftmostRow [Clone, PartialEq, Eq, Debug] in "leftmost.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name.
        pub backend: String,
        /// The vertices that the backend found, separated by spaces.
        pub found: String,
        /// The vertices with the smallest x.
        pub truth: String,
    }

    fn check(&self) -> Result<(), RowError> {
        if self.truth.is_empty() { Err(RowError::Contradiction("no vertex is leftmost")) } else { Ok(()) }
    }
}

impl LeftmostRow {
    /// The row of an answer.
    pub(crate) fn of(case: &Case<'_, Leftmost>, asked: &Asked<'_>, found: &[Vertex]) -> LeftmostRow {
        LeftmostRow {
            suite: case.loaded.suite.clone(),
            scene: case.loaded.name.clone(),
            scene_id: case.loaded.id.clone(),
            backend: asked.backend.name(),
            found: ids(found),
            truth: ids(&case.truth),
        }
    }
}

/// The section of a report; `None` if the runs have no scene of the task.
pub(crate) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("").words(run_head(runs)).words(["scene", "backend", "leftmost"]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows = run.rows::<LeftmostRow>()?;
        rows.sort_by_cached_key(|row| (row.suite.clone(), row.scene.clone(), rank(&order, &row.backend)));
        for row in rows {
            let found = Cell::from(some(&row.found));
            let found = if row.found == row.truth {
                found
            } else {
                found.detail(format!("without perturbation: {}", some(&row.truth))).tone(Tone::Notable)
            };
            let cells = [Cell::from(row.scene).detail(row.suite), Cell::from(row.backend), found];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    if table.is_empty() {
        return Ok(None);
    }
    Ok(Some(Section {
        id: "leftmost",
        title: "Leftmost vertices",
        lead: "The vertices with the smallest x, as each backend finds them.".to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}

/// The first few vertices of a list.
fn some(vertices: &str) -> String {
    let mut words = vertices.split(' ');
    let first: Vec<&str> = words.by_ref().take(6).collect();
    let more = words.count();
    first.join(" ") + &if more == 0 { String::new() } else { format!(" and {more} more") }
}
