//! A scene that is ready to be asked.

use predicament_mesh::{Complex, PolygonMap};
use predicament_predicates::{Axis, QuerySet, Scene, Sign, Vertex};

use crate::{ImportNotes, Task};

/// A scene with its questions.
#[derive(Clone, PartialEq, Debug)]
pub struct LoadedScene {
    /// The suite it is from.
    pub suite: String,
    /// Its name in the suite.
    pub name: String,
    /// The content id: see [`content_id`](crate::content_id).
    pub id: String,
    /// What is asked.
    pub task: Task,
    /// The family as `throughput.csv` calls it; the scene's name where it has none.
    pub family: String,
    /// Free words to select by.
    pub tags: Vec<String>,
    /// Where the scene is from.
    pub source: String,
    /// One sentence that ends up in the report.
    pub analysis: String,
    /// The points.
    pub scene: Scene,
    /// The questions.
    pub work: Work,
    /// The signs that the data's author expects, query by query.
    pub expected: Option<Vec<Sign>>,
    /// What an importer changed.
    pub notes: ImportNotes,
}

/// The questions of a scene.
#[derive(Clone, PartialEq, Debug)]
pub enum Work {
    /// Signs of a predicate.
    Signs(QuerySet),
    /// The cell of each probe.
    Interval {
        /// The line's direction.
        axis: Axis,
        /// The cells from left to right, each by its left and its right end,
        /// which is the left end of the next. Ends with equal coordinates come
        /// by descending number, as Simulation of Simplicity orders them.
        cells: Vec<[Vertex; 2]>,
        /// What to locate, numbered as the probes of a map.
        probes: Vec<Vertex>,
    },
    /// The region of each probe. Every probe is a vertex of its own, even where
    /// its coordinates are those of a map vertex. The probes are numbered in
    /// turn before and after all of the map's vertices, the first one before:
    /// so Simulation of Simplicity moves half of them further than the map and
    /// half of them less far.
    Locate {
        /// The regions.
        map: PolygonMap,
        /// What to locate.
        probes: Vec<Probe>,
    },
    /// Volume, area and edge length of the union of so many congruent cubes:
    /// vertex 2i of the scene is the lower corner of cube i and vertex 2i + 1
    /// the upper one.
    Cubes {
        /// How many.
        cubes: usize,
    },
    /// The contacts between two complexes, which have no vertex in common.
    Contacts {
        /// The one.
        a: Complex,
        /// The other.
        b: Complex,
    },
}

impl Work {
    /// The number of queries, probes or cubes; for contacts, of simplices in both complexes.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Work::Signs(queries) => queries.len(),
            Work::Interval { probes, .. } => probes.len(),
            Work::Locate { probes, .. } => probes.len(),
            Work::Cubes { cubes } => *cubes,
            Work::Contacts { a, b } => a.len() + b.len(),
        }
    }

    /// Whether nothing is asked.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A point to locate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Probe {
    /// Its vertex in the scene.
    pub vertex: Vertex,
    /// How it was chosen.
    pub kind: ProbeKind,
}

/// How a probe was chosen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ProbeKind {
    /// On a vertex of the map.
    Vertex,
    /// On an edge: its midpoint, where that is a pair of doubles.
    Midpoint,
    /// One double straight below a vertex.
    Below,
    /// One double straight above a vertex.
    Above,
    /// Anywhere in the bounding box.
    Random,
}

impl ProbeKind {
    /// The name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            ProbeKind::Vertex => "vertex",
            ProbeKind::Midpoint => "midpoint",
            ProbeKind::Below => "below",
            ProbeKind::Above => "above",
            ProbeKind::Random => "random",
        }
    }
}

impl std::fmt::Display for ProbeKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
