//! The keys of the task: `points`, and the objects `from` and `to` as lists of indices or as files.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, Fields, ImportNotes, MOST_COORDINATES, TableKind, mesh,
};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::{Loops, parts};

static FILE: TableKind = TableKind::new("reference to a mesh", &["path", "fetch"]);

/// The source of a scene.
struct Written {
    file: String,
    line: usize,
    round: bool,
    points: Option<PointSource>,
    objects: [Object; 2],
}

enum Object {
    /// Loops or triangles of the scene's points, each with its line.
    Written(Vec<(usize, Vec<Vertex>)>),
    /// A file of triangles.
    File(Origin),
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let object = |key: &'static str| -> Result<Object, CorpusError> {
        let field = fields.required(key)?;
        Ok(if field.is_table() { Object::File(origin(context, &field)?) } else { Object::Written(written(&field)?) })
    };
    let objects = [object("from")?, object("to")?];
    let is_written = objects.iter().any(|object| matches!(object, Object::Written(_)));
    let points = match fields.get("points") {
        Some(field) => Some(PointSource::read(context, &field, fields.file())?),
        None if is_written => {
            let missing = fields.required("points").err();
            return Err(missing.unwrap_or_else(|| fields.error("a scene without `points`", "write them")));
        }
        None => None,
    };
    let (file, line, round) = (fields.file().to_owned(), fields.line(), context.round());
    Ok(Source::elsewhere(Written { file, line, round, points, objects }))
}

fn origin(context: &Context<'_>, field: &Field<'_, '_>) -> Result<Origin, CorpusError> {
    let table = field.fields(&FILE)?;
    let origin = match table.get("fetch") {
        Some(key) => Origin::fetched(context, &key)?,
        None => Origin::path(context, &table.required("path")?)?,
    };
    table.finish()?;
    Ok(origin)
}

fn written(field: &Field<'_, '_>) -> Result<Vec<(usize, Vec<Vertex>)>, CorpusError> {
    let part = |item: Field<'_, '_>| {
        let indices: Vec<Vertex> =
            item.items("the indices of points")?.map(|index| index.point()).collect::<Result<_, _>>()?;
        if indices.len() < 3 {
            let message = format!("a loop or triangle of {} indices", indices.len());
            return Err(item.error(message, "write at least three"));
        }
        Ok((item.line(), indices))
    };
    field.items("loops (in the plane) or triangles (in space), as arrays of indices")?.map(part).collect()
}

impl Written {
    fn error(&self, line: usize, message: String, cure: &str) -> CorpusError {
        CorpusError::file(&self.file, message, cure).at_line(line)
    }

    /// The parts that are written out, checked one by one, so that an error has a line.
    fn checked(
        &self,
        given: &[(usize, Vec<Vertex>)],
        dimension: Dimension,
        points: usize,
    ) -> Result<Loops, CorpusError> {
        for (line, part) in given {
            if let Some(v) = part.iter().find(|v| v.index() >= points) {
                let message = format!("index {v} is out of range: the scene has {points} points");
                return Err(self.error(*line, message, "indices count from 0"));
            }
            if let Some(v) = part.iter().enumerate().find_map(|(at, v)| part[..at].contains(v).then_some(v)) {
                return Err(self.error(*line, format!("point {v} is twice in one part"), "name different points"));
            }
            if dimension == Dimension::Three && part.len() != 3 {
                let message = format!("a triangle of {} indices", part.len());
                return Err(self.error(*line, message, "write three"));
            }
        }
        Ok(given.iter().map(|(_, part)| part.clone()).collect())
    }
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let decimals = Decimals::new(self.round);
        let (dimension, mut coordinates, mut notes) = match &self.points {
            Some(points) => points.coordinates(cache)?,
            None => (Dimension::Three, Vec::new(), ImportNotes::default()),
        };
        let given = coordinates.len() / dimension.count();
        let mut loops: [Loops; 2] = Default::default();
        for (object, loops) in self.objects.iter().zip(&mut loops) {
            match object {
                Object::Written(parts) => *loops = self.checked(parts, dimension, given)?,
                Object::File(_) if dimension == Dimension::Two => {
                    let message = "a file of triangles beside points of two coordinates".to_owned();
                    return Err(self.error(self.line, message, "write loops of points"));
                }
                Object::File(origin) => {
                    let start = coordinates.len() / 3;
                    let (name, bytes) = origin.bytes(cache)?;
                    let read = mesh::read(&name, bytes, &decimals)?;
                    coordinates.extend(read.points.as_flattened());
                    notes.add(&read.notes);
                    let shifted = |v: &Vertex| Vertex::input(v.index() + start);
                    *loops = read.triangles.iter().map(|corners| corners.iter().map(shifted).collect()).collect();
                }
            }
        }
        notes.rounded += decimals.rounded();
        if loops.iter().any(Vec::is_empty) {
            return Err(self.error(self.line, "an object without parts".to_owned(), "give it some"));
        }
        let mut first: Vec<Vertex> = loops[0].concat();
        first.sort_unstable();
        if let Some(v) = loops[1].iter().flatten().find(|v| first.binary_search(v).is_ok()) {
            let message = format!("point {v} is in both objects");
            let cure = "give each object its own points; they may have equal coordinates";
            return Err(self.error(self.line, message, cure));
        }
        if coordinates.len() > MOST_COORDINATES {
            let message = format!("too many coordinates: a scene has at most {MOST_COORDINATES}");
            return Err(self.error(self.line, message, "divide the objects among several scenes"));
        }
        let scene = Scene::new(dimension, coordinates)
            .map_err(|error| self.error(self.line, error.to_string(), "correct the points"))?;
        Ok(Parts { notes, ..parts(scene, loops) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        let of_objects = self.objects.iter().find_map(|object| match object {
            Object::File(origin) => origin.entry(),
            Object::Written(_) => None,
        });
        of_objects.or_else(|| self.points.as_ref().and_then(PointSource::entry))
    }
}
