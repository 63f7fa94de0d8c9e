//! `contacts.csv`, and its section of a report: the numbers of registered and of ended pairs on each level of the
//! hierarchy.

use std::collections::BTreeMap;

use predicament_records::format::percent;
use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{backends, rank, run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table};

predicament_records::table! {
    /// `contacts.csv`: the pairs of simplices of two complexes, by rank.
    pub struct ContactRow [Clone, PartialEq, Eq, Debug] in "contacts.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// `contacts2d` or `contacts3d`.
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The rank of the first complex's simplices: 0 for vertices, 3 for tetrahedra.
        pub rank_a: u8 ["dimension"],
        /// The rank of the second complex's simplices.
        pub rank_b: u8 ["dimension"],
        /// Pairs whose boxes are closer than the backend's reach.
        pub candidates: u64,
        /// Candidate pairs that were skipped, because a pair of their faces was already registered.
        pub ended: u64,
        /// Candidate pairs on which the backend was queried.
        pub asked: u64,
        /// Pairs that the backend registered.
        pub registered: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        if self.registered > self.asked {
            return Err(RowError::Contradiction("more pairs are registered than queried"));
        }
        if self.ended.checked_add(self.asked) != Some(self.candidates) {
            return Err(RowError::Contradiction("`candidates` is not the sum of `ended` and `asked`"));
        }
        Ok(())
    }
}

/// The number of levels; a level is the sum of two ranks: 0 for two vertices, the dimension for pairs in general
/// position.
const LEVELS: usize = 4;

/// The sums over all kinds of pairs of one level.
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

/// The section of a report about contacts.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("Registered pairs, and the share of the candidates that had already ended")
        .words(run_head(runs))
        .words(["scene", "task", "backend"])
        .of(Origin::of(ContactRow::FILE).keys(["scene", "task", "backend"]).under("scene", "suite"))
        .numbers((0..LEVELS).map(|level| format!("level {level}")));
    for (index, run) in runs.iter().enumerate() {
        let mut rows: BTreeMap<_, [Option<Level>; LEVELS]> = BTreeMap::new();
        let rows_of_run = run.rows::<ContactRow>()?;
        for row in &rows_of_run {
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
    let block = Block::table_or(table, "The runs have no contacts between complexes.");
    Ok(Some(Section {
        id: "contacts",
        title: "Contacts",
        lead: "Pairs of simplices of two complexes, by level. The level is the sum of the two ranks: two vertices are \
               level 0; the last level holds the pairs that meet in general position. Candidates are pairs whose boxes \
               are near each other. A candidate has ended if a pair of its faces is already registered; the backend is \
               then not queried about it."
            .to_owned(),
        blocks: vec![block],
    }))
}
