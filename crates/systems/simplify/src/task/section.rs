//! The table `simplify.csv` and its section in a report: what simplification did to each mesh, by backend.

use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

predicament_records::table! {
    /// `simplify.csv`: a mesh after simplification.
    pub struct SimplifyRow [Clone, PartialEq, Debug] in "simplify.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The number of triangles before.
        pub triangles: u64,
        /// The requested number of triangles.
        pub target: u64,
        /// The number of triangles after the steps.
        pub left: u64,
        /// The number of collapses.
        pub collapsed: u64,
        /// The number of refusals because of a face.
        pub refused: u64,
        /// The number of faces, in the compared collapses, whose normals before and after make an obtuse angle.
        pub turned: u64,
        /// The number of faces, in the compared collapses, that lose or get an area, or turn by a right angle.
        pub undecided: u64,
        /// The number of compared refusals because of a face that keeps its side; broken ties do not count.
        pub needless: u64,
        /// The bound on the distance by which vertices have moved; empty if it is not finite.
        pub reach: Option<f64>,
    }

    fn check(&self) -> Result<(), RowError> {
        if self.left <= self.triangles && self.needless <= self.refused {
            Ok(())
        } else {
            Err(RowError::Contradiction("more triangles than before, or more needless refusals than refusals"))
        }
    }
}

/// The section of a report; `None` if nothing was simplified.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let mut table = Table::new("Simplified meshes")
        .words(run_head(runs))
        .words(["scene", "backend"])
        .of(Origin::of(SimplifyRow::FILE).keys(["scene", "backend"]).under("scene", "suite"))
        .numbers(["triangles", "target", "left", "collapsed", "refused", "turned", "undecided", "needless refusals"]);
    for (index, run) in runs.iter().enumerate() {
        for row in run.rows::<SimplifyRow>()? {
            let wrong = |count: u64| Cell::count(count).tone(if count > 0 { Tone::Notable } else { Tone::Plain });
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.backend.as_str().into(),
                Cell::count(row.triangles),
                Cell::count(row.target),
                Cell::count(row.left),
                Cell::count(row.collapsed),
                Cell::count(row.refused),
                wrong(row.turned),
                Cell::count(row.undecided),
                wrong(row.needless),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok((!table.is_empty()).then(|| Section {
        id: "simplify",
        title: "Simplified meshes",
        lead: "Edges collapse until a mesh has the target's number of triangles, or no edge can be collapsed. A face has \
               turned over if its normals before and after a collapse make an obtuse angle. It is undecided if it loses \
               or gets an area, or turns by a right angle; where ties are broken, the perturbation decides. A refusal \
               is needless if the face keeps its side."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}
