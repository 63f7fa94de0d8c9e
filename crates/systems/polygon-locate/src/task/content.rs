//! A map with points to locate in it, and how they are chosen.

use std::sync::{Arc, OnceLock};

use crate::algorithm::LocateIndex;
use predicament_corpus::{Canon, Content, Items, Level, List, Spelled, unnumbered};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::map_loops::spelled_loops;

/// A map with points to locate in it.
///
/// Every probe is a vertex of its own, even where its coordinates are those of a
/// map vertex. The probes are numbered in turn before and after all of the map's
/// vertices, the first one before: so Simulation of Simplicity moves half of
/// them further than the map and half of them less far.
#[derive(Debug)]
pub struct MapWithProbes {
    /// The regions.
    pub map: PolygonMap,
    /// What to locate.
    pub probes: Vec<Probe>,
    index: OnceLock<LocateIndex>,
}

impl MapWithProbes {
    /// A map and its probes.
    #[must_use]
    pub fn new(map: PolygonMap, probes: Vec<Probe>) -> MapWithProbes {
        MapWithProbes { map, probes, index: OnceLock::new() }
    }

    /// The map's edges, ready for queries. Built once: it asks no predicate, so all backends share it.
    pub fn locate_index(&self, scene: &Scene) -> &LocateIndex {
        self.index.get_or_init(|| LocateIndex::new(&self.map, scene))
    }

    /// The vertices of the probes.
    #[must_use]
    pub fn vertices(&self) -> Vec<Vertex> {
        self.probes.iter().map(|probe| probe.vertex).collect()
    }
}

impl Content for MapWithProbes {
    fn count(&self) -> usize {
        self.probes.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("polygon-locate");
        canon.count(self.map.regions().len());
        for region in self.map.regions() {
            canon.count(region.rings.len());
            for ring in &region.rings {
                canon.vertices(ring.vertices());
            }
        }
        canon.count(self.probes.len());
        for probe in &self.probes {
            canon.text(probe.kind.name());
            canon.count(probe.vertex.index());
        }
    }

    /// By loops of indices, which keep the numbers of vertices. The id is another one where the kind of a probe, which is
    /// part of it, does not follow from where it is: a double below a vertex may be a vertex as well. None where the map has
    /// no points.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let apart = unnumbered(scene, &self.vertices());
        let own = |ring: &[Vertex]| ring.iter().map(|&v| apart.vertex(v)).collect();
        let rings = |region: &predicament_mesh::Region| region.rings.iter().map(|ring| own(ring.vertices())).collect();
        let regions: Vec<Vec<Vec<Vertex>>> = self.map.regions().iter().map(rings).collect();
        let lists = vec![spelled_loops(&regions)?, List::new("probes", Items::Rows(apart.places))];
        let words = vec![("quick_stride", "0".to_owned())];
        (!apart.points.is_empty()).then(|| Spelled { points: apart.points, words, lists, ..Spelled::default() })
    }

    /// The index is another one.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        (scene, Some(Arc::new(MapWithProbes::new(self.map.clone(), self.probes.clone()))))
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

/// How a probe was chosen; of those that a scene writes out, where they are.
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
    /// Anywhere: in the bounding box, if it was chosen.
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

/// How a map is probed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probing {
    /// How many random probes at level quick, and how many at level full.
    random: [usize; 2],
    /// Their seed.
    seed: u64,
    /// Every n-th vertex and edge is probed at level quick, and at level full; 0 for none.
    stride: [usize; 2],
}

impl Probing {
    /// The seed of random probes.
    pub(super) fn seed(self) -> u64 {
        self.seed
    }

    /// How many random probes.
    pub(super) fn random(self, level: Level) -> usize {
        level.of(self.random)
    }

    /// Every n-th vertex and edge is probed; 0 for none.
    pub(super) fn stride(self, level: Level) -> usize {
        level.of(self.stride)
    }

    /// Reads `random`, `random_full`, `seed`, `quick_stride` and `full_stride`.
    pub(super) fn read(fields: &Fields<'_, '_>) -> Result<Probing, CorpusError> {
        let number = |key, default, range| fields.integer_or(key, default, range);
        let quick = number("random", 0, 0..=MOST_RANDOM)?;
        let random = [quick, number("random_full", quick, 0..=MOST_RANDOM)?];
        let stride = number("quick_stride", 1, 0..=MOST_STRIDE)?;
        // All, unless there are none.
        let stride = [stride, number("full_stride", stride.min(1), 0..=MOST_STRIDE)?];
        let counts = |numbers: [u64; 2]| numbers.map(|number| usize::try_from(number).unwrap_or(usize::MAX));
        Ok(Probing { random: counts(random), seed: number("seed", 0, 0..=u64::MAX)?, stride: counts(stride) })
    }
}

const MOST_RANDOM: u64 = 100_000_000;
const MOST_STRIDE: u64 = 1_000_000;
