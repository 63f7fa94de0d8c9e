//! Scene definitions, from `[[scene]]` tables to loaded scenes.

use std::fmt;
use std::sync::Arc;

use predicament_formats::{Cache, CorpusError, Entry, Field, Fields, Kept, NotWritten, Written, shown};

use super::{Context, DataName};
use crate::id::written_id;
use crate::{Elsewhere, InDecimals, Level, LoadedScene, MoveError, Parts, SceneFormat, Source, content_id};

/// A scene as its suite defines it; [`SceneDef::load`] loads it.
#[derive(Clone)]
pub struct SceneDef {
    /// The name of the scene's suite.
    pub suite: String,
    /// The scene's name, unique in the suite.
    pub name: String,
    /// The name of the task.
    pub task: &'static str,
    /// The family's name in `throughput.csv`; the scene's name if it has no family.
    pub family: String,
    /// Free words for selecting scenes.
    pub tags: Vec<String>,
    /// The origin of the scene.
    pub source: String,
    /// One sentence for the report.
    pub analysis: String,
    /// True if the scene is marked as invalid input of its task.
    pub is_invalid: bool,
    /// The file that defines the scene, as error messages name it.
    pub file: String,
    /// The line where the scene's table starts.
    pub line: usize,
    content: Where,
    /// The data files that the scene's table refers to, in order.
    data: Vec<DataName>,
    /// The number of rounded decimals in the scene's table.
    rounded: usize,
    /// The decimals in the scene's table and the task's limit, if the scene has a truth of decimals.
    decimals: Option<(Kept, InDecimals)>,
}

#[derive(Clone)]
enum Where {
    /// A scene that is written in the suite, and its content id.
    Written(Arc<(Parts, String)>),
    Elsewhere(Arc<dyn Elsewhere>),
}

impl fmt::Debug for SceneDef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{} ({}:{})", self.suite, self.name, self.file, self.line)
    }
}

impl SceneDef {
    /// True if the scene needs data from `predicament corpus fetch`.
    #[must_use]
    pub fn needs_fetch(&self) -> bool {
        self.fetch_entry().is_some()
    }

    /// True if the scene's points and content are written in the suite.
    #[must_use]
    pub fn is_written(&self) -> bool {
        matches!(self.content, Where::Written(_))
    }

    /// The fetched file that the scene needs (the first, if there are two), if any.
    #[must_use]
    pub fn fetch_entry(&self) -> Option<&Entry> {
        match &self.content {
            Where::Written(_) => None,
            Where::Elsewhere(elsewhere) => elsewhere.fetch_entry(),
        }
    }

    /// Reads, generates or imports the scene.
    ///
    /// # Errors
    /// [`CorpusError`] if a data file is missing or wrong; for data that is not yet fetched, the error says how to
    /// fetch it. An error at a line of the suite includes the names of the scene's data files.
    pub fn load(&self, level: Level, cache: &Cache) -> Result<LoadedScene, CorpusError> {
        let (Parts { scene, content, mut notes, remarks, written }, id) = match &self.content {
            Where::Written(written) => written.as_ref().clone(),
            Where::Elsewhere(elsewhere) => {
                let mut parts = elsewhere.load(level, cache).map_err(|error| self.with_data(error, cache))?;
                let id = identify(&mut parts, self.decimals.as_ref(), &self.file, self.line)?;
                (parts, id)
            }
        };
        notes.rounded += self.rounded;
        let loaded = LoadedScene {
            suite: self.suite.clone(),
            name: self.name.clone(),
            id,
            task: self.task,
            family: self.family.clone(),
            tags: self.tags.clone(),
            source: self.source.clone(),
            analysis: self.analysis.clone(),
            is_invalid: self.is_invalid,
            scene,
            content,
            notes,
            remarks,
            written: None,
            similar: None,
        };
        let Some(written) = written else { return Ok(loaded) };
        let is_integers = matches!(self.decimals, Some((_, InDecimals::Integers)));
        let scaled = written.scaled().filter(|_| is_integers);
        let similar = scaled.map(|scaled| loaded.clone().moved(scaled)).transpose();
        let error =
            |why: MoveError| CorpusError::file(&self.file, why.to_string(), NotWritten::CURE).at_line(self.line);
        Ok(LoadedScene { similar: similar.map_err(error)?.map(Arc::new), written: Some(written), ..loaded })
    }

    /// Adds the names of the scene's data files to an error about the suite that does not name them: the cause
    /// may be in the data file, not in the suite.
    fn with_data(&self, error: CorpusError, cache: &Cache) -> CorpusError {
        let mut names: Vec<String> = self.data.iter().map(|data| data.shown(cache)).collect();
        names.dedup();
        if names.is_empty() || error.file != self.file || names.iter().any(|name| error.message.contains(name)) {
            return error;
        }
        CorpusError { message: format!("with {}: {}", names.join(" and "), error.message), ..error }
    }

    /// The content id, if the scene is written in the suite.
    pub(super) fn inline_id(&self) -> Option<&str> {
        match &self.content {
            Where::Written(written) => Some(&written.1),
            Where::Elsewhere(_) => None,
        }
    }
}

/// Creates a definition from the keys that scenes and generators share.
pub(super) fn define(
    context: &Context<'_>,
    fields: Fields<'_, '_>,
    name: String,
    task: &'static dyn SceneFormat,
    family: &str,
    source: Source,
) -> Result<SceneDef, CorpusError> {
    if context.decimal && task.in_decimals() == InDecimals::Never {
        let takes = |other: &&&dyn SceneFormat| other.in_decimals() != InDecimals::Never;
        let names: Vec<&str> = context.vocabulary.tasks().iter().filter(takes).map(|task| task.name()).collect();
        let message =
            format!("{} has no truth of decimals; it depends on more than the shape of the points", task.name());
        return Err(fields.error(message, format!("remove `truth`, or choose {}", names.join(", "))));
    }
    let decimals = context.decimal.then(|| (fields.decimals().kept(), task.in_decimals()));
    let define = SceneDef {
        suite: context.suite.clone(),
        family: family.to_owned(),
        name,
        task: task.name(),
        tags: fields.get("tags").map_or(Ok(Vec::new()), |field| field.strings())?,
        source: fields.string_or_empty("source")?,
        analysis: fields.string_or_empty("analysis")?,
        is_invalid: context.is_invalid,
        file: fields.file().to_owned(),
        line: fields.line(),
        content: match source {
            Source::Written(mut parts) => {
                let id = identify(&mut parts, decimals.as_ref(), fields.file(), fields.line())?;
                Where::Written(Arc::new((parts, id)))
            }
            Source::Elsewhere(elsewhere) => Where::Elsewhere(elsewhere),
        },
        data: context.data.take(),
        rounded: fields.decimals().rounded(),
        decimals,
    };
    fields.finish()?;
    Ok(define)
}

/// The content id of a scene. `decimals` are the decimals in the table of a scene whose truth is about them, and the
/// task's limit; they become the scene's decimals unless a generator made others.
fn identify(
    parts: &mut Parts,
    decimals: Option<&(Kept, InDecimals)>,
    file: &str,
    line: usize,
) -> Result<String, CorpusError> {
    let id = content_id(&parts.scene, parts.content.as_ref());
    let made = parts.written.take();
    let Some((kept, limit)) = decimals else { return Ok(id) };
    let error = |message: String| CorpusError::file(file, message, NotWritten::CURE).at_line(line);
    if !parts.scene.weights().is_empty() {
        return Err(error("weights have no truth of decimals".to_owned()));
    }
    let found = || Written::of(parts.scene.coordinates(), kept).map_err(|why| error(why.to_string()));
    let written = made.map_or_else(found, Ok)?;
    if *limit == InDecimals::Integers && written.scaled().is_none() {
        return Err(error("decimals that are no integers below 2^53 times one power of ten".to_owned()));
    }
    Ok(written_id(&id, parts.written.insert(written)))
}

/// The maximum length of a name, in characters.
const LONGEST_NAME: usize = 200;

/// Checks a name, which appears in tables, on command lines and in terminals. Spreadsheets read text that begins with
/// `=`, `+`, `-` or `@` as a formula.
pub(super) fn check_name(field: &Field<'_, '_>, name: &str) -> Result<(), CorpusError> {
    let message = if name.trim().is_empty() || name.chars().any(char::is_control) {
        format!("the name `{}` is empty or has control characters", name.escape_debug())
    } else if name.chars().nth(LONGEST_NAME).is_some() {
        format!("the name `{}` has more than {LONGEST_NAME} characters", shown(name))
    } else if name.starts_with(['=', '+', '-', '@']) {
        format!("the name `{}` begins like a formula, and tables of runs are opened in spreadsheets", shown(name))
    } else {
        return Ok(());
    };
    Err(field.error(message, "write a name of letters, digits and the like"))
}

/// Reads a `[[scene]]` table.
pub(super) fn read(context: &Context<'_>, fields: Fields<'_, '_>) -> Result<SceneDef, CorpusError> {
    let field = fields.required("name")?;
    let name = field.string()?;
    check_name(&field, &name)?;
    let task = context.vocabulary.task(&fields.required("task")?)?;
    fields.check_keys(|key| context.vocabulary.foreign(key, task))?;
    let source = task.read(context, &fields)?;
    let family = name.clone();
    define(context, fields, name, task, &family, source)
}
