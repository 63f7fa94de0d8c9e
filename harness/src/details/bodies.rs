//! Texts of failed rows for a CI server: the worst finding, its points, and the command that replays it.

use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::collections::BTreeMap;

use predicament_corpus::LoadedScene;
use predicament_oracle::expect::Expectations;
use predicament_predicates::{Query, Vertex};
use predicament_records::{FindingRow, RunDir, SummaryRow};

use super::{MOST_QUERIES, load};
use crate::out::{program, word};
use crate::told::point_lines;
use crate::tool::Tool;

/// The maximum number of points written out.
const MOST_POINTS: usize = 16;
/// The maximum number of scenes loaded for their points.
const MOST_SCENES: usize = 100;

/// The texts for the failed rows of a run.
pub struct Bodies<'a> {
    run: &'a RunDir,
    tool: &'a Tool,
    /// Findings by suite, scene and backend: unexpected ones first, then by severity.
    findings: BTreeMap<[&'a str; 3], Vec<&'a FindingRow>>,
    scenes: RefCell<BTreeMap<(String, String), Option<LoadedScene>>>,
    loaded: Cell<usize>,
}

impl<'a> Bodies<'a> {
    /// The texts for a run; no scene is loaded yet.
    pub fn new(run: &'a RunDir, expected: &Expectations, tool: &'a Tool) -> Bodies<'a> {
        let mut findings: BTreeMap<[&str; 3], Vec<&FindingRow>> = BTreeMap::new();
        for finding in run.findings.iter() {
            findings.entry([&finding.suite, &finding.scene, &finding.backend]).or_default().push(finding);
        }
        let level = run.plan.level.to_string();
        for ([suite, scene, backend], findings) in &mut findings {
            let known: Vec<_> = expected.matching(suite, scene, backend, &level).map(|entry| entry.class).collect();
            findings.sort_by_key(|of| (known.contains(&of.class), Reverse(of.class.severity())));
        }
        Bodies { run, tool, findings, scenes: RefCell::default(), loaded: Cell::default() }
    }

    /// The text of a row: the expectations in `unmet` about it, and its first finding.
    pub fn of(&self, row: &SummaryRow, unmet: &[String]) -> String {
        let place = format!(" of {}/{} any more", row.suite, row.scene);
        let on = format!(" on {}: ", row.backend);
        let mut lines: Vec<String> =
            unmet.iter().filter(|line| line.ends_with(&place) && line.contains(&on)).cloned().collect();
        let findings = self.findings.get(&[&*row.suite, &*row.scene, &*row.backend]).map_or(&[][..], Vec::as_slice);
        if let Some((first, others)) = findings.split_first() {
            lines.extend(self.lines(first));
            if !others.is_empty() {
                lines.push(format!("and {} more findings in findings.csv", others.len()));
            }
        }
        lines.join("\n")
    }

    fn lines(&self, finding: &FindingRow) -> Vec<String> {
        let FindingRow { class, check, query, got, truth, .. } = finding;
        let mut lines = vec![format!("{class} ({check}), {}", class.severity())];
        if !query.is_empty() {
            lines.push(format!("query   {query}"));
        }
        lines.extend(self.points(finding));
        lines.push(format!("got     {got}"));
        if !truth.is_empty() {
            lines.push(format!("truth   {truth}"));
        }
        let run = word(&self.run.path.display().to_string());
        lines.push(format!("replay  {} replay {} --run {run}", program(), finding.finding_id));
        lines
    }

    /// The points of the query, in decimals and as hex floats; for a whole scene, its first points.
    fn points(&self, finding: &FindingRow) -> Vec<String> {
        let key = (finding.suite.clone(), finding.scene.clone());
        let mut scenes = self.scenes.borrow_mut();
        let scene = scenes.entry(key).or_insert_with(|| {
            let planned = self.run.plan.scenes.iter().find(|scene| scene.scene_id == finding.scene_id);
            if self.loaded.get() == MOST_SCENES || planned.is_none_or(|scene| scene.queries > MOST_QUERIES) {
                return None;
            }
            self.loaded.set(self.loaded.get() + 1);
            load(self.run, &finding.suite, &finding.scene, &[finding], self.tool)
        });
        let Some(loaded) = scene else {
            return vec![
                "points  the scene was not loaded: there are too many, or it is large, has changed or needs data"
                    .to_owned(),
            ];
        };
        let queries = finding.query.split(" | ").filter_map(|query| query.parse::<Query>().ok());
        let mut all: Vec<Vertex> = Vec::new();
        for v in queries.flat_map(|query| query.vertices().collect::<Vec<_>>()) {
            let is_there =
                v.construction().map_or(v.index() < loaded.scene.len(), |at| at < loaded.scene.constructions().len());
            if is_there && !all.contains(&v) {
                all.push(v);
            }
        }
        if finding.query.is_empty() {
            all.extend(loaded.scene.vertices());
        }
        let mut lines = point_lines(loaded, &all[..all.len().min(MOST_POINTS)]);
        if all.len() > MOST_POINTS {
            lines.push(format!("and {} more points", all.len() - MOST_POINTS));
        }
        lines
    }
}
