//! The outcome of one backend on one scene.

use predicament_predicates::{Query, Sign, Vertex};
use predicament_records::{Record, Row};
use sha2::{Digest, Sha256};

use crate::{Agreement, Class, ClassCounts};

/// A disagreement, with all data needed to repeat the query.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding {
    /// Its class; never a legal one.
    pub class: Class,
    /// The check that found it.
    pub check: String,
    /// The queries of the finding; empty if it is about the whole scene.
    pub queries: Vec<Query>,
    /// The backend's answer.
    pub got: String,
    /// The right answer.
    pub truth: String,
    /// The value log2(|det| / permanent); `None` for exact zeros and for checks without a determinant.
    pub log2_relative_det: Option<f64>,
    /// The distance of the last vertex to the feature of the others, in units
    /// of the scene's largest bounding-box edge.
    pub distance_over_l: Option<f64>,
    /// The stage that settled the query.
    pub stage: Option<&'static str>,
}

impl Finding {
    /// A finding without a determinant.
    #[must_use]
    pub fn plain(class: Class, check: impl Into<String>, queries: Vec<Query>, got: String, truth: String) -> Finding {
        Finding {
            class,
            check: check.into(),
            queries,
            got,
            truth,
            log2_relative_det: None,
            distance_over_l: None,
            stage: None,
        }
    }

    /// The queries as text: `orient2d(xy; 0 1 2)`, several with ` | ` between them.
    #[must_use]
    pub fn query_text(&self) -> String {
        self.queries.iter().map(ToString::to_string).collect::<Vec<_>>().join(" | ")
    }
}

/// The record of one answer, of any class.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AnswerLine {
    /// The index of the query in its scene, from 0.
    pub query: usize,
    /// The vertices of the query.
    pub args: Vec<Vertex>,
    /// The backend's answer.
    pub answer: String,
    /// The exact answer, without a perturbation or a band.
    pub exact: String,
    /// The class of the answer alone: a contradiction to another answer is a separate finding.
    pub class: Class,
    /// The stage that settled it when it was asked alone; empty if there is none.
    pub stage: &'static str,
}

/// The result of one backend on one scene.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Outcome {
    /// The number of queries or points asked.
    pub queries: u64,
    /// Queries by class; `inconsistent` also counts violated relations between
    /// answers, and the last four classes count the scene.
    pub counts: ClassCounts,
    /// The first few findings of each class, in query order.
    pub findings: Vec<Finding>,
    /// Queries by the stage that settled them.
    pub stages: Vec<(&'static str, u64)>,
    /// A digest of the answers as users get them (for [`Purpose::Use`](crate::Purpose)); `None` if there are none.
    pub digest: Option<u64>,
    /// The part of the scene that the truth covers, if not all.
    pub sampled: Option<String>,
    /// Rows of the task's own tables.
    pub rows: Vec<Record>,
    /// Every answer, in query order, if the [`Budget`](crate::Budget) asks for them and the task has an answer to each
    /// query; empty for tasks that are judged as a whole.
    pub answers: Vec<AnswerLine>,
    /// The agreement with the decimals that were written, if the scene has a truth of decimals.
    pub agreement: Option<Agreement>,
}

impl Outcome {
    /// The outcome with a single scene-level class.
    #[must_use]
    pub fn of_scene(queries: u64, class: Class, check: &str, reason: String) -> Outcome {
        let mut outcome = Outcome { queries, ..Outcome::default() };
        outcome.counts.add(class, 1);
        outcome.findings.push(Finding::plain(class, check, Vec::new(), reason, String::new()));
        outcome
    }

    /// Counts an answer, and keeps the finding if it is one of the first of its class.
    pub fn note(&mut self, class: Class, findings_per_class: usize, finding: impl FnOnce() -> Finding) {
        self.counts.add(class, 1);
        if !class.is_legal() && self.counts.get(class) <= findings_per_class as u64 {
            self.findings.push(finding());
        }
    }

    /// Adds a row to a table of the task.
    ///
    /// # Panics
    /// If the row fails its own check: then the judge has an error.
    pub fn row<R: Row>(&mut self, row: &R) {
        self.rows.push(Record::of(row).unwrap_or_else(|error| panic!("{error}")));
    }
}

/// Signs as text.
#[must_use]
pub fn symbol(sign: Sign) -> String {
    sign.symbol().to_string()
}

/// Vertices as text, separated by spaces.
#[must_use]
pub fn ids(args: &[Vertex]) -> String {
    args.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// The id of a finding: the same scene, backend, class, check and query give
/// the same id in every run. Twelve hex digits of a SHA-256.
#[must_use]
pub fn finding_id(scene_id: &str, backend: &str, finding: &Finding) -> String {
    let mut hash = Sha256::new();
    for part in [scene_id, backend, finding.class.name(), &finding.check, &finding.query_text()] {
        hash.update(part.as_bytes());
        hash.update([0]);
    }
    hash.finalize().iter().take(6).map(|byte| format!("{byte:02x}")).collect()
}
