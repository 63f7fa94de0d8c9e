//! What one backend made of one scene.

use predicament_algorithms::contacts::Level;
use predicament_predicates::{Sign, Vertex};
use sha2::{Digest, Sha256};

use crate::{Class, ClassCounts};

/// One disagreement, with all that is needed to ask again.
#[derive(Clone, PartialEq, Debug)]
pub struct Finding {
    /// Its class; never a legal one.
    pub class: Class,
    /// The check that found it.
    pub check: String,
    /// The question and its vertices, as text: `orient2d(xy; 0 1 2)`.
    pub query: String,
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
    pub(crate) fn plain(class: Class, check: impl Into<String>, query: String, got: String, truth: String) -> Finding {
        Finding {
            class,
            check: check.into(),
            query,
            got,
            truth,
            log2_relative_det: None,
            distance_over_l: None,
            stage: None,
        }
    }
}

/// Points of a map by what surrounds them, for `locate.csv`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LocateCounts {
    /// Land, coast, sea, overlap or defect.
    pub surroundings: String,
    /// How many points.
    pub probes: u64,
    /// Points in no region.
    pub in_none: u64,
    /// Points in exactly one.
    pub in_one: u64,
    /// Points in two or more.
    pub in_many: u64,
    /// Points on some boundary.
    pub on_boundary: u64,
    /// Points whose answer the surroundings rule out.
    pub violations: u64,
}

/// The mass properties of a union of cubes, in the scene's units, for `masses.csv`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MassCounts {
    /// How many cubes.
    pub cubes: u64,
    /// Volume, area and edge length that were found, each rounded once.
    pub found: [f64; 3],
    /// The true ones.
    pub truth: [f64; 3],
    /// Corners, edge-face and three-face vertices that were found.
    pub vertices: [u64; 3],
}

/// What one backend made of one scene.
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
    /// For maps: points by surroundings.
    pub locate: Vec<LocateCounts>,
    /// For contacts: pairs by ranks.
    pub contacts: Vec<Level>,
    /// For cubes: what their union measures.
    pub mass: Option<MassCounts>,
}

impl Outcome {
    /// A scene-level class and nothing else.
    #[must_use]
    pub fn of_scene(queries: u64, class: Class, check: &str, reason: String) -> Outcome {
        let mut outcome = Outcome { queries, ..Outcome::default() };
        outcome.counts.add(class, 1);
        outcome.findings.push(Finding::plain(class, check, String::new(), reason, String::new()));
        outcome
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
    for part in [scene_id, backend, finding.class.name(), &finding.check, &finding.query] {
        hash.update(part.as_bytes());
        hash.update([0]);
    }
    hash.finalize().iter().take(6).map(|byte| format!("{byte:02x}")).collect()
}
