//! The counts of one law.

use predicament_laws::axioms::{Law, Violation};
use predicament_predicates::{Scene, Vertex};

use super::Family;

/// Counts of one law about one predicate, or several tied to each other. Those of parts add up.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// The law.
    pub law: Law,
    /// The names of the predicates, as in `compare+orient2d`.
    pub subject: String,
    /// Tuples tried.
    pub tuples: u64,
    /// Tuples whose answers break the law.
    pub violations: u64,
    /// Tuples on which the backend panicked.
    pub panics: u64,
    /// The first violation, or panic if there is none.
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

/// Each vertex once, ascending.
fn points(scene: &Scene, vertices: impl Iterator<Item = Vertex>) -> Vec<(Vertex, Vec<f64>)> {
    let vertices: std::collections::BTreeSet<Vertex> = vertices.collect();
    vertices.into_iter().map(|v| (v, scene.point(v).to_vec())).collect()
}

impl std::fmt::Display for Example {
    /// One line: what was answered, and where the vertices are.
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

    /// Whether the backend answered about anything at all.
    #[must_use]
    pub fn is_declined(&self) -> bool {
        self.tuples == 0
    }

    /// Whether the law holds as far as it was tried.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.violations + self.panics == 0
    }

    /// Adds the counts of a later part.
    pub(super) fn add(&mut self, later: Row) {
        self.tuples += later.tuples;
        // A violation says more than a panic does.
        if self.violations == 0 && later.violations > 0 {
            self.first = later.first;
        } else {
            self.first = self.first.take().or(later.first);
        }
        self.violations += later.violations;
        self.panics += later.panics;
    }
}
