//! `map`: a map and how to probe it.

use std::path::PathBuf;
use std::sync::OnceLock;

use predicament_algorithms::polygon_locate::LocateIndex;
use predicament_corpus::{Canon, Content, Context, Elsewhere, Level, Parts};
use predicament_formats::{Cache, CorpusError, Entry, Field, Fields, TableKind, read_text, topojson};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};

use super::probes::with_probes;

static MAP: TableKind = TableKind::new("map", &["topojson", "fetch", "object"]);

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

/// How a map is probed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probing {
    /// How many random probes at level quick, and how many at level full.
    random: [usize; 2],
    /// Their seed.
    seed: u64,
    /// Every n-th vertex and edge is probed at level quick, and at level full.
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

    /// Every n-th vertex and edge is probed.
    pub(super) fn stride(self, level: Level) -> usize {
        level.of(self.stride)
    }

    /// Reads `random`, `random_full`, `seed`, `quick_stride` and `full_stride`.
    pub(super) fn read(fields: &Fields<'_, '_>) -> Result<Probing, CorpusError> {
        let number = |key, default, range| fields.integer_or(key, default, range);
        let quick = number("random", 0, 0..=MOST_RANDOM)?;
        let random = [quick, number("random_full", quick, 0..=MOST_RANDOM)?];
        let stride = [number("quick_stride", 1, 1..=MOST_STRIDE)?, number("full_stride", 1, 1..=MOST_STRIDE)?];
        let counts = |numbers: [u64; 2]| numbers.map(|number| usize::try_from(number).unwrap_or(usize::MAX));
        Ok(Probing { random: counts(random), seed: number("seed", 0, 0..=u64::MAX)?, stride: counts(stride) })
    }
}

const MOST_RANDOM: u64 = 100_000_000;
const MOST_STRIDE: u64 = 1_000_000;

/// A TopoJSON map in a file or fetched, and how to probe it.
pub(super) struct MapSource {
    origin: Origin,
    object: String,
    probing: Probing,
}

/// Where a map or a mesh is.
#[derive(Clone, Debug)]
pub(crate) enum Origin {
    /// A file beside the suite.
    Path(PathBuf),
    /// A file of a package.
    Fetched(Entry),
}

impl Origin {
    /// The file's name and its text.
    pub(crate) fn read(&self, cache: &Cache) -> Result<(String, String), CorpusError> {
        match self {
            Origin::Path(path) => Ok((path.display().to_string(), read_text(path)?)),
            Origin::Fetched(entry) => Ok((cache.path(entry).display().to_string(), cache.read(entry)?)),
        }
    }

    /// The file's name and what is in it.
    pub(crate) fn bytes(&self, cache: &Cache) -> Result<(String, Vec<u8>), CorpusError> {
        match self {
            Origin::Path(path) => Ok((path.display().to_string(), predicament_formats::read_bytes(path)?)),
            Origin::Fetched(entry) => Ok((cache.path(entry).display().to_string(), cache.bytes(entry)?)),
        }
    }

    /// The fetched file, if it is one.
    pub(crate) fn entry(&self) -> Option<&Entry> {
        match self {
            Origin::Path(_) => None,
            Origin::Fetched(entry) => Some(entry),
        }
    }
}

impl MapSource {
    /// Reads `map` and how to probe it.
    pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<MapSource, CorpusError> {
        let map = fields.required("map")?;
        let table = map.fields(&MAP)?;
        let origin = origin(context, &map, table.get("topojson"), table.get("fetch"))?;
        let Some(origin) = origin else { return Err(table.lacking("one of `topojson` and `fetch`", not_one(&map))) };
        let object = table.required("object")?.string()?;
        table.finish()?;
        Ok(MapSource { origin, object, probing: Probing::read(fields)? })
    }
}

fn not_one(map: &Field<'_, '_>) -> CorpusError {
    map.error("a map is either a file or fetched", "write one of `topojson` and `fetch`")
}

fn origin(
    context: &Context<'_>,
    map: &Field<'_, '_>,
    path: Option<Field<'_, '_>>,
    key: Option<Field<'_, '_>>,
) -> Result<Option<Origin>, CorpusError> {
    match (path, key) {
        (Some(path), None) => Ok(Some(Origin::Path(context.path(&path)?))),
        (None, Some(key)) => Ok(Some(Origin::Fetched(context.fetched(&key)?))),
        (None, None) => Ok(None),
        (Some(_), Some(_)) => Err(not_one(map)),
    }
}

impl Elsewhere for MapSource {
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (file, text) = self.origin.read(cache)?;
        let imported = topojson::read(&file, &text, &self.object)?;
        let parts = with_probes(imported.points, imported.map, self.probing, level);
        Ok(Parts { notes: imported.notes, ..parts })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.origin.entry()
    }
}
