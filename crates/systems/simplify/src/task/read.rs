//! The keys of the task: `mesh`, or `points` with `triangles`; `target`.

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::{
    Cache, CorpusError, Decimals, Entry, Fields, ImportNotes, MOST_COORDINATES, Places, TableKind, mesh,
};
use predicament_mesh_locate::task::read::{Simplices, simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

use super::content::MeshToSimplify;
use crate::truth::{Flaw, components};

static FILE: TableKind = TableKind::new("reference to a file", &["path", "fetch"]);

/// The source of a scene.
struct Written {
    file: String,
    line: usize,
    round: bool,
    mesh: Where,
    /// Without one, a quarter of the triangles.
    target: Option<usize>,
}

enum Where {
    Triangles(PointSource, Simplices<3>),
    File(Origin),
}

/// A mesh that was read.
struct Read {
    file: String,
    points: Vec<f64>,
    triangles: Vec<[Vertex; 3]>,
    notes: ImportNotes,
    /// The lines of the triangles, if the suite has them.
    places: Option<Places>,
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let mesh = match fields.get("mesh") {
        Some(field) => {
            for key in ["points", "triangles"] {
                if let Some(other) = fields.get(key) {
                    return Err(other.error(format!("both `mesh` and `{key}`"), "remove this one: the file has them"));
                }
            }
            let table = field.fields(&FILE)?;
            let origin = match table.get("fetch") {
                Some(key) => Origin::fetched(context, &key)?,
                None => Origin::path(context, &table.required("path")?)?,
            };
            table.finish()?;
            Where::File(origin)
        }
        None => {
            const NEEDED: &str = "`mesh`, or `points` with `triangles`";
            let points = fields.required("points").map_err(|missing| fields.lacking(NEEDED, missing))?;
            let points = PointSource::read(context, &points, fields.file())?;
            Where::Triangles(points, simplices(&fields.required("triangles")?, "a triangle")?)
        }
    };
    let target = fields.get("target").map(|field| field.count(0..=u64::from(u32::MAX))).transpose()?;
    let (file, line, round) = (fields.file().to_owned(), fields.line(), context.round());
    let written = Written { file, line, round, mesh, target };
    if matches!(&written.mesh, Where::Triangles(points, _) if points.is_written()) {
        // No cache is read: all coordinates are in the suite.
        return Ok(Source::Written(written.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(written))
}

impl Written {
    fn mesh(&self, cache: &Cache) -> Result<Read, CorpusError> {
        match &self.mesh {
            Where::Triangles(source, triangles) => {
                let (dimension, points, notes) = source.coordinates(cache)?;
                if dimension != Dimension::Three {
                    let message = "`points` have 2 coordinates each; meshes need 3";
                    return Err(source.error(message, "give every point 3 coordinates"));
                }
                let places = Some(Places::of_lines(triangles.iter().map(|(line, _)| *line)));
                let triangles = triangles.iter().map(|&(_, corners)| corners).collect();
                Ok(Read { file: self.file.clone(), points, triangles, notes, places })
            }
            Where::File(origin) => {
                let decimals = Decimals::new(self.round);
                let (file, bytes) = origin.bytes(cache)?;
                let read = mesh::read(&file, bytes, &decimals)?;
                let mut notes = read.notes;
                notes.rounded += decimals.rounded();
                let points = read.points.into_flattened();
                Ok(Read { file, points, triangles: read.triangles, notes, places: None })
            }
        }
    }
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let Read { file, points, triangles, notes, places } = self.mesh(cache)?;
        let own_line = places.is_some().then_some(self.line);
        let error = |message: String, cure: &str| {
            let error = CorpusError::file(&file, message, cure);
            if let Some(line) = own_line { error.at_line(line) } else { error }
        };
        if triangles.is_empty() {
            return Err(error("a mesh without triangles".to_owned(), "give it some"));
        }
        if points.len() > MOST_COORDINATES {
            let message = format!("too many coordinates: a scene has at most {MOST_COORDINATES}");
            return Err(error(message, "simplify a part of the mesh"));
        }
        let count = points.len() / 3;
        for (at, corners) in triangles.iter().enumerate() {
            if let Some(v) = corners.iter().find(|v| v.index() >= count) {
                let message = format!("triangle {at} has vertex {v}, but the mesh has no such point");
                return Err(error(message, "indices count from 0"));
            }
        }
        if let Err(flaw) = components(&triangles) {
            let cure = match flaw {
                Flaw::Repeated(_) => "remove it, and join its neighbours",
                Flaw::Side(_) => "turn one of them over, or remove one",
                Flaw::Fans(_) => "give each fan a vertex of its own",
            };
            return Err(error(flaw.to_string(), cure));
        }
        let scene = Scene::new(Dimension::Three, points).map_err(|why| error(why.to_string(), "correct the points"))?;
        let target = self.target.unwrap_or(triangles.len() / 4);
        Ok(Parts { notes, ..Parts::new(scene, MeshToSimplify { triangles, target }) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        match &self.mesh {
            Where::Triangles(points, _) => points.entry(),
            Where::File(origin) => origin.entry(),
        }
    }
}
