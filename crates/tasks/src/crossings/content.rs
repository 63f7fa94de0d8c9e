//! `segments`: pairs of points, and families of them.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Family, Level, Making, Origin, Parts, PointSource, Random, Recipe, Source,
};
use predicament_formats::bits::integer;
use predicament_formats::{Cache, CorpusError, Decimals, Entry, Fields, TableKind, geometry};
use predicament_predicates::{Dimension, Scene, Vertex};

/// Segments of the plane by their ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Segments(pub Vec<[Vertex; 2]>);

impl Content for Segments {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("crossings");
        canon.vertices(self.0.as_flattened());
    }
}

static SEGMENTS: TableKind = TableKind::new("reference to segments", &["path", "fetch"]);

/// Reads `points` and `segments`; without the latter, every two points in turn are a segment.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let listed = fields.get("segments");
    if let Some(field) = listed.filter(|field| field.is_table()) {
        let table = field.fields(&SEGMENTS)?;
        let origin = match table.get("fetch") {
            Some(key) => Origin::fetched(context, &key)?,
            None => Origin::path(context, &table.required("path")?)?,
        };
        table.finish()?;
        return Ok(Source::elsewhere(InFile { origin, round: context.round() }));
    }
    let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
    let segments = listed.map(|listed| {
        let items = listed.items("segments: arrays of the indices of two points, or { path = \"roads.geojson\" }")?;
        let segment = items.map(|item| {
            let ends: Vec<Vertex> =
                item.items("the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
            let &[a, b] = ends.as_slice() else {
                let message = format!("a segment of {} ends", ends.len());
                return Err(item.error(message, "write the indices of two points"));
            };
            if a == b {
                return Err(item.error(format!("both ends are point {a}"), "name two points"));
            }
            Ok((item.line(), [a, b]))
        });
        segment.collect::<Result<Vec<_>, _>>()
    });
    let asked = OfPoints { points, segments: segments.transpose()?, file: fields.file().to_owned() };
    if asked.points.is_written() {
        // Nothing is read from a cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// The edges of the lines in a geometry file; vertices with equal coordinates are one point.
struct InFile {
    origin: Origin,
    round: bool,
}

impl Elsewhere for InFile {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let decimals = Decimals::new(self.round);
        let (file, bytes) = self.origin.bytes(cache)?;
        let found = geometry::read(&file, bytes, &decimals)?.segments()?;
        if found.edges.is_empty() {
            return Err(CorpusError::file(file, "the file has no segments", "give it a line of two points or more"));
        }
        let mut notes = found.notes;
        notes.rounded += decimals.rounded();
        let scene = Scene::from_points2(&found.points)
            .map_err(|error| CorpusError::file(file, error.to_string(), "divide the data"))?;
        Ok(Parts { notes, ..Parts::new(scene, Segments(found.edges)) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.origin.entry()
    }
}

/// Segments between points that are written out or in a data file; every two points where none are listed.
struct OfPoints {
    points: PointSource,
    /// Each with its line in the suite.
    segments: Option<Vec<(usize, [Vertex; 2])>>,
    file: String,
}

impl Elsewhere for OfPoints {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        if scene.dimension() == Dimension::Three {
            let message = "crossings takes points of 2 coordinates, not of 3";
            return Err(self.points.error(message, "give every point 2 coordinates"));
        }
        let segments: Vec<[Vertex; 2]> = match &self.segments {
            None if scene.len() % 2 == 1 => {
                let message = format!("{} points don't divide into segments", scene.len());
                return Err(self.points.error(message, "add or remove a point, or write `segments`"));
            }
            None => (0..scene.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect(),
            Some(listed) => {
                let unknown = |ends: &[Vertex; 2]| ends.iter().find(|end| end.index() >= scene.len()).copied();
                if let Some((line, end)) = listed.iter().find_map(|(line, ends)| Some((*line, unknown(ends)?))) {
                    let message = format!("the end {end} is out of range: the scene has {} points", scene.len());
                    return Err(CorpusError::file(&self.file, message, "indices count from 0").at_line(line));
                }
                listed.iter().map(|(_, ends)| *ends).collect()
            }
        };
        if segments.is_empty() {
            return Err(self.points.error("a scene without segments", "write at least one"));
        }
        Ok(Parts { notes, ..Parts::new(scene, Segments(segments)) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}

/// The families of segments.
pub(super) static FAMILIES: [Family; 3] = [
    Family {
        name: "segments-uniform",
        reported_as: Some("segments-uniform"),
        parameters: &[],
        about: "segments between points uniform in the unit square",
        read: |_, _| Ok(recipe(uniform)),
    },
    Family {
        name: "segments-lattice",
        reported_as: Some("segments-lattice"),
        parameters: &[],
        about: "lines of a lattice and its diagonals: three or four cross in each point of it",
        read: |_, _| Ok(recipe(lattice)),
    },
    Family {
        name: "segments-near",
        reported_as: Some("segments-near"),
        parameters: &[],
        about: "segments that pass the centre of the unit square within a few ulps",
        read: |_, _| Ok(recipe(near)),
    },
];

fn recipe(points: fn(usize, &mut Random) -> Vec<[f64; 2]>) -> Recipe {
    Recipe::new(move |making: &Making| {
        let points = points(making.n, &mut making.random());
        let segments = (0..points.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
        Parts::new(Scene::from_points2(&points).expect("generators make finite points"), Segments(segments))
    })
    .with_coordinates(|n| 4 * n)
}

fn uniform(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    (0..2 * n).map(|_| [rng.unit(), rng.unit()]).collect()
}

/// The lines x = i, y = i, x + y = i and x − y = i in turn, through a square and half a unit beyond it.
fn lattice(n: usize, _: &mut Random) -> Vec<[f64; 2]> {
    let side = i64::try_from(n.div_ceil(4).max(1)).expect("scenes are smaller than memory");
    let (low, high) = (-0.5, integer(side) + 0.5);
    (0..n)
        .flat_map(|at| {
            let i = integer(i64::try_from(at / 4).expect("scenes are smaller than memory"));
            match at % 4 {
                0 => [[i, low], [i, high]],
                1 => [[low, i], [high, i]],
                2 => [[low, i - low], [high, i - high]],
                _ => [[low, low - i], [high, high - i]],
            }
        })
        .collect()
}

/// Through the centre up to the rounding of the second end.
fn near(n: usize, rng: &mut Random) -> Vec<[f64; 2]> {
    let end = |rng: &mut Random| [rng.unit(), rng.unit()];
    (0..n)
        .flat_map(|_| {
            let a = end(rng);
            let stretch = rng.between(0.5, 1.0);
            [a, a.map(|x| 0.5 + stretch * (0.5 - x))]
        })
        .collect()
}
