//! The work of shrinking a finding, from a run or from the folder of an earlier `shrink`.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use predicament_records::{FindingRow, RunDir};

use super::{Job, Measure, STATE, State, named, open};
use crate::exit::Failure;
use crate::found::load;
use crate::out::program;
use crate::programs::{Programs, Recorded};
use crate::tool::Tool;

/// The default number of evaluations.
pub const EVALUATIONS: u64 = 5_000;

/// The options of shrinking a finding.
pub struct Ask<'a> {
    pub also: Vec<String>,
    pub not_by: Vec<String>,
    pub evaluations: u64,
    pub timeout: Duration,
    pub cache: Option<&'a Path>,
    pub programs: &'a Programs,
}

/// The work on a finding of a run.
pub fn begun<'a>(tool: &'a Tool, dir: &RunDir, finding: &FindingRow, ask: &Ask<'_>) -> Result<Job<'a>, Failure> {
    let loaded = load(dir, finding, ask.cache, tool)?;
    let start = loaded.spelled().ok_or_else(|| {
        Failure::usage(format!("{}: the task {} cannot write its scenes out", finding.finding_id, finding.task))
    })?;
    let mut shown_by = vec![finding.backend.clone()];
    shown_by.extend(ask.also.iter().filter(|name| **name != finding.backend).cloned());
    let measure = Measure::of(&start);
    let state = State {
        finding_id: finding.finding_id.clone(),
        suite: finding.suite.clone(),
        scene: finding.scene.clone(),
        scene_id: finding.scene_id.clone(),
        task: finding.task.clone(),
        class: finding.class.name().to_owned(),
        check: finding.check.clone(),
        shown_by,
        not_by: ask.not_by.clone(),
        engines: BTreeMap::new(),
        level: dir.plan.level.to_string(),
        limit: ask.timeout.as_secs_f64(),
        evaluations: 0,
        most: ask.evaluations,
        end: None,
        before: measure,
        after: measure,
    };
    let file = dir.path.join("plan.json");
    let recorded = Recorded { file: &file, folder: Some(&dir.path), engines: &dir.plan.engines };
    let backends = state.pick(tool, ask.programs, recorded)?;
    Ok(Job { tool, state, start, source: loaded.source, named: named(&finding.query), backends })
}

/// The source of the original scene, from the source of a shrunk scene: the prefix that `shrink` added is removed.
fn source_of(source: &str) -> String {
    source.split_once("); ").map_or_else(String::new, |(_, source)| source.to_owned())
}

/// The work of a folder, to be continued.
pub fn again<'a>(tool: &'a Tool, folder: &Path, programs: &Programs) -> Result<Job<'a>, Failure> {
    let (state, loaded) = open(tool, folder)?;
    let start = loaded.spelled().ok_or_else(|| Failure::usage("the task cannot write its scenes out"))?;
    let source = source_of(&loaded.source);
    let recorded = Recorded { file: &folder.join(STATE), folder: Some(folder), engines: &state.engines };
    let backends = state.pick(tool, programs, recorded)?;
    Ok(Job { tool, state, start, source, named: Vec::new(), backends })
}

/// Describes the result of a shrink in one line.
pub fn told(state: &State) -> String {
    let State { before, after, evaluations, .. } = state;
    let end = match state.end.as_deref() {
        Some("smallest") => "nothing smaller was found".to_owned(),
        Some(end) => format!("the {end} are used up; `{} shrink --resume` continues with --evaluations", program()),
        None => format!("interrupted; `{} shrink --resume` continues", program()),
    };
    let Measure { points, pieces, digits } = after;
    format!(
        "{} points to {points}, {} pieces to {pieces}, {} digits to {digits}, {evaluations} scenes looked at; {end}",
        before.points, before.pieces, before.digits
    )
}
