//! The rows of a run in progress, in memory and on disk.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use predicament_corpus::{Level, LoadedScene};
use predicament_exact::Precision;
use predicament_oracle::expect::Expectations;
use predicament_records::{
    self as records, AnswerRow, PlannedScene, PrecisionRow, Row, RunDir, RunWriter, Status, SummaryRow,
};
use predicament_tasks::{AnyCase, Class, Contestant, Outcome};

use crate::colour::{Paint, paint};
use crate::exit::{self, Failure};
use crate::pixels::of_square;
use crate::rows;
use crate::stopwatch::Cost;
use crate::tool::Only;

/// The finished work of a run, in memory and on disk.
pub struct Ledger {
    pub level: Level,
    /// True if every answer is written.
    pub answers: bool,
    /// The tasks whose answers are not per query, with their scenes, if `--answers` is given.
    pub wholes: BTreeMap<String, BTreeSet<String>>,
    pub done: Vec<SummaryRow>,
    pub precision: Vec<PrecisionRow>,
    /// The tasks of each backend that runs for some tasks only.
    pub only: Only,
    /// Backends of the tool that run only if named, and were not named.
    pub left_out: Vec<String>,
    /// For a part of a run: the position of each of its scenes in the whole run.
    pub places: BTreeMap<PlannedScene, u64>,
    pub folder: PathBuf,
    pub writer: RunWriter,
}

impl Ledger {
    /// True if the backend runs for scenes of this task.
    pub fn takes(&self, backend: &str, task: &str) -> bool {
        self.only.get(backend).is_none_or(|tasks| tasks.contains(task))
    }

    pub fn is_done(&self, scene: &PlannedScene, backend: &str) -> bool {
        self.done.iter().any(|row| row.suite == scene.suite && row.scene == scene.scene && row.backend == backend)
    }

    /// True if the scene's precision plan is written. A run folder may be older than that table.
    pub fn is_planned(&self, scene: &PlannedScene) -> bool {
        self.precision.iter().any(|row| row.suite == scene.suite && row.scene == scene.scene)
    }

    /// Writes the scene's precision plan and the changes made while reading it, once; the next commit makes them
    /// permanent.
    pub fn plan(&mut self, scene: &PlannedScene, loaded: &LoadedScene) -> Result<(), Failure> {
        if !self.is_planned(scene) {
            let row = rows::precision(scene, &Precision::of(&loaded.scene));
            self.writer.write(std::slice::from_ref(&row)).map_err(Failure::usage)?;
            self.writer.write(rows::imported(scene, &loaded.notes).as_slice()).map_err(Failure::usage)?;
            self.precision.push(row);
        }
        Ok(())
    }

    pub fn record(
        &mut self,
        scene: &PlannedScene,
        backend: &str,
        outcome: &Outcome,
        expected: &Expectations,
    ) -> Result<SummaryRow, Failure> {
        let level = self.level.name();
        let summary =
            rows::record(&mut self.writer, scene, backend, outcome, expected, level).map_err(Failure::usage)?;
        self.commit(scene, backend)?;
        self.note_whole(scene, summary.has_answers() && outcome.answers.is_empty());
        self.done.push(summary.clone());
        Ok(summary)
    }

    /// Writes the cost of a scene; it does not have to be part of the commit that follows.
    pub fn cost(&mut self, scene: &PlannedScene, backend: &str, cost: Cost) -> Result<(), Failure> {
        self.writer.cost(&[cost.row(scene, backend)]).map_err(Failure::usage)
    }

    /// Takes over the rows of a worker.
    pub fn adopt(
        &mut self,
        found: crate::worker::Found,
        scene: &PlannedScene,
        backend: &str,
        expected: &Expectations,
    ) -> Result<(), Failure> {
        let mut summary = found.summary;
        for row in &mut summary {
            row.status = rows::status(scene, backend, row, expected, self.level.name());
        }
        let writer = &mut self.writer;
        writer.write(&summary).map_err(Failure::usage)?;
        writer.write(&found.findings).map_err(Failure::usage)?;
        writer.write(&found.stages).map_err(Failure::usage)?;
        writer.append(&found.more).map_err(Failure::usage)?;
        for (name, png) in &found.maps {
            writer.add_map(name, png).map_err(Failure::usage)?;
        }
        self.commit(scene, backend)?;
        let written = found.more.iter().any(|record| record.file == AnswerRow::FILE);
        self.note_whole(scene, summary.iter().any(SummaryRow::has_answers) && !written);
        self.done.extend(summary);
        Ok(())
    }

    /// Makes the rows of a backend on a scene permanent.
    fn commit(&mut self, scene: &PlannedScene, backend: &str) -> Result<(), Failure> {
        let committed = match self.places.get(scene) {
            Some(&place) => self.writer.commit_of(place, backend),
            None => self.writer.commit_if_due(),
        };
        committed.map_err(Failure::usage)
    }

    /// Records a scene whose answer is not per query, which has no lines among the answers.
    fn note_whole(&mut self, scene: &PlannedScene, is_whole: bool) {
        if self.answers && is_whole {
            self.wholes.entry(scene.task.clone()).or_default().insert(format!("{}/{}", scene.suite, scene.scene));
        }
    }

    pub fn draw(&mut self, case: &dyn AnyCase, backend: &dyn Contestant) -> Result<(), Failure> {
        // A backend that declines or panics has a row and no picture.
        let tile = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| of_square(case, backend)));
        let Ok(Ok(tile)) = tile else { return Ok(()) };
        let png = tile.map.to_png(1).map_err(Failure::usage)?;
        let name = RunDir::map_name(&case.loaded().id, &backend.name());
        self.writer.add_map(&name, &png).map_err(Failure::usage)
    }

    pub fn finish(self, ended: records::Outcome) -> exit::Outcome {
        self.writer.finish(ended).map_err(Failure::usage)?;
        let count = |status: Status| self.done.iter().filter(|row| row.status == status).count();
        let (unexpected, passes) = (count(Status::Unexpected), count(Status::UnexpectedPass));
        // Queries that were declined or ran out of time were not answered.
        let queries: u64 = self.done.iter().filter(|row| row.has_answers()).map(|row| row.queries).sum();
        let code = exit::of_rows(ended, &self.done);
        let told = format!(
            "{queries} answers judged; rows: {} ok, {} expected, {unexpected} unexpected, {passes} unexpected pass; {}",
            count(Status::Ok),
            count(Status::Expected),
            ended.describe(),
        );
        say!("{}: {}", self.folder.display(), paint(Paint::of(code), &told));
        for row in self.done.iter().filter(|row| !row.status.passes()) {
            say!("  {}", paint(Paint::Bad, &describe(row)));
        }
        for (task, scenes) in &self.wholes {
            let (file, count) = (AnswerRow::FILE, scenes.len());
            note!(
                "{file} has no lines for {count} scenes of {task}: their answers are not per query; `solve` writes them"
            );
        }
        if !self.left_out.is_empty() {
            let names = self.left_out.join(", ");
            say!("{}", paint(Paint::Faint, &format!("not run: {names}; `-b {}` runs them", self.left_out.join(","))));
        }
        Ok(code)
    }
}

/// Describes a summary row in words.
pub fn describe(row: &SummaryRow) -> String {
    let classes: Vec<String> = Class::ALL
        .into_iter()
        .filter(|&class| row.count(class) > 0)
        .map(|class| format!("{} {}", row.count(class), class.name()))
        .collect();
    format!("{}: {}/{} on {}: {}", row.status.name(), row.suite, row.scene, row.backend, classes.join(", "))
}
