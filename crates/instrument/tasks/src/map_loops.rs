//! Maps as loops of point indices: in this form vertices keep their numbers.
//!
//! Maps of coordinates merge points at one position and number them in the order of appearance. That changes a
//! perturbation that depends on the number, so a scene that is written out for editing needs indices.

use predicament_corpus::{Context, Items, List, PointSource};
use predicament_formats::{Cache, CorpusError, Entry, Field, Fields, ImportedMap};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Dimension, Vertex};

/// The maximum number of regions; more are a typing error.
pub const MOST_REGIONS: usize = 1 << 22;

/// The keys that a scene about a map needs.
pub const NEEDED: &str = "`map`, or `points` and `loops`";

const LOOPS: &str = "loops: arrays with the indices of points, one array for each loop";
const REGIONS: &str = "an array of the numbers of regions, one for each loop";

/// Each loop with its line in the suite.
pub type Loops = Vec<(usize, Vec<Vertex>)>;

/// Loops of points, each belonging to a region.
#[derive(Clone, Debug)]
pub struct MapLoops {
    points: PointSource,
    loops: Loops,
    /// The region of each loop.
    regions: Vec<usize>,
    file: String,
}

/// Reads loops.
pub fn read_loops(field: &Field<'_, '_>) -> Result<Loops, CorpusError> {
    let one = |item: Field<'_, '_>| {
        let corners: Vec<Vertex> = item.items(LOOPS)?.map(|corner| corner.point()).collect::<Result<_, _>>()?;
        Ok((item.line(), corners))
    };
    field.items(LOOPS)?.map(one).collect()
}

impl MapLoops {
    /// Reads `points`, `loops` and `regions`; without `regions`, each loop is a separate region.
    pub fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<MapLoops, CorpusError> {
        let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
        let loops = fields.get("loops").ok_or_else(|| {
            let missing = fields.error("points without `loops`", format!("write {NEEDED}"));
            fields.lacking(NEEDED, missing)
        })?;
        let loops = read_loops(&loops)?;
        let regions = match fields.get("regions") {
            None => (0..loops.len()).collect(),
            Some(field) => {
                let most = u64::try_from(MOST_REGIONS).unwrap_or(u64::MAX) - 1;
                let regions: Vec<usize> =
                    field.items(REGIONS)?.map(|item| item.count(0..=most)).collect::<Result<_, _>>()?;
                if regions.len() != loops.len() {
                    let message = format!("{} regions for {} loops", regions.len(), loops.len());
                    return Err(field.error(message, "write for each loop the number of the region that it bounds"));
                }
                regions
            }
        };
        Ok(MapLoops { points, loops, regions, file: fields.file().to_owned() })
    }

    /// The map.
    pub fn map(&self, cache: &Cache) -> Result<ImportedMap, CorpusError> {
        let (dimension, coordinates, notes) = self.points.coordinates(cache)?;
        if dimension == Dimension::Three {
            let message = "the points of a map have 2 coordinates, not 3";
            return Err(self.points.error(message, "give every point 2 coordinates"));
        }
        if coordinates.iter().any(|x| !x.is_finite()) {
            return Err(self.points.error("a coordinate that is not finite", "correct the points"));
        }
        let points: Vec<[f64; 2]> = coordinates.as_chunks().0.to_vec();
        let count = self.regions.iter().max().map_or(0, |last| last + 1);
        let mut regions: Vec<Vec<Vec<Vertex>>> = vec![Vec::new(); count];
        for ((line, one), &region) in self.loops.iter().zip(&self.regions) {
            self.check(one, points.len())
                .map_err(|(message, cure)| CorpusError::file(&self.file, message, cure).at_line(*line))?;
            regions[region].push(one.clone());
        }
        let mut map = PolygonMap::new();
        for (at, rings) in regions.into_iter().enumerate() {
            map.push(at.to_string(), rings).map_err(|why| self.points.error(why.to_string(), "correct the loops"))?;
        }
        Ok(ImportedMap { points, map, notes })
    }

    /// The error of a loop over `points` points, and the fix.
    fn check(&self, one: &[Vertex], points: usize) -> Result<(), (String, &'static str)> {
        if let Some(unknown) = one.iter().find(|v| v.index() >= points) {
            let message = format!("the corner {unknown} is out of range: the scene has {points} points");
            return Err((message, "indices count from 0"));
        }
        if one.len() < 3 {
            return Err((
                format!("a loop with {} corners has no inside", one.len()),
                "give it three corners, or leave it out",
            ));
        }
        let next = one.iter().cycle().skip(1);
        match one.iter().zip(next).find(|(a, b)| a == b) {
            Some((corner, _)) => Err((format!("the corner {corner} occurs twice in a row"), "write it once")),
            None => Ok(()),
        }
    }

    /// The fetched file that holds the points, if any.
    pub fn entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}

/// Writes the loops of regions under `loops`, with `regions` unless these are numbered consecutively. Returns `None` if
/// there are too many regions. A last region without loops is left out.
pub fn spelled_loops(regions: &[Vec<Vec<Vertex>>]) -> Option<List> {
    let loops: Vec<Vec<Vertex>> = regions.iter().flatten().cloned().collect();
    if regions.iter().all(|loops| loops.len() == 1) {
        return Some(List::required("loops", Items::Loops(loops)));
    }
    labelled_loops(regions)
}

/// Writes the loops like `spelled_loops`, always with `regions`.
pub fn labelled_loops(regions: &[Vec<Vec<Vertex>>]) -> Option<List> {
    let loops: Vec<Vec<Vertex>> = regions.iter().flatten().cloned().collect();
    let labels = (0_u32..).zip(regions).flat_map(|(region, loops)| std::iter::repeat_n(vec![region], loops.len()));
    let items = Items::Labelled { tuples: loops, key: "regions", rows: labels.collect() };
    (regions.len() <= MOST_REGIONS).then(|| List::required("loops", items))
}
