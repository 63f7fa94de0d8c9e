//! The result of one backend on one scene.

use predicament_predicates::{Query, Sign, Vertex};
use predicament_records::{Record, Row};
use sha2::{Digest, Sha256};

use crate::{Class, ClassCounts};

/// One disagreement, with all that is needed to ask again.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding {
    /// Its class; never a legal one.
    pub class: Class,
    /// The check that found it.
    pub check: String,
    /// The queries that it is about; none where it is about the whole scene.
    pub queries: Vec<Query>,
    /// What the backend answered.
    pub got: String,
    /// What would have been right.
    pub truth: String,
    /// log2(|det| / permanent); none for exact zeros and for checks without a determinant.
    pub log2_relative_det: Option<f64>,
    /// The distance of the last vertex to the feature of the others, in units
    /// of the scene's largest bounding-box edge.
    pub distance_over_l: Option<f64>,
    /// The stage that settled the query.
    pub stage: Option<&'static str>,
}

impl Finding {
    /// One without a determinant.
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

/// One answer, whatever its class.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AnswerLine {
    /// The number of the query in its scene, from 0.
    pub query: usize,
    /// The vertices that it is about.
    pub args: Vec<Vertex>,
    /// What the backend answered.
    pub answer: String,
    /// What is true without a perturbation or a band.
    pub exact: String,
    /// The class of the answer by itself: what contradicts another answer is a finding.
    pub class: Class,
    /// The stage that settled it, where it was asked alone; empty where there is none.
    pub stage: &'static str,
}

/// The result of one backend on one scene.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Outcome {
    /// How many queries or points were asked.
    pub queries: u64,
    /// Queries by class; `inconsistent` also counts violated relations between
    /// answers, and the last four classes count the scene.
    pub counts: ClassCounts,
    /// The first few findings of each class, in query order.
    pub findings: Vec<Finding>,
    /// Queries by the stage that settled them.
    pub stages: Vec<(&'static str, u64)>,
    /// A digest of the answers as users get them (for [`Purpose::Use`](crate::Purpose)); none where there are none.
    pub digest: Option<u64>,
    /// What the truth is about, where that is not the whole scene.
    pub sampled: Option<String>,
    /// Rows of the task's own tables.
    pub rows: Vec<Record>,
    /// Every answer, in query order, where the [`Budget`](crate::Budget) asks for them and the task has an answer to each
    /// query; empty for tasks whose answer is a whole.
    pub answers: Vec<AnswerLine>,
}

impl Outcome {
    /// A scene-level class and nothing else.
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
    /// If the row fails its own check: a judge wrote nonsense.
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
