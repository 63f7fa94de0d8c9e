//! `[[scene]]` tables and what becomes of them.

use std::path::PathBuf;
use std::sync::Arc;

use predicament_predicates::Scene;

use super::constructed::Constructions;
use super::contacts::Contacts;
use super::cubes::Cubes;
use super::queries::Plan;
use super::{Context, cubes, interval, points};
use crate::document::{Field, Fields};
use crate::generate::Generator;
use crate::{Cache, CorpusError, Entry, ImportNotes, Level, LoadedScene, Task, Work, content_id, tables};

/// A scene as its suite defines it; [`SceneDef::load`] makes it ready.
#[derive(Clone, Debug)]
pub struct SceneDef {
    /// The suite it is from.
    pub suite: String,
    /// Its name, unique in the suite.
    pub name: String,
    /// What is asked.
    pub task: Task,
    /// The family as `throughput.csv` calls it; the scene's name where it has none.
    pub family: String,
    /// Free words to select by.
    pub tags: Vec<String>,
    /// Where the scene is from.
    pub source: String,
    /// One sentence that ends up in the report.
    pub analysis: String,
    /// The file that defines it, as error messages name it.
    pub file: String,
    /// The line where its table starts.
    pub line: usize,
    pub(super) content: Content,
}

/// Where the points and the questions come from.
#[derive(Clone, Debug)]
pub(super) enum Content {
    /// Written out in the suite: read and checked with it.
    Inline(Arc<(Scene, Work)>),
    /// Points in a CSV file.
    Csv { path: PathBuf, constructed: Constructions, plan: Plan },
    /// Cubes in a CSV file.
    Cubes(PathBuf),
    /// Rows with expected signs, fetched.
    Fixture(Entry),
    /// A map, from a file or fetched.
    Map(MapSource),
    /// Two complexes, at least one of them from a file or fetched.
    Contacts(Box<Contacts>),
    /// Made by a program.
    Generated(Generator),
}

/// A TopoJSON map and how to probe it.
#[derive(Clone, Debug)]
pub(super) struct MapSource {
    pub(super) origin: Origin,
    pub(super) object: String,
    pub(super) probing: Probing,
}

/// Where a map is.
#[derive(Clone, Debug)]
pub(super) enum Origin {
    Path(PathBuf),
    Fetched(Entry),
}

/// How a map is probed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Probing {
    /// How many random probes at level quick, and how many at level full.
    random: [usize; 2],
    /// Their seed.
    pub(crate) seed: u64,
    /// Every so many-th vertex and edge is probed at level quick, and at level full.
    stride: [usize; 2],
}

impl Origin {
    /// The file's name and its text.
    pub(super) fn read(&self, cache: &Cache) -> Result<(String, String), CorpusError> {
        match self {
            Origin::Path(path) => Ok((path.display().to_string(), points::read_text(path)?)),
            Origin::Fetched(entry) => Ok((cache.path(entry).display().to_string(), cache.read(entry)?)),
        }
    }

    /// The file's name and what is in it.
    pub(super) fn bytes(&self, cache: &Cache) -> Result<(String, Vec<u8>), CorpusError> {
        match self {
            Origin::Path(path) => Ok((path.display().to_string(), points::read_bytes(path)?)),
            Origin::Fetched(entry) => Ok((cache.path(entry).display().to_string(), cache.bytes(entry)?)),
        }
    }
}

impl Probing {
    /// How many random probes.
    pub(crate) fn random(self, level: Level) -> usize {
        at(level, self.random)
    }

    /// Every so many-th vertex and edge is probed.
    pub(crate) fn stride(self, level: Level) -> usize {
        at(level, self.stride)
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

fn at(level: Level, [quick, full]: [usize; 2]) -> usize {
    match level {
        Level::Quick => quick,
        Level::Full => full,
    }
}

impl SceneDef {
    /// Whether the scene needs data from `predicament corpus fetch`.
    #[must_use]
    pub fn needs_fetch(&self) -> bool {
        self.fetch_entry().is_some()
    }

    /// The fetched file that the scene needs (the first, where there are two), if any.
    #[must_use]
    pub fn fetch_entry(&self) -> Option<&Entry> {
        match &self.content {
            Content::Fixture(entry) | Content::Map(MapSource { origin: Origin::Fetched(entry), .. }) => Some(entry),
            Content::Contacts(contacts) => contacts.fetch_entry(),
            _ => None,
        }
    }

    /// The content id, where the scene is written out in the suite.
    pub(super) fn inline_id(&self) -> Option<String> {
        match &self.content {
            Content::Inline(inline) => Some(content_id(&inline.0, &inline.1)),
            _ => None,
        }
    }

    /// This definition's name and words, around a scene and its questions.
    pub(super) fn around(&self, scene: Scene, work: Work) -> LoadedScene {
        LoadedScene {
            suite: self.suite.clone(),
            name: self.name.clone(),
            id: content_id(&scene, &work),
            task: self.task,
            family: self.family.clone(),
            tags: self.tags.clone(),
            source: self.source.clone(),
            analysis: self.analysis.clone(),
            scene,
            work,
            expected: None,
            notes: ImportNotes::default(),
        }
    }
}

/// A definition from the keys that scenes and generators share.
pub(super) fn define(
    context: &Context<'_>,
    fields: Fields<'_, '_>,
    name: String,
    task: Task,
    family: &str,
    content: Content,
) -> Result<SceneDef, CorpusError> {
    let define = SceneDef {
        suite: context.suite.clone(),
        family: family.to_owned(),
        name,
        task,
        tags: fields.get("tags").map_or(Ok(Vec::new()), |field| field.strings())?,
        source: fields.string_or_empty("source")?,
        analysis: fields.string_or_empty("analysis")?,
        file: fields.file().to_owned(),
        line: fields.line(),
        content,
    };
    fields.finish()?;
    Ok(define)
}

/// Reads a `[[scene]]` table.
pub(super) fn read(context: &Context<'_>, fields: Fields<'_, '_>) -> Result<SceneDef, CorpusError> {
    let name = fields.required("name")?.string()?;
    let task = fields.required("task")?.task()?;
    let other = match task {
        Task::Contacts2d | Task::Contacts3d => Some(read_contacts(context, &fields, task)?),
        Task::Interval => Some(Content::Inline(Arc::new(interval::read(&fields)?))),
        Task::CubeUnion => Some(match cubes::read(context, &fields)? {
            Cubes::Written(written) => Content::Inline(Arc::new(*written)),
            Cubes::Csv(path) => Content::Cubes(path),
        }),
        _ => None,
    };
    if let Some(content) = other {
        let family = name.clone();
        return define(context, fields, name, task, &family, content);
    }
    let content = match (fields.get("points"), fields.get("fixture"), fields.get("map")) {
        (Some(points), None, None) => read_points(context, &fields, &points, task)?,
        (None, Some(fixture), None) => Content::Fixture(read_fixture(context, &fixture, task)?),
        (None, None, Some(map)) => Content::Map(read_map(context, &fields, &map, task)?),
        (None, None, None) => {
            let cure = "write `points`, `fixture` or `map`";
            let missing = fields.error(format!("scene `{name}` has no content"), cure);
            return Err(fields.lacking("one of `points`, `fixture` and `map`", missing));
        }
        _ => {
            let message = format!("scene `{name}` has more than one of `points`, `fixture` and `map`");
            return Err(fields.error(message, "keep one of them"));
        }
    };
    let family = name.clone();
    define(context, fields, name, task, &family, content)
}

fn read_points(
    context: &Context<'_>,
    fields: &Fields<'_, '_>,
    points: &Field<'_, '_>,
    task: Task,
) -> Result<Content, CorpusError> {
    let plan = Plan::read(fields, task)?;
    let constructed = Constructions::read(fields, task)?;
    if !points.is_array() {
        let table = points.fields(&tables::POINTS)?;
        let path = context.path(&table.required("path")?)?;
        table.finish()?;
        return Ok(Content::Csv { path, constructed, plan });
    }
    let (dimension, coordinates) = points::read(points)?;
    let mut scene =
        Scene::new(dimension, coordinates).map_err(|error| points.error(error.to_string(), "correct the points"))?;
    constructed.add_to(&mut scene, fields.file())?;
    let queries = plan.queries(fields.file(), &scene)?;
    Ok(Content::Inline(Arc::new((scene, Work::Signs(queries)))))
}

fn read_contacts(context: &Context<'_>, fields: &Fields<'_, '_>, task: Task) -> Result<Content, CorpusError> {
    let contacts = Contacts::read(context, fields, task)?;
    if !contacts.is_inline() {
        return Ok(Content::Contacts(Box::new(contacts)));
    }
    // Nothing is read from a cache: everything is written out.
    let (scene, work, _) = contacts.assemble(fields.file(), &Cache::new(""))?;
    Ok(Content::Inline(Arc::new((scene, work))))
}

fn read_fixture(context: &Context<'_>, fixture: &Field<'_, '_>, task: Task) -> Result<Entry, CorpusError> {
    if task.predicate().is_none_or(|kind| kind.arity() < 3) {
        return Err(
            fixture.error(format!("no fixture has rows for {task}"), "use orient2d, orient3d, incircle or insphere")
        );
    }
    let table = fixture.fields(&tables::FIXTURE)?;
    let entry = fetched(context, &table.required("fetch")?)?;
    table.finish()?;
    Ok(entry)
}

fn read_map(
    context: &Context<'_>,
    fields: &Fields<'_, '_>,
    map: &Field<'_, '_>,
    task: Task,
) -> Result<MapSource, CorpusError> {
    if task != Task::PolygonLocate {
        return Err(
            map.error(format!("{task} asks about points, not about a map"), "write `task = \"polygon-locate\"`")
        );
    }
    let table = map.fields(&tables::MAP)?;
    let not_one = || map.error("a map is either a file or fetched", "write one of `topojson` and `fetch`");
    let origin = match (table.get("topojson"), table.get("fetch")) {
        (Some(path), None) => Origin::Path(context.path(&path)?),
        (None, Some(key)) => Origin::Fetched(fetched(context, &key)?),
        (None, None) => return Err(table.lacking("one of `topojson` and `fetch`", not_one())),
        (Some(_), Some(_)) => return Err(not_one()),
    };
    let object = table.required("object")?.string()?;
    table.finish()?;
    Ok(MapSource { origin, object, probing: Probing::read(fields)? })
}

/// The manifest's entry for a fetch key.
pub(super) fn fetched(context: &Context<'_>, key: &Field<'_, '_>) -> Result<Entry, CorpusError> {
    let name = key.str()?;
    context.manifest.entry(name).cloned().ok_or_else(|| {
        key.error(format!("fetch.toml has no key `{name}`"), "use a key of fetch.toml or add an entry there")
    })
}
