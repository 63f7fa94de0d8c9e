//! The table `mesh_locate.csv` and its section in a report.

use crate::algorithm::Location;
use predicament_records::{Error, Row, RowError, RunDir};
use predicament_report::layout::{backends, rank, run_head, run_label};
use predicament_report::{Block, Cell, Origin, Section, Table, Tone};

use super::MeshLocate;
use super::content::ProbeKind;
use predicament_tasks::{Asked, Case, Class};

predicament_records::table! {
    /// `mesh_locate.csv`: the locations found for the probes of a mesh.
    pub struct MeshLocateRow [Clone, PartialEq, Eq, Debug] in "mesh_locate.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The number of triangles.
        pub triangles: u64,
        /// The kind of probe: `vertex`, `midpoint`, …
        pub kind: String,
        /// The number of probes.
        pub probes: u64,
        /// Probes found in one region.
        pub in_region: u64,
        /// Probes found on the mesh.
        pub on_mesh: u64,
        /// Probes found in no region, or in several.
        pub contradictions: u64,
        /// Probes left undecided because of zeros within a band.
        pub undecided: u64,
        /// Probes whose truth is known from all triangles.
        pub known: u64,
        /// Lost probes: answers that are wrong or contradict others.
        pub lost: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        let answers = [self.in_region, self.on_mesh, self.contradictions, self.undecided];
        if answers.into_iter().try_fold(0_u64, u64::checked_add) != Some(self.probes) {
            return Err(RowError::Contradiction("`probes` is not the sum of `in_region`, `on_mesh`, `contradictions` \
                                                and `undecided`"));
        }
        if self.known > self.probes || self.lost > self.probes {
            return Err(RowError::Contradiction("`known` or `lost` exceeds `probes`"));
        }
        Ok(())
    }
}

impl MeshLocateRow {
    pub(super) fn of(case: &Case<'_, MeshLocate>, asked: &Asked<'_>, kind: ProbeKind) -> MeshLocateRow {
        MeshLocateRow {
            suite: case.loaded.suite.clone(),
            scene: case.loaded.name.clone(),
            scene_id: case.loaded.id.clone(),
            backend: asked.backend.name(),
            triangles: case.content.mesh.triangles().len() as u64,
            kind: kind.name().to_owned(),
            probes: 0,
            in_region: 0,
            on_mesh: 0,
            contradictions: 0,
            undecided: 0,
            known: 0,
            lost: 0,
        }
    }

    pub(super) fn count(&mut self, answer: Location, class: Class, is_known: bool) {
        self.probes += 1;
        match answer {
            Location::In(_) => self.in_region += 1,
            Location::On(_) => self.on_mesh += 1,
            Location::Contradiction => self.contradictions += 1,
            Location::Undecided => self.undecided += 1,
        }
        self.known += u64::from(is_known);
        self.lost += u64::from(!class.is_legal());
    }
}

/// The section of a report; `None` if no point was located.
pub(super) fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("Probes of meshes")
        .words(run_head(runs))
        .words(["scene", "probes at", "backend"])
        .of(Origin::of(MeshLocateRow::FILE).keys(["scene", "backend"]).key("probes at", "kind").under("scene", "suite"))
        .numbers(["probes", "in a region", "on the mesh", "contradictions", "undecided", "known", "lost"]);
    for (index, run) in runs.iter().enumerate() {
        let mut rows = run.rows::<MeshLocateRow>()?;
        rows.sort_by_cached_key(|r| {
            ([&r.suite, &r.scene, &r.scene_id, &r.kind].map(String::clone), rank(&order, &r.backend))
        });
        for row in &rows {
            let lost = if row.lost == 0 { Tone::Muted } else { Tone::Bad };
            let cells = [
                Cell::from(row.scene.as_str()).detail(&*row.suite),
                row.kind.as_str().into(),
                row.backend.as_str().into(),
                Cell::count(row.probes),
                Cell::count(row.in_region),
                Cell::count(row.on_mesh),
                Cell::count(row.contradictions),
                Cell::count(row.undecided),
                Cell::count(row.known),
                Cell::count(row.lost).tone(lost),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok((!table.is_empty()).then(|| Section {
        id: "mesh-locate",
        title: "Points in meshes",
        lead: "Probes of multi-material meshes: how they were chosen, and where each backend located them. A probe is \
               lost if its answer is wrong, is not exactly one region, or differs between axes. A probe is undecided \
               if it is within a tolerance of a border along each axis."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}
