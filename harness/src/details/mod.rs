//! Details of single findings for a report: their points, the truth, the answer of each backend, and a picture.
//!
//! A few findings of each class and backend are asked again, alone, as `replay` does. A finding is left out and counted
//! if its scene has changed, needs data that are not there, or is too large to load for a page.

mod apart;
mod around;
mod bodies;
mod result;
mod shape;

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Level, LoadedScene};
use predicament_engines::PREFIX;
use predicament_predicates::Query;
use predicament_records::{FindingRow, RunDir};
use predicament_report::{Detail, Strip};
use predicament_tasks::{Class, Contestant, Explanation};

use crate::exit::Failure;
use crate::out::{program, word};
use crate::select::{Selector, suite_of};
use crate::told::{lines, point_lines, signs};
use crate::tool::Tool;

pub use bodies::Bodies;

/// The maximum number of findings of each class, backend and task, each from another suite.
const FEW: usize = 3;
/// Answers to scenes with more queries, triangles or points are not drawn.
const MOST_DRAWN: u64 = 500;
/// Scenes with more queries are not loaded again.
const MOST_QUERIES: u64 = 100_000;

/// Details of a few findings of each class, backend and task, and the number of chosen findings without details.
pub fn details(runs: &[RunDir], tool: &Tool) -> Result<(Vec<Detail>, usize), Failure> {
    let (mut told, mut missing) = (Vec::new(), 0);
    // At most one raster per class and task.
    let mut drawn = BTreeSet::new();
    for run in runs {
        let (engines, names): (Vec<&String>, Vec<_>) =
            run.plan.backends.iter().partition(|name| name.starts_with(PREFIX));
        let names: Vec<String> = names.into_iter().cloned().collect();
        let backends = if names.is_empty() { Vec::new() } else { tool.pick(&names)? };
        let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
        for ((suite, scene), findings) in chosen(run) {
            match load(run, suite, scene, &findings, tool) {
                Some(loaded) => {
                    for finding in findings {
                        let detail = match finding.query.as_str() {
                            "" => answered(run, &loaded, finding),
                            _ => detail(tool, &loaded, finding, &backends).map(|detail| Detail {
                                lines: recorded(run, finding, &engines, detail.lines),
                                ..detail
                            }),
                        };
                        match detail {
                            Some(mut detail) => {
                                if !finding.query.is_empty() && drawn.insert((finding.class.name(), &finding.task)) {
                                    detail.pictures.extend(around::picture(&loaded, finding, &backends));
                                }
                                told.push(detail);
                            }
                            None => missing += 1,
                        }
                    }
                }
                None => missing += findings.len(),
            }
        }
    }
    Ok((told, missing))
}

/// The lines about a query, with those of engines added. A report starts no program, so an engine's line is its
/// recorded answer or the command that asks it.
fn recorded(run: &RunDir, finding: &FindingRow, engines: &[&String], mut lines: Vec<String>) -> Vec<String> {
    for name in engines {
        lines.push(match finding.backend == **name {
            true => format!("{name:<24} {}  (in the run)", finding.got),
            false => format!("{name:<24} not asked again: {}", asking(run, finding, name)),
        });
    }
    lines
}

/// The command that asks an engine about a finding.
fn asking(run: &RunDir, finding: &FindingRow, name: &str) -> String {
    let file = run.plan.engines.get(name).map_or("FILE", |engine| &engine.file);
    let engine = word(&format!("{}={file}", name.trim_start_matches(PREFIX)));
    let (id, folder) = (&finding.finding_id, word(&run.path.display().to_string()));
    format!("{} replay {id} --run {folder} -b {} --engine {engine}", program(), word(name))
}

/// The backend's answer for a finding about a whole scene.
fn answered(run: &RunDir, loaded: &LoadedScene, finding: &FindingRow) -> Option<Detail> {
    let mut detail = Detail { finding: finding.finding_id.clone(), ..Detail::default() };
    if finding.backend.starts_with(PREFIX) {
        detail.lines.push(format!(
            "{} is not started for a report: {}",
            finding.backend,
            asking(run, finding, &finding.backend)
        ));
        return Some(detail);
    }
    result::draw(run, loaded, finding, &mut detail)?;
    Some(detail)
}

/// The findings to show, by suite and scene. For each class, backend and task these are a few findings about single
/// queries, one from each of the first suites; for each class and task, one finding about a whole scene.
fn chosen(run: &RunDir) -> BTreeMap<(&str, &str), Vec<&FindingRow>> {
    let sizes: BTreeMap<(&str, &str), u64> =
        run.plan.scenes.iter().map(|scene| ((&*scene.suite, &*scene.scene_id), scene.queries)).collect();
    let is_small =
        |row: &&FindingRow, most: u64| sizes.get(&(&*row.suite, &*row.scene_id)).is_some_and(|&size| size <= most);
    let mut findings: Vec<&FindingRow> = run.findings.iter().filter(|row| is_small(row, MOST_QUERIES)).collect();
    findings.sort_by_key(|row| [&row.suite, &row.scene, &row.scene_id, &row.task, &row.finding_id]);
    let mut suites: BTreeMap<(&str, &str, &str), BTreeSet<&str>> = BTreeMap::new();
    let mut whole: BTreeSet<(&str, &str)> = BTreeSet::new();
    let mut chosen: BTreeMap<(&str, &str), Vec<&FindingRow>> = BTreeMap::new();
    for row in findings {
        let is_chosen = if row.query.is_empty() {
            // A scene that timed out, panicked or was refused has no answer to draw.
            let is_answered = !matches!(row.class, Class::Timeout | Class::Panic | Class::Refused);
            is_answered && is_small(&row, MOST_DRAWN) && whole.insert((row.class.name(), &row.task))
        } else {
            let seen = suites.entry((row.class.name(), &row.backend, &row.task)).or_default();
            seen.len() < FEW && seen.insert(&row.suite)
        };
        if is_chosen {
            chosen.entry((&row.suite, &row.scene)).or_default().push(row);
        }
    }
    chosen
}

/// The scene as it was in the run, or `None` if it is gone or has changed.
fn load(run: &RunDir, suite: &str, scene: &str, findings: &[&FindingRow], tool: &Tool) -> Option<LoadedScene> {
    let level: Level = run.plan.level.to_string().parse().ok()?;
    let suite = suite_of(&run.path, &run.plan, suite);
    let selection = Selector { suites: vec![suite], filter: None, level, cache: None }.select(tool).ok()?;
    let def = selection.defs().into_iter().find(|def| def.name == scene)?;
    let loaded = selection.load(def).ok()?;
    findings.iter().all(|finding| finding.scene_id == loaded.id).then_some(loaded)
}

fn detail(tool: &Tool, loaded: &LoadedScene, finding: &FindingRow, backends: &[&dyn Contestant]) -> Option<Detail> {
    let mut detail = Detail { finding: finding.finding_id.clone(), ..Detail::default() };
    for written in finding.query.split(" | ") {
        let query: Query = written.parse().ok()?;
        let told: Explanation = tool.task(loaded.task).explain_query(loaded, &query, backends).ok()?;
        if !detail.lines.is_empty() {
            detail.lines.push(String::new());
        }
        detail.lines.push(written.to_owned());
        detail.lines.extend(point_lines(loaded, &told.vertices));
        detail.lines.extend(lines(&told));
        detail.pictures.extend(apart::drawn(loaded, &query).unwrap_or_default());
        detail.pictures.extend(shape::picture(loaded, &query));
        detail.views.extend(shape::view(loaded, &query));
        detail.strips.extend(strip(&query, &told));
    }
    Some(detail)
}

/// The signs of all permutations, if there are any.
fn strip(query: &Query, told: &Explanation) -> Option<Strip> {
    let vertices = query.vertices().map(|v| v.to_string()).collect();
    let rows: Vec<(String, String)> = told.permutations.iter().map(|(name, of)| (name.clone(), signs(of))).collect();
    (!rows.is_empty()).then_some(Strip { vertices, rows })
}
