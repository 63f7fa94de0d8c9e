//! Segments that a table lists or refers to, for tasks about segments in the plane.

use predicament_corpus::{Context, Origin, PointSource};
use predicament_formats::{Cache, CorpusError, Decimals, Entry, Fields, ImportNotes, TableKind, geometry};
use predicament_predicates::{Dimension, Query, Scene, Vertex};

use crate::{ExplainError, Explanation};

static SEGMENTS: TableKind = TableKind::new("reference to segments", &["path", "fetch"]);

/// The source of segments.
pub enum SegmentSource {
    /// The edges of the lines in a geometry file; vertices with equal coordinates are merged.
    File {
        /// The file.
        origin: Origin,
        /// True if decimals that are not doubles are rounded.
        round: bool,
    },
    /// Segments between points that are written out or in a data file; without a list, every two consecutive points.
    Points {
        /// The points.
        points: PointSource,
        /// The segments, each with its line in the suite.
        segments: Option<Vec<(usize, [Vertex; 2])>>,
        /// The suite.
        file: String,
        /// The task that reads them.
        task: &'static str,
    },
}

/// The index of the segment that a query names by its ends, and an explanation with these ends.
pub fn named(segments: &[[Vertex; 2]], query: &Query) -> Result<(usize, Explanation), ExplainError> {
    let ends: Vec<Vertex> = query.vertices().collect();
    let at = segments.iter().position(|segment| *segment == *ends);
    let at = at.ok_or_else(|| ExplainError::not_in_scene(query, "the scene has no such segment"))?;
    Ok((at, Explanation { vertices: ends, ..Explanation::default() }))
}

/// A scene, its segments, and the changes made by reading.
pub type Read = (Scene, Vec<[Vertex; 2]>, ImportNotes);

impl SegmentSource {
    /// Reads `points` and `segments`; without `segments`, every two consecutive points are a segment.
    pub fn read(
        context: &Context<'_>,
        fields: &Fields<'_, '_>,
        task: &'static str,
    ) -> Result<SegmentSource, CorpusError> {
        let listed = fields.get("segments");
        if let Some(field) = listed.filter(|field| field.is_table()) {
            let table = field.fields(&SEGMENTS)?;
            let origin = match table.get("fetch") {
                Some(key) => Origin::fetched(context, &key)?,
                None => Origin::path(context, &table.required("path")?)?,
            };
            table.finish()?;
            return Ok(SegmentSource::File { origin, round: context.round() });
        }
        let points = PointSource::read(context, &fields.required("points")?, fields.file())?;
        let segments = listed.map(|listed| {
            let items =
                listed.items("segments: arrays of the indices of two points, or { path = \"roads.geojson\" }")?;
            let segment = items.map(|item| {
                let ends: Vec<Vertex> =
                    item.items("the indices of two points")?.map(|end| end.point()).collect::<Result<_, _>>()?;
                let &[a, b] = ends.as_slice() else {
                    let message = format!("a segment with {} ends", ends.len());
                    return Err(item.error(message, "write the indices of two points"));
                };
                if a == b {
                    return Err(item.error(format!("both ends are point {a}"), "name two points"));
                }
                Ok((item.line(), [a, b]))
            });
            segment.collect::<Result<Vec<_>, _>>()
        });
        Ok(SegmentSource::Points { points, segments: segments.transpose()?, file: fields.file().to_owned(), task })
    }

    /// True if everything is written out, so that no file is read.
    pub fn is_written(&self) -> bool {
        matches!(self, SegmentSource::Points { points, .. } if points.is_written())
    }

    /// The fetched file, if any.
    pub fn entry(&self) -> Option<&Entry> {
        match self {
            SegmentSource::File { origin, .. } => origin.entry(),
            SegmentSource::Points { points, .. } => points.entry(),
        }
    }

    /// The segments.
    pub fn load(&self, cache: &Cache) -> Result<Read, CorpusError> {
        match self {
            SegmentSource::File { origin, round } => of_file(origin, *round, cache),
            SegmentSource::Points { points, segments, file, task } => {
                of_points(points, segments.as_deref(), file, task, cache)
            }
        }
    }
}

fn of_file(origin: &Origin, round: bool, cache: &Cache) -> Result<Read, CorpusError> {
    let decimals = Decimals::new(round);
    let (file, bytes) = origin.bytes(cache)?;
    let found = geometry::read(&file, bytes, &decimals)?.segments()?;
    if found.edges.is_empty() {
        return Err(CorpusError::file(file, "the file has no segments", "give it a line of two points or more"));
    }
    let mut notes = found.notes;
    notes.rounded += decimals.rounded();
    let scene = Scene::from_points2(&found.points)
        .map_err(|error| CorpusError::file(file, error.to_string(), "divide the data"))?;
    Ok((scene, found.edges, notes))
}

fn of_points(
    points: &PointSource,
    listed: Option<&[(usize, [Vertex; 2])]>,
    file: &str,
    task: &str,
    cache: &Cache,
) -> Result<Read, CorpusError> {
    let (scene, notes) = points.scene(cache)?;
    if scene.dimension() == Dimension::Three {
        let message = format!("{task} takes points with 2 coordinates, not 3");
        return Err(points.error(message, "give every point 2 coordinates"));
    }
    let segments: Vec<[Vertex; 2]> = match listed {
        None if scene.len() % 2 == 1 => {
            let message = format!("{} points don't divide into segments", scene.len());
            return Err(points.error(message, "add or remove a point, or write `segments`"));
        }
        None => (0..scene.len() / 2).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect(),
        Some(listed) => {
            let unknown = |ends: &[Vertex; 2]| ends.iter().find(|end| end.index() >= scene.len()).copied();
            if let Some((line, end)) = listed.iter().find_map(|(line, ends)| Some((*line, unknown(ends)?))) {
                let message = format!("the end {end} is out of range: the scene has {} points", scene.len());
                return Err(CorpusError::file(file, message, "indices count from 0").at_line(line));
            }
            listed.iter().map(|(_, ends)| *ends).collect()
        }
    };
    if segments.is_empty() {
        return Err(points.error("a scene without segments", "write at least one"));
    }
    Ok((scene, segments, notes))
}
