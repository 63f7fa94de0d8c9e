//! A map with points to locate in it, and the rules for choosing them.

use std::any::Any;
use std::sync::{Arc, OnceLock};

use predicament_corpus::{Canon, Content, Items, Level, List, Spelled, unnumbered};
use predicament_formats::{CorpusError, Fields};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::map_loops::spelled_loops;

/// A map with points to locate in it.
///
/// Every probe is a separate vertex, even if its coordinates are those of a map vertex. Probes are numbered alternately
/// before and after all of the map's vertices, the first one before. So Simulation of Simplicity moves half of them
/// further than the map and half of them less far.
#[derive(Debug)]
pub struct MapWithProbes {
    /// The regions.
    pub map: PolygonMap,
    /// The points to locate.
    pub probes: Vec<Probe>,
    /// Data that an algorithm makes of the content once, for all backends; its type is the algorithm's.
    made: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl MapWithProbes {
    /// Combines a map and its probes.
    #[must_use]
    pub fn new(map: PolygonMap, probes: Vec<Probe>) -> MapWithProbes {
        MapWithProbes { map, probes, made: OnceLock::new() }
    }

    /// The data that `make` makes, once. The truth reads this type too, so the type does not name an algorithm.
    ///
    /// # Panics
    /// If it was made as another type.
    pub(super) fn made<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> &T {
        self.made.get_or_init(|| Box::new(make())).downcast_ref().expect("one type of data for each content")
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

    /// Writes loops of indices, which keep the numbers of vertices. Returns `None` if the map has no points.
    ///
    /// The id includes the kind of a probe, and can change: the kind does not always follow from the position. A double
    /// below a vertex may also be a vertex.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let apart = unnumbered(scene, &self.vertices());
        let own = |ring: &[Vertex]| ring.iter().map(|&v| apart.vertex(v)).collect();
        let rings = |region: &predicament_mesh::Region| region.rings.iter().map(|ring| own(ring.vertices())).collect();
        let regions: Vec<Vec<Vec<Vertex>>> = self.map.regions().iter().map(rings).collect();
        let lists = vec![spelled_loops(&regions)?, List::new("probes", Items::Rows(apart.places))];
        let words = vec![("quick_stride", "0".to_owned())];
        (!apart.points.is_empty()).then(|| Spelled { points: apart.points, words, lists, ..Spelled::default() })
    }

    /// The index of the moved scene is new.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        (scene, Some(Arc::new(MapWithProbes::new(self.map.clone(), self.probes.clone()))))
    }
}

/// A point to locate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Probe {
    /// Its vertex in the scene.
    pub vertex: Vertex,
    /// The rule by which it was chosen.
    pub kind: ProbeKind,
}

/// The rule by which a probe was chosen; for probes that a scene lists, their position.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ProbeKind {
    /// On a vertex of the map.
    Vertex,
    /// On an edge: its midpoint, if that is a pair of doubles.
    Midpoint,
    /// A point one double straight below a vertex.
    Below,
    /// A point one double straight above a vertex.
    Above,
    /// Anywhere; if chosen, in the bounding box.
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

/// The rules for the probes of a map.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probing {
    /// The number of random probes, at levels quick and full.
    random: [usize; 2],
    /// The seed of random probes.
    seed: u64,
    /// Every n-th vertex and edge is probed, at levels quick and full; 0 means never.
    stride: [usize; 2],
}

impl Probing {
    /// The seed of random probes.
    pub(super) fn seed(self) -> u64 {
        self.seed
    }

    /// The number of random probes.
    pub(super) fn random(self, level: Level) -> usize {
        level.of(self.random)
    }

    /// The stride of probed vertices and edges; 0 means never.
    pub(super) fn stride(self, level: Level) -> usize {
        level.of(self.stride)
    }

    /// Reads `random`, `random_full`, `seed`, `quick_stride` and `full_stride`.
    pub(super) fn read(fields: &Fields<'_, '_>) -> Result<Probing, CorpusError> {
        let number = |key, default, range| fields.integer_or(key, default, range);
        let quick = number("random", 0, 0..=MOST_RANDOM)?;
        let random = [quick, number("random_full", quick, 0..=MOST_RANDOM)?];
        let stride = number("quick_stride", 1, 0..=MOST_STRIDE)?;
        // Every vertex and edge, unless probing is off.
        let stride = [stride, number("full_stride", stride.min(1), 0..=MOST_STRIDE)?];
        let counts = |numbers: [u64; 2]| numbers.map(|number| usize::try_from(number).unwrap_or(usize::MAX));
        Ok(Probing { random: counts(random), seed: number("seed", 0, 0..=u64::MAX)?, stride: counts(stride) })
    }
}

const MOST_RANDOM: u64 = 100_000_000;
const MOST_STRIDE: u64 = 1_000_000;
