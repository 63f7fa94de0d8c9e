//! The counts of one law.

use predicament_laws::axioms::{Law, Violation};
use predicament_predicates::{Scene, Vertex};

use super::Family;

/// The counts of one law about one predicate, or several related ones; the counts of parts add up.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// The law.
    pub law: Law,
    /// The names of the predicates, as in `compare+orient2d`.
    pub subject: String,
    /// The number of checked tuples.
    pub tuples: u64,
    /// The number of tuples whose answers break the law.
    pub violations: u64,
    /// The number of tuples on which the backend panicked.
    pub panics: u64,
    /// The first violation; the first panic if there is no violation.
    pub first: Option<Example>,
}

/// A violation or panic with all coordinates, so that it can be repeated.
#[derive(Clone, PartialEq, Debug)]
pub struct Example {
    /// The family of the scene.
    pub family: Family,
    /// The answers, or the panic's message, in words.
    pub what: String,
    /// The vertices with their coordinates.
    pub points: Vec<(Vertex, Vec<f64>)>,
}

impl Example {
    pub(super) fn of_violation(family: Family, scene: &Scene, violation: &Violation) -> Example {
        let vertices = violation.answers.iter().flat_map(|answer| &answer.args).copied();
        Example { family, what: violation.to_string(), points: points(scene, vertices) }
    }

    pub(super) fn of_panic(family: Family, scene: &Scene, tuple: &[Vertex], message: &str) -> Example {
        let points = points(scene, tuple.iter().copied());
        Example { family, what: format!("panic: {}", message.replace('\n', " ")), points }
    }
}

/// The vertices, each once and ascending, with their coordinates.
fn points(scene: &Scene, vertices: impl Iterator<Item = Vertex>) -> Vec<(Vertex, Vec<f64>)> {
    let vertices: std::collections::BTreeSet<Vertex> = vertices.collect();
    vertices.into_iter().map(|v| (v, scene.point(v).to_vec())).collect()
}

impl std::fmt::Display for Example {
    /// Writes one line: the answers, and the coordinates of the vertices.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{};", self.what)?;
        for (at, (vertex, point)) in self.points.iter().enumerate() {
            let point: Vec<String> = point.iter().map(|x| format!("{x:?}")).collect();
            write!(f, "{} {vertex} = ({})", if at == 0 { "" } else { "," }, point.join(", "))?;
        }
        write!(f, " [{}]", self.family.name())
    }
}

impl Row {
    pub(super) fn empty(law: Law, subject: String) -> Row {
        Row { law, subject, tuples: 0, violations: 0, panics: 0, first: None }
    }

    /// Returns true if the backend answered nothing at all.
    #[must_use]
    pub fn is_declined(&self) -> bool {
        self.tuples == 0
    }

    /// Returns true if the law holds on all checked tuples.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.violations + self.panics == 0
    }

    /// Adds the counts of a later part.
    pub(super) fn add(&mut self, later: Row) {
        self.tuples += later.tuples;
        // A violation is more informative than a panic.
        if self.violations == 0 && later.violations > 0 {
            self.first = later.first;
        } else {
            self.first = self.first.take().or(later.first);
        }
        self.violations += later.violations;
        self.panics += later.panics;
    }
}
