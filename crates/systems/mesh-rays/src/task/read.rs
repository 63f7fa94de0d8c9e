//! The keys of the task: `mesh`, or `points` with `triangles`; `rays` and `extent`.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Field, Fields, ImportNotes, MOST_COORDINATES, RowKind, TableKind, mesh,
    read_csv_rows,
};
use predicament_mesh_locate::task::read::{Simplices, simplices};
use predicament_predicates::{Dimension, Vertex};

use super::content::parts;
use crate::answer::Extent;

static FILE: TableKind = TableKind::new("reference to a file", &["path", "fetch"]);

const SIX: &str = "write six coordinates: those of the first point, then those of the second";

static ROW: RowKind = RowKind { name: "ray", widths: 6..=6, numbers: "coordinates", cure: SIX };

/// The source of a scene.
struct Written {
    file: String,
    line: usize,
    round: bool,
    mesh: Where,
    rays: Rays,
    extent: Extent,
}

enum Where {
    Triangles(PointSource, Simplices<3>),
    File(Origin),
}

enum Rays {
    Rows(Vec<[f64; 6]>),
    File(Origin),
}

/// Points, triangles, and the changes made by reading.
type Read = (Vec<[f64; 3]>, Vec<[Vertex; 3]>, ImportNotes);

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let mesh = match fields.get("mesh") {
        Some(field) => {
            for key in ["points", "triangles"] {
                if let Some(other) = fields.get(key) {
                    return Err(other.error(format!("both `mesh` and `{key}`"), "remove this one: the file has them"));
                }
            }
            Where::File(origin(context, &field)?)
        }
        None => {
            const NEEDED: &str = "`mesh`, or `points` with `triangles`";
            let points = fields.required("points").map_err(|missing| fields.lacking(NEEDED, missing))?;
            let points = PointSource::read(context, &points, fields.file())?;
            Where::Triangles(points, simplices(&fields.required("triangles")?, "a triangle")?)
        }
    };
    let field = fields.required("rays")?;
    let rays = if field.is_table() { Rays::File(origin(context, &field)?) } else { Rays::Rows(rows(&field)?) };
    let extent = extent(fields)?;
    let (file, line, round) = (fields.file().to_owned(), fields.line(), context.round());
    Ok(Source::elsewhere(Written { file, line, round, mesh, rays, extent }))
}

/// Reads the key `extent`.
pub(super) fn extent(fields: &Fields<'_, '_>) -> Result<Extent, CorpusError> {
    let Some(field) = fields.get("extent") else { return Ok(Extent::Ray) };
    let word = field.str()?;
    let extent = Extent::ALL.into_iter().find(|extent| extent.name() == word);
    extent.ok_or_else(|| field.error(format!("`{word}` is not an extent"), "write \"line\", \"ray\" or \"segment\""))
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

fn rows(field: &Field<'_, '_>) -> Result<Vec<[f64; 6]>, CorpusError> {
    let row = |item: Field<'_, '_>| {
        let row: Vec<f64> = item.items("six coordinates")?.map(|x| x.coordinate()).collect::<Result<_, _>>()?;
        let count = row.len();
        let row = <[f64; 6]>::try_from(row).map_err(|_| item.error(format!("a ray of {count} coordinates"), SIX))?;
        if row[..3] == row[3..] {
            return Err(item.error("a ray whose two points are equal", "give it a direction"));
        }
        Ok(row)
    };
    field.items("rays of six coordinates")?.map(row).collect()
}

impl Written {
    fn error(&self, message: String, cure: &str) -> CorpusError {
        CorpusError::file(&self.file, message, cure).at_line(self.line)
    }

    fn mesh(&self, cache: &Cache) -> Result<Read, CorpusError> {
        match &self.mesh {
            Where::Triangles(source, triangles) => {
                let (dimension, coordinates, notes) = source.coordinates(cache)?;
                if dimension != Dimension::Three {
                    let message = "`points` have 2 coordinates each; meshes need 3";
                    return Err(source.error(message, "give every point 3 coordinates"));
                }
                let points = coordinates.as_chunks().0.to_vec();
                let corners = triangles.iter().map(|&(_, corners)| corners).collect();
                Ok((points, corners, notes))
            }
            Where::File(origin) => {
                let decimals = Decimals::new(self.round);
                let (file, bytes) = origin.bytes(cache)?;
                let read = mesh::read(&file, bytes, &decimals)?;
                let mut notes = read.notes;
                notes.rounded += decimals.rounded();
                Ok((read.points, read.triangles, notes))
            }
        }
    }

    fn rays(&self, cache: &Cache) -> Result<(Vec<[f64; 6]>, usize), CorpusError> {
        match &self.rays {
            Rays::Rows(rows) => Ok((rows.clone(), 0)),
            Rays::File(origin) => {
                let decimals = Decimals::new(self.round);
                let (file, bytes) = origin.bytes(cache)?;
                let read = read_csv_rows(&file, bytes, &ROW, &decimals)?;
                let rows: Vec<[f64; 6]> = read.numbers.as_chunks().0.to_vec();
                if let Some(at) = rows.iter().position(|row| row[..3] == row[3..]) {
                    let error = CorpusError::file(&file, "a ray whose two points are equal", "give it a direction");
                    return Err(error.at_line(read.lines[at]));
                }
                Ok((rows, decimals.rounded()))
            }
        }
    }
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (points, triangles, mut notes) = self.mesh(cache)?;
        let (rays, rounded) = self.rays(cache)?;
        notes.rounded += rounded;
        if triangles.is_empty() {
            return Err(self.error("a mesh without triangles".to_owned(), "give it some"));
        }
        for (at, corners) in triangles.iter().enumerate() {
            if let Some(v) = corners.iter().find(|v| v.index() >= points.len()) {
                let message = format!("triangle {at} has vertex {v}, but the mesh has no such point");
                return Err(self.error(message, "indices count from 0"));
            }
            let [a, b, c] = *corners;
            if a == b || b == c || c == a {
                let message = format!("triangle {at} has a vertex twice");
                return Err(self.error(message, "remove it, and join its neighbours"));
            }
        }
        if points.as_flattened().iter().chain(rays.as_flattened()).any(|x| !x.is_finite()) {
            return Err(self.error("a coordinate that is not finite".to_owned(), "correct the points"));
        }
        if 3 * points.len() + 6 * rays.len() > MOST_COORDINATES {
            let message = format!("too many coordinates: a scene has at most {MOST_COORDINATES}");
            return Err(self.error(message, "divide the rays among several scenes"));
        }
        Ok(Parts { notes, ..parts(points, &triangles, &rays, self.extent) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        let rays = match &self.rays {
            Rays::File(origin) => origin.entry(),
            Rays::Rows(_) => None,
        };
        match &self.mesh {
            Where::Triangles(points, _) => points.entry(),
            Where::File(origin) => origin.entry(),
        }
        .or(rays)
    }
}
