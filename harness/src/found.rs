//! Finds a finding of a run by its id, and loads its scene as it was in the run.

use std::path::Path;

use predicament_corpus::{Level, LoadedScene};
use predicament_formats::hex;
use predicament_records::{FindingRow, Plan, RunDir};
use sha2::{Digest, Sha256};

use crate::exit::Failure;
use crate::select::{Selector, suite_of};
use crate::tool::Tool;

/// The finding with this id, or the only finding whose id begins with it.
pub fn find<'a>(run: &'a RunDir, id: &str, folder: &Path) -> Result<&'a FindingRow, Failure> {
    let mut hits = run.findings.iter().filter(|row| row.finding_id.starts_with(id));
    match (hits.next(), hits.find(|row| !row.finding_id.eq(id))) {
        (None, _) => Err(Failure::nothing(format!(
            "{}: no finding is called `{id}`; the first column of findings.csv has the ids",
            folder.display()
        ))),
        (Some(hit), Some(other)) if hit.finding_id != other.finding_id => {
            Err(Failure::usage(format!("`{id}` begins {} and {}; give more digits", hit.finding_id, other.finding_id)))
        }
        (Some(hit), _) => Ok(hit),
    }
}

/// Loads the scene of a finding, as it was in its run.
pub fn load(run: &RunDir, finding: &FindingRow, cache: Option<&Path>, tool: &Tool) -> Result<LoadedScene, Failure> {
    let level: Level = run.plan.level.to_string().parse().map_err(Failure::usage)?;
    let suite = suite_of(&run.path, &run.plan, &finding.suite);
    let selection =
        Selector { suites: vec![suite], filter: None, level, cache: cache.map(Path::to_path_buf) }.select(tool)?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == finding.scene) else {
        let (suite, of) = (&finding.suite, selection.of_file(&finding.suite));
        return Err(Failure::nothing(format!(
            "{}: the suite `{suite}`{of} has no scene `{}` any more; run it again",
            run.path.display(),
            finding.scene
        )));
    };
    let loaded = selection.load(def)?;
    if loaded.id != finding.scene_id {
        let file = run.plan.paths.get(&finding.suite).filter(|_| changed(&run.plan, &finding.suite));
        let file = file.map_or_else(String::new, |file| format!(", as has {file}"));
        return Err(Failure::usage(format!(
            "scene {}/{} has changed since the run ({} then, {} now){file}; run it again",
            finding.suite, finding.scene, finding.scene_id, loaded.id
        )));
    }
    Ok(loaded)
}

/// True if the file of a suite that was named by path has changed since the run.
fn changed(plan: &Plan, suite: &str) -> bool {
    let now = plan.paths.get(suite).and_then(|file| std::fs::read(file).ok());
    now.is_none_or(|bytes| plan.hashes.get(suite).is_some_and(|then| *then != hex(&Sha256::digest(bytes))))
}
