//! Loads expectations: those that ship with the corpora, or those of a file.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use predicament_corpus::Suite;
use predicament_engines::PREFIX;
use predicament_formats::{hex, read_suite};
use predicament_oracle::expect::{Expectations, Known, Unused};
use predicament_oracle::known::Scenes;
use predicament_predicates::Severity;
use predicament_records::{Error, ExpectedFile, Plan, RunDir, Status, SummaryRow};
use predicament_tasks::{Class, ClassCounts};
use sha2::{Digest, Sha256};

use crate::exit::{CORPUS, Failure};
use crate::ledger::describe;
use crate::tool::Tool;

/// The name of the expectations file in the corpora.
const SHIPPED: &str = "expected.toml";

/// The expectations of a run, and the SHA-256 of their text.
pub struct Held {
    pub expected: Expectations,
    pub digest: String,
}

/// Loads expectations like [`load`], with a hash that shows whether two runs used the same ones.
pub fn held(tool: &Tool, file: Option<&PathBuf>) -> Result<Held, Failure> {
    let expected = load(tool, file)?;
    let mut digest = Sha256::new();
    let shipped = if file.is_none() { tool.library()?.companion(SHIPPED)? } else { None };
    if let Some((_, text)) = shipped {
        digest.update(text.as_bytes());
    }
    let own = if file.is_none() { tool.expected() } else { file };
    if let Some(own) = own {
        digest.update(text(own)?.as_bytes());
    }
    Ok(Held { expected, digest: hex(&digest.finalize()) })
}

/// Loads the expectations of `file`; without a file, the shipped expectations and those of the crate that built the
/// tool.
pub fn load(tool: &Tool, file: Option<&PathBuf>) -> Result<Expectations, Failure> {
    if let Some(file) = file {
        return read(file);
    }
    let shipped = shipped(tool)?;
    match tool.expected() {
        None => Ok(shipped),
        Some(own) => Ok(shipped.and(read(own)?)),
    }
}

/// The expectations that ship with the corpora.
pub fn shipped(tool: &Tool) -> Result<Expectations, Failure> {
    let (name, text) = tool.library()?.companion(SHIPPED)?.unwrap_or_default();
    Expectations::parse(Path::new(&name), &text).map_err(|error| Failure { message: error.to_string(), code: CORPUS })
}

/// The entry of a plan for a file of expectations.
pub fn file(file: &Path) -> Result<ExpectedFile, Failure> {
    let cannot = |error: std::io::Error| Failure::usage(Error::io(file)(error));
    let text = std::fs::read(file).map_err(cannot)?;
    let place = std::path::absolute(file).map_err(cannot)?;
    Ok(ExpectedFile { file: place.display().to_string(), sha256: hex(&Sha256::digest(text)) })
}

/// The text of a file of expectations.
pub fn text(file: &Path) -> Result<String, Failure> {
    read_suite(file).map_err(|error| {
        let message = error.message.replace("the suite", "the file");
        Failure::usage(format!("{}: {message}; give a readable TOML file with --expected", file.display()))
    })
}

fn read(file: &Path) -> Result<Expectations, Failure> {
    Expectations::parse(file, &text(file)?).map_err(|error| Failure { message: error.to_string(), code: CORPUS })
}

/// Recomputes the status of each row of a run from these expectations, because the file may have changed since the run.
pub fn hold(expected: &Expectations, run: &mut RunDir) {
    let level = run.plan.level.to_string();
    for row in &mut run.summary {
        row.status = expected.status(&row.suite, &row.scene, &row.backend, &level, &counts(row));
    }
}

/// Marks rows as passed that fail only because of classes with severities outside `fail_on`. Returns a description of
/// each row, with its old status.
pub fn let_pass(expected: &Expectations, run: &mut RunDir, fail_on: &[Severity]) -> Vec<String> {
    let level = run.plan.level.to_string();
    let mut passed = Vec::new();
    for row in run.summary.iter_mut().filter(|row| !row.status.passes()) {
        let known: Vec<Class> =
            expected.matching(&row.suite, &row.scene, &row.backend, &level).map(|entry| entry.class).collect();
        let mut counted = ClassCounts::default();
        for class in Class::ALL {
            // A class that does not count is treated as found exactly where it is expected.
            let is_asked = class.is_legal() || fail_on.contains(&class.severity());
            counted.add(class, if is_asked { row.count(class) } else { u64::from(known.contains(&class)) });
        }
        let status = expected.status(&row.suite, &row.scene, &row.backend, &level, &counted);
        if status.passes() {
            passed.push(describe(row));
            row.status = Status::Expected;
        } else {
            row.status = status;
        }
    }
    passed
}

/// The expectations that a run does not meet, each with its place in the file.
pub fn unmet(expected: &Expectations, run: &RunDir) -> Vec<String> {
    let level = run.plan.level.to_string();
    let mut unmet = Vec::new();
    for row in run.summary.iter().filter(|row| row.status == Status::UnexpectedPass) {
        let SummaryRow { suite, scene, backend, .. } = row;
        for entry in expected.matching(suite, scene, backend, &level).filter(|entry| row.count(entry.class) == 0) {
            let (place, class) = (&entry.place, entry.class);
            let pattern = entry.pattern(suite, scene).unwrap_or_default();
            unmet.push(format!("{place}: `{pattern}` on {backend}: no {class} of {suite}/{scene} any more"));
        }
    }
    unmet
}

/// The number of findings of each class.
pub fn counts(row: &SummaryRow) -> ClassCounts {
    let mut counts = ClassCounts::default();
    for class in Class::ALL {
        counts.add(class, row.count(class));
    }
    counts
}

/// The expectations that the run of this plan has not tested.
pub fn unused(expected: &Expectations, tool: &Tool, plan: &Plan) -> Result<Unused, Failure> {
    let library = tool.library()?;
    let planned = Scenes::new(planned(plan), BTreeSet::new());
    let scenes = scenes(tool, plan)?;
    let known = Known {
        scenes: &scenes,
        planned: &planned,
        backend: &|name| may_be(tool, plan, name),
        backends: &plan.backends,
        level: &plan.level.to_string(),
    };
    let mut unused = expected.unused(&known);
    let is_own = |suite: &String| plan.paths.contains_key(suite) || !library.names().any(|name| name == suite);
    if plan.suites.iter().all(is_own) {
        // Shipped expectations are never about the user's suites.
        unused.here.retain(|place| !place.starts_with(&format!("corpora/{SHIPPED}:")));
    }
    Ok(unused)
}

/// The scenes of a plan, by suite and name.
fn planned(plan: &Plan) -> Vec<(String, String)> {
    plan.scenes.iter().map(|scene| (scene.suite.clone(), scene.scene.clone())).collect()
}

/// True if a run may have a backend with this name. An engine may be in any folder, so the name of an engine is always
/// possible.
pub fn may_be(tool: &Tool, plan: &Plan, name: &str) -> bool {
    plan.backends.iter().any(|planned| planned == name) || name.starts_with(PREFIX) || tool.knows_backend(name)
}

/// All scenes that the tool or a run of this plan knows.
pub fn scenes(tool: &Tool, plan: &Plan) -> Result<Scenes, Failure> {
    let library = tool.library()?;
    let mut suites: Vec<Suite> = library.suites()?.iter().chain(&tool.own_suites()?).cloned().collect();
    // For a suite named by file, include scenes that a filter left out. If the file is gone, some scenes are unknown.
    let (files, gone): (Vec<_>, Vec<_>) = plan.paths.iter().partition(|(_, file)| Path::new(file).exists());
    for (_, file) in files {
        suites.push(library.suite(file)?);
    }
    let is_here = |name: &&String| suites.iter().any(|suite| suite.name == **name);
    let elsewhere = plan.suites.iter().filter(|name| !is_here(name));
    let open = gone.into_iter().map(|(suite, _)| suite).chain(elsewhere).cloned().collect();
    let defs = suites.iter().flat_map(|suite| &suite.scenes);
    let all = defs.map(|def| (def.suite.clone(), def.name.clone())).chain(planned(plan)).collect();
    Ok(Scenes::new(all, open))
}
