//! The table `snap.csv` and its section in a report: the effect of rounding on drawings, by method.

use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

predicament_records::table! {
    /// `snap.csv`: a drawing after rounding.
    pub struct SnapRow [Clone, PartialEq, Debug] in "snap.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The rounding method: `naive`, `snap` or `iterated`.
        pub method: String,
        /// The binary logarithm of a pixel's side.
        pub pixel: i32 ["power of two"],
        /// The number of hot pixels.
        pub hot: u64,
        /// Points and crossings in the pixel of an earlier one.
        pub merged: u64,
        /// Edges of chains, each counted once.
        pub edges: u64,
        /// Pairs of these edges that cross, or where one passes over an end of the other.
        pub new_crossings: u64,
        /// The largest distance of a chain's vertex from its segment, in pixel sides.
        pub drift: f64 ["sides of pixels"],
    }

    fn check(&self) -> Result<(), RowError> {
        if self.drift.is_finite() && self.drift >= 0.0 { Ok(()) } else { Err(RowError::Number { column: "drift", value: self.drift, wanted: "a distance" }) }
    }
}

/// The section of a report; `None` if nothing was rounded.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let mut table = Table::new("Drawings after rounding")
        .words(run_head(runs))
        .words(["scene", "method", "backend"])
        .of(Origin::of(SnapRow::FILE).keys(["scene", "method", "backend"]).under("scene", "suite"))
        .numbers(["hot pixels", "merged", "edges", "new crossings", "drift / side"]);
    for (index, run) in runs.iter().enumerate() {
        for row in run.rows::<SnapRow>()? {
            let tone = if row.new_crossings > 0 { Tone::Notable } else { Tone::Plain };
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.method.as_str().into(),
                row.backend.as_str().into(),
                Cell::count(row.hot),
                Cell::count(row.merged),
                Cell::count(row.edges),
                Cell::count(row.new_crossings).tone(tone),
                format!("{:.3}", row.drift).into(),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok((!table.is_empty()).then(|| Section {
        id: "snap",
        title: "Rounded drawings",
        lead: "Segments rounded to pixels. A new crossing is a pair of edges that cross after rounding, or an edge \
               that passes over a vertex of another. Snap rounding makes no new crossings, and its chains stay within \
               0.708 pixel sides of their segments. After iterated snap rounding a chain may be farther away, but no \
               vertex is within half a pixel side of another edge."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}
