//! `judged.csv`: the digests of the answers that a run has judged, so that they can be timed later without judging them
//! again.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use predicament_corpus::Level;
use predicament_engines::PREFIX;
use predicament_records::{FindingRow, PlannedScene, RunDir, SummaryRow};
use predicament_tasks::Outcome;

use crate::exit::Failure;
use crate::select::{Planned, Selection, Selector, suites_of};
use crate::tool::Tool;

predicament_records::table! {
    /// `judged.csv`: the digest of the answers of one backend to one scene.
    pub struct JudgedRow [Clone, PartialEq, Eq, Debug] in "judged.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The digest of the answers as users get them, in 16 hex digits.
        pub digest: String,
    }
}

impl JudgedRow {
    /// The row of an outcome, or no row if there were no answers.
    pub fn of(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<JudgedRow> {
        let row = |digest: u64| {
            let [suite, scene, scene_id, task] = scene.labels();
            JudgedRow { suite, scene, scene_id, task, backend: backend.to_owned(), digest: format!("{digest:016x}") }
        };
        outcome.digest.map(row).into_iter().collect()
    }
}

/// The judgements of an earlier run.
pub struct Judged {
    folder: PathBuf,
    run: RunDir,
    digests: BTreeMap<(String, String), u64>,
}

/// The judgement of one scene on one backend.
pub struct Before<'r> {
    /// The row of `summary.csv`.
    pub summary: &'r SummaryRow,
    /// The rows of `findings.csv`.
    pub findings: Vec<FindingRow>,
    /// The digest of the judged answers, or `None` if there were none.
    pub digest: Option<u64>,
}

impl Judged {
    /// Reads the folder of a run.
    pub fn read(folder: &Path) -> Result<Judged, Failure> {
        let run = RunDir::open(folder).map_err(Failure::usage)?;
        let rows = run.rows::<JudgedRow>().map_err(Failure::usage)?;
        let digest = |row: &JudgedRow| {
            let digest = u64::from_str_radix(&row.digest, 16);
            let digest = digest.map_err(|_| Failure::usage(format!("judged.csv: `{}` is not a digest", row.digest)))?;
            Ok(((row.scene_id.clone(), row.backend.clone()), digest))
        };
        let digests = rows.iter().map(digest).collect::<Result<_, Failure>>()?;
        Ok(Judged { folder: folder.to_owned(), run, digests })
    }

    /// The scenes to time; if no suite is named, the scenes of the run. Of the files that the plan names, only suite
    /// files are read.
    ///
    /// # Errors
    /// If a scene of the run is gone or has changed, or the run has no scene of a named suite.
    pub fn select(&self, selector: &Selector, tool: &Tool) -> Result<(Selection, Vec<Planned>), Failure> {
        let plan = &self.run.plan;
        let run = self.folder.display();
        if !selector.suites.is_empty() {
            let selection = selector.select(tool)?;
            let scenes = selection.plan()?;
            let judged: BTreeSet<&str> = plan.scenes.iter().map(|scene| &*scene.scene_id).collect();
            let mut suites: BTreeMap<&str, bool> = BTreeMap::new();
            for Planned { plan: scene, .. } in &scenes {
                *suites.entry(&scene.suite).or_default() |= judged.contains(&*scene.scene_id);
            }
            if let Some((suite, _)) = suites.iter().find(|(_, is_judged)| !**is_judged) {
                return Err(Failure::usage(format!(
                    "{run}: no scene of `{suite}` that is selected was judged in this run; leave the suite out, \
                     name a run of it at the same level, or leave out --judged"
                )));
            }
            return Ok((selection, scenes));
        }
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        if selector.level == Level::Full && level == Level::Quick {
            return Err(Failure::usage(format!(
                "{run}: the run is of level quick, and --level asks for full; leave out --level, or name a run of level full"
            )));
        }
        let selection = Selector { suites: suites_of(&self.folder, plan), level, ..selector.clone() }.select(tool)?;
        let passes = |scene: &&PlannedScene| selection.passes(&scene.suite, &scene.scene);
        let planned: Vec<PlannedScene> = plan.scenes.iter().filter(passes).cloned().collect();
        if planned.is_empty() {
            return Err(Failure::nothing(format!("{run}: no scene of the run is selected; leave out -f")));
        }
        let scenes = selection.of_plan(&planned, |scene, of| {
            Failure::usage(format!(
                "{run}: scene {}/{}{of} has changed since it was judged, or is gone; start a new run, or name suites",
                scene.suite, scene.scene
            ))
        })?;
        Ok((selection, scenes))
    }

    /// The backends of the run, without engines, each of which gets a remark. A program is started only if the user
    /// names it.
    pub fn backends(&self, remarks: &mut Vec<String>) -> Vec<String> {
        let (engines, backends): (Vec<_>, Vec<_>) =
            self.run.plan.backends.iter().cloned().partition(|name| name.starts_with(PREFIX));
        remarks.extend(engines.iter().map(|name| format!("not timed: {name}; name it with -b to start it")));
        backends
    }

    /// The judgement of a scene on a backend, or `None` if the run has none.
    pub fn of(&self, scene: &PlannedScene, backend: &str) -> Option<Before<'_>> {
        let run = &self.run;
        let summary = run.summary.iter().find(|row| row.scene_id == scene.scene_id && row.backend == backend)?;
        let of_this = |row: &&FindingRow| row.scene_id == scene.scene_id && row.backend == backend;
        let findings = run.findings.iter().filter(of_this).cloned().collect();
        let digest = self.digests.get(&(scene.scene_id.clone(), backend.to_owned())).copied();
        Some(Before { summary, findings, digest })
    }

    /// A line that says how many judgements were taken from the run.
    pub fn told(&self, taken_over: usize) -> String {
        let run = self.folder.display();
        match taken_over {
            0 => format!("no judgement was taken over from {run}: it does not have these scenes on these backends"),
            1 => format!("1 judgement was taken over from {run}"),
            more => format!("{more} judgements were taken over from {run}"),
        }
    }
}
