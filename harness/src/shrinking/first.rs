//! Shrinks the first findings of a run.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::Duration;

use predicament_predicates::Class;
use predicament_records::{FindingRow, RunDir, replace};

use super::{Ask, EVALUATIONS, Job, STATE, SUITE, State, again, begun, told};
use crate::exit::{self, Failure};
use crate::programs::Programs;
use crate::tool::Tool;
use crate::{interrupt, progress};

/// The name of the folder inside the run's folder.
const SHRUNK: &str = "shrunk";

/// Shrinks the first findings of each class of a finished run, each in its own folder in `shrunk`, and writes all
/// scenes into one suite there. Finished shrinks stay; unfinished shrinks continue.
pub fn first_of_each_class(
    tool: &Tool,
    run: &Path,
    n: usize,
    cache: Option<&Path>,
    programs: &Programs,
) -> exit::Outcome {
    let dir = RunDir::open(run).map_err(Failure::usage)?;
    let unexpected: BTreeSet<(&str, &str, &str)> = dir
        .summary
        .iter()
        .filter(|row| !row.status.passes())
        .map(|row| (row.suite.as_str(), row.scene.as_str(), row.backend.as_str()))
        .collect();
    let is_unexpected = |row: &FindingRow| unexpected.contains(&(&*row.suite, &*row.scene, &*row.backend));
    let (first, rest): (Vec<&FindingRow>, Vec<_>) = dir.findings.iter().partition(|row| is_unexpected(row));
    let mut chosen: BTreeMap<Class, Vec<&FindingRow>> = BTreeMap::new();
    for row in first.into_iter().chain(rest) {
        let of_class = chosen.entry(row.class).or_default();
        if of_class.len() < n && of_class.iter().all(|other| other.finding_id != row.finding_id) {
            of_class.push(row);
        }
    }
    let all: Vec<&FindingRow> = chosen.into_values().flatten().collect();
    let bar = progress::bar(all.len() as u64, "findings");
    let mut tables: BTreeMap<String, String> = BTreeMap::new();
    let mut complete = true;
    for row in all {
        let folder = run.join(SHRUNK).join(&row.finding_id);
        let ask = Ask {
            also: Vec::new(),
            not_by: Vec::new(),
            evaluations: EVALUATIONS,
            timeout: Duration::from_secs(10),
            cache,
            programs,
        };
        let job =
            if folder.join(STATE).exists() { again(tool, &folder, programs) } else { begun(tool, &dir, row, &ask) };
        bar.inc(1);
        let Ok(job) = job.map_err(|failure| note!("not shrunk: {}", failure.message)) else { continue };
        std::fs::create_dir_all(&folder).map_err(Failure::io(&folder))?;
        // A finding that depends on the whole scene, such as one of a sample, can't be shrunk; a note says so.
        match done(job, &folder) {
            Ok((state, scene, table)) => {
                complete &= state.end.is_some();
                note!("{}: {}", folder.display(), told(&state));
                // Two findings may have the same smallest scene, which a suite holds once.
                tables.entry(scene).or_insert(table);
            }
            Err(failure) => note!("not shrunk: {}", failure.message),
        }
        if interrupt::flag().load(Ordering::Relaxed) {
            complete = false;
            break;
        }
    }
    bar.finish_and_clear();
    if !tables.is_empty() {
        let text: Vec<String> = tables.into_values().collect();
        let text = format!("title = \"Shrunk findings\"\n\n{}", text.join("\n"));
        let file = run.join(SHRUNK).join(SUITE);
        replace(&file, text.as_bytes()).map_err(Failure::usage)?;
        say!("{}: the smallest scenes, as a suite", file.display());
    }
    Ok(if complete { exit::OK } else { exit::INCOMPLETE })
}

/// Shrinks a finding, unless that is done already: the state, the scene's id, and the scene as a table.
fn done(job: Job<'_>, folder: &Path) -> Result<(State, String, String), Failure> {
    let source = job.source.clone();
    let (state, shrunk) = job.run(folder, &mut |_, _| {})?;
    let table = state.table(&source, &shrunk.spelled, &shrunk.finding);
    Ok((state, shrunk.loaded.id, table))
}
