//! The keys of the task: `mesh`, or `points` with `triangles`, `loops` or both.

use std::collections::BTreeSet;

use predicament_corpus::{Context, Elsewhere, Level, Origin, Parts, PointSource, Source};
use predicament_formats::{Cache, CorpusError, Decimals, Entry, Fields, ImportNotes, TableKind, mesh};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh_locate::task::read::{Simplices, simplices};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::map_loops::{Loops, read_loops};

use super::content::HoleScene;
use crate::answer::edges;

static FILE: TableKind = TableKind::new("reference to a file", &["path", "fetch"]);

/// The most points of a loop: dynamic programming takes n³/6 steps for each cover, and the judge keeps as many areas.
pub const LONGEST: usize = 200;

/// The source of a scene.
struct Written {
    file: String,
    line: usize,
    mesh: Where,
    loops: Option<Loops>,
}

enum Where {
    Written(PointSource, Simplices<3>),
    File(Origin, bool),
}

/// Reads a scene.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    const NEEDED: &str = "`mesh`, or `points` with `triangles` or `loops`";
    let loops = fields.get("loops").map(|field| read_loops(&field)).transpose()?;
    let mesh = match fields.get("mesh") {
        Some(field) => {
            if let Some(other) = ["points", "triangles"].into_iter().find_map(|key| fields.get(key)) {
                return Err(other.error("a mesh with two sources", "remove this one: the file has it"));
            }
            let table = field.fields(&FILE)?;
            let origin = match table.get("fetch") {
                Some(key) => Origin::fetched(context, &key)?,
                None => Origin::path(context, &table.required("path")?)?,
            };
            table.finish()?;
            Where::File(origin, context.round())
        }
        None => {
            let points = fields.required("points").map_err(|missing| fields.lacking(NEEDED, missing))?;
            let points = PointSource::read(context, &points, fields.file())?;
            let triangles = match fields.get("triangles") {
                Some(field) => simplices(&field, "a triangle")?,
                None if loops.is_some() => Vec::new(),
                None => return Err(fields.error("points without `triangles` or `loops`", format!("write {NEEDED}"))),
            };
            Where::Written(points, triangles)
        }
    };
    Ok(Source::elsewhere(Written { file: fields.file().to_owned(), line: fields.line(), mesh, loops }))
}

impl Written {
    fn error(&self, message: impl Into<String>, cure: &str) -> CorpusError {
        CorpusError::file(&self.file, message, cure).at_line(self.line)
    }

    fn mesh(&self, cache: &Cache) -> Result<(Scene, Vec<[Vertex; 3]>, ImportNotes), CorpusError> {
        match &self.mesh {
            Where::Written(source, triangles) => {
                let (scene, notes) = source.scene(cache)?;
                if scene.dimension() != Dimension::Three {
                    return Err(source.error("points of the plane", "give every point 3 coordinates"));
                }
                Ok((scene, triangles.iter().map(|&(_, corners)| corners).collect(), notes))
            }
            Where::File(origin, round) => {
                let decimals = Decimals::new(*round);
                let (file, bytes) = origin.bytes(cache)?;
                let read = mesh::read(&file, bytes, &decimals)?;
                let mut notes = read.notes;
                notes.rounded += decimals.rounded();
                let scene = Scene::new(Dimension::Three, read.points.into_flattened());
                let scene = scene.map_err(|why| self.error(why.to_string(), "correct the points"))?;
                Ok((scene, read.triangles, notes))
            }
        }
    }

    /// Checks the loops that are written.
    fn checked(&self, points: usize, triangles: &[[Vertex; 3]], loops: &Loops) -> Result<(), CorpusError> {
        let mut taken: BTreeSet<[Vertex; 2]> = triangles.iter().flat_map(|corners| edges(corners)).collect();
        for (line, around) in loops {
            let error = |message: String, cure: &str| CorpusError::file(&self.file, message, cure).at_line(*line);
            if let Some(unknown) = around.iter().find(|v| v.index() >= points) {
                let message = format!("the corner {unknown} is out of range: the scene has {points} points");
                return Err(error(message, "indices count from 0"));
            }
            if around.len() < 3 {
                return Err(error(format!("a loop with {} corners", around.len()), "give it at least three"));
            }
            if let Some([v, _]) = edges(around).find(|[a, b]| a == b) {
                return Err(error(format!("the corner {v} occurs twice in a row"), "write it once"));
            }
            for [a, b] in edges(around) {
                if !taken.insert([a, b]) {
                    let message = format!("the edge {a} {b} of a loop is in use in its direction");
                    return Err(error(message, "turn the loop around, or divide it"));
                }
            }
        }
        Ok(())
    }
}

impl Elsewhere for Written {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, triangles, notes) = self.mesh(cache)?;
        let told = |why: predicament_mesh::half_edge::ConversionError| {
            let (message, cure) = why.explained(|face| format!("triangle {face}"), |v| format!("vertex {v}"));
            self.error(message, cure)
        };
        let content = match &self.loops {
            None => HoleScene::of_holes(scene.len(), triangles).map_err(told)?,
            Some(loops) => {
                HalfEdgeMesh::of_scene(scene.len(), &triangles).map_err(told)?;
                self.checked(scene.len(), &triangles, loops)?;
                let loops = loops.iter().map(|(_, around)| around.clone()).collect();
                HoleScene { triangles, loops, are_written: true }
            }
        };
        if content.loops.is_empty() {
            return Err(self.error("a mesh without holes", "name a loop, or take triangles out"));
        }
        if let Some(long) = content.loops.iter().find(|around| around.len() > LONGEST) {
            let message = format!("a loop of {} points: the task covers loops of at most {LONGEST}", long.len());
            return Err(self.error(message, "divide the loop by an edge"));
        }
        Ok(Parts { notes, ..Parts::new(scene, content) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        match &self.mesh {
            Where::Written(points, _) => points.entry(),
            Where::File(origin, _) => origin.entry(),
        }
    }
}
