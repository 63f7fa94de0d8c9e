//! Expected disagreements: what is known to be wrong, written down with the reason.
//!
//! Both ways are failures: a finding that nobody expected, and an expectation
//! that no longer comes true. So the file stays a description of the world.

use predicament_predicates::UnknownName;
use std::path::Path;
use std::sync::Arc;

use predicament_formats::{CorpusError, Document, Field, Fields, TableKind, shown};
use predicament_tasks::{Class, ClassCounts, Status};

use crate::known::Scenes;
use crate::pattern::Pattern;

/// One `[[expect]]` table.
#[derive(Clone, Debug)]
pub struct Expectation {
    scenes: Arc<[Pattern]>,
    /// The backend, by its full name.
    pub backend: String,
    /// The class that is expected to occur.
    pub class: Class,
    /// Why it is so; ends up in the report.
    pub reason: String,
    level: Option<String>,
    /// `file:line` of the table.
    pub place: Arc<str>,
}

impl Expectation {
    /// The first of its patterns that names a scene.
    #[must_use]
    pub fn pattern(&self, suite: &str, scene: &str) -> Option<&str> {
        self.scenes.iter().find(|pattern| pattern.names(suite, scene)).map(Pattern::text)
    }
}

/// The parsed file.
#[derive(Clone, Default, Debug)]
pub struct Expectations {
    entries: Vec<Expectation>,
    tables: Vec<Written>,
}

/// A table as it was written, to be held against what there is.
#[derive(Clone, Debug)]
struct Written {
    /// `file:line`.
    place: String,
    scenes: Arc<[Pattern]>,
    backends: Vec<String>,
    level: Option<String>,
}

/// What a tool and a run have that expectations can be about.
pub struct Known<'a> {
    /// Every scene that the tool knows.
    pub scenes: &'a Scenes,
    /// The scenes that were planned.
    pub planned: &'a Scenes,
    /// Whether there is a backend with this name, or may be.
    pub backend: &'a dyn Fn(&str) -> bool,
    /// The backends that were planned.
    pub backends: &'a [String],
    /// The level of the run.
    pub level: &'a str,
}

/// Expectations that a run has not put to the test.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Unused {
    /// Those that no run of this tool can: they name a scene or backend that is not there. One line each.
    pub never: Vec<String>,
    /// Those that this run's selection leaves out, and those about suites that are not here, by place.
    pub here: Vec<String>,
}

static FILE: TableKind = TableKind::new("file of expectations", &["expect"]);
static EXPECT: TableKind = TableKind::new("table [[expect]]", &["scene", "backend", "class", "reason", "level"]);

/// One name or a list of them, none of them empty.
fn names<'d, 't>(fields: &Fields<'d, 't>, key: &'static str) -> Result<Vec<Field<'d, 't>>, CorpusError> {
    let field = fields.required(key)?;
    let names = field.one_or_more()?;
    if names.is_empty() {
        return Err(field.error(format!("`{key}` is an empty list"), "name at least one, or drop the entry"));
    }
    match names.iter().find(|name| name.str() == Ok("")) {
        Some(empty) => Err(empty.error(format!("`{key}` has an empty name"), "write a name, or drop it")),
        None => Ok(names),
    }
}

/// The class of a name; a legal one is never expected.
fn class(name: &Field<'_, '_>) -> Result<Class, CorpusError> {
    let class: Class = name.str()?.parse().map_err(|why: UnknownName| name.error(why.to_string(), "correct it"))?;
    if class.is_legal() {
        return Err(name.error(format!("`{class}` is legal and needs no expectation"), "drop it"));
    }
    Ok(class)
}

impl Expectations {
    /// Parses the text of `file`.
    ///
    /// # Errors
    /// [`CorpusError`] with the file, the line and the cure.
    pub fn parse(file: &Path, text: &str) -> Result<Expectations, CorpusError> {
        Expectations::read(&file.display().to_string(), text)
    }

    fn read(file: &str, text: &str) -> Result<Expectations, CorpusError> {
        let document = Document::new(file, text);
        let root = document.parse()?;
        let fields = Fields::new(&document, &FILE, root.get_ref(), 0);
        let mut all = Expectations::default();
        if let Some(list) = fields.get("expect") {
            for table in list.items("[[expect]] tables")? {
                all.push(file, table.fields(&EXPECT)?)?;
            }
        }
        fields.finish()?;
        Ok(all)
    }

    /// Reads a table.
    fn push(&mut self, file: &str, fields: Fields<'_, '_>) -> Result<(), CorpusError> {
        let strings = |names: Vec<Field<'_, '_>>| names.iter().map(Field::string).collect::<Result<Vec<_>, _>>();
        let (scenes, backends) = (strings(names(&fields, "scene")?)?, strings(names(&fields, "backend")?)?);
        let classes = names(&fields, "class")?.iter().map(class).collect::<Result<Vec<_>, _>>()?;
        let scenes = scenes.iter().map(|pattern| Pattern::new(pattern)).collect::<Result<Arc<[_]>, _>>();
        let scenes = scenes.map_err(|error| fields.error(error.to_string(), "write e.g. `near-*`"))?;
        let why = fields.required("reason")?;
        let reason = why.string()?;
        if reason.trim().is_empty() {
            return Err(why.error("the reason is empty", "say why this is expected"));
        }
        let level = fields.get("level").map(|level| match level.str()? {
            known @ ("quick" | "full") => Ok(known.to_owned()),
            other => {
                let message = format!("no level is called `{}`", shown(other));
                Err(level.error(message, "write `quick` or `full`, or leave it out"))
            }
        });
        let level = level.transpose()?;
        let place: Arc<str> = format!("{file}:{}", fields.line()).into();
        for backend in &backends {
            self.entries.extend(classes.iter().map(|&class| Expectation {
                scenes: scenes.clone(),
                backend: backend.clone(),
                class,
                reason: reason.clone(),
                level: level.clone(),
                place: place.clone(),
            }));
        }
        self.tables.push(Written { place: place.to_string(), scenes, backends, level });
        fields.finish()
    }

    /// These expectations and others.
    #[must_use]
    pub fn and(mut self, others: Expectations) -> Expectations {
        self.entries.extend(others.entries);
        self.tables.extend(others.tables);
        self
    }

    /// The expectations that a run has not put to the test: because what they name is not there, or
    /// because of what was selected.
    #[must_use]
    pub fn unused(&self, known: &Known<'_>) -> Unused {
        let mut unused = Unused::default();
        let is_never = |pattern: &&Pattern| !known.scenes.has_any(pattern) && !known.scenes.may_be_elsewhere(pattern);
        for table in &self.tables {
            let before = unused.never.len();
            for name in table.backends.iter().filter(|name| !(known.backend)(name)) {
                unused.never.push(format!("{}: no backend is called `{name}`; correct or drop it", table.place));
            }
            for pattern in table.scenes.iter().filter(is_never) {
                unused.never.push(format!(
                    "{}: no scene is called `{}`; correct or drop it, or name its suite in the run",
                    table.place,
                    pattern.text()
                ));
            }
            let level = table.level.as_deref().is_none_or(|level| level == known.level);
            let backend = table.backends.iter().any(|name| known.backends.contains(name));
            let scene = || table.scenes.iter().any(|pattern| known.planned.has_any(pattern));
            if unused.never.len() == before && !(level && backend && scene()) {
                unused.here.push(table.place.clone());
            }
        }
        unused
    }

    /// The entries that speak about one row.
    pub fn matching<'a>(
        &'a self,
        suite: &'a str,
        scene: &'a str,
        backend: &'a str,
        level: &'a str,
    ) -> impl Iterator<Item = &'a Expectation> {
        self.entries.iter().filter(move |entry| {
            entry.backend == backend
                && entry.level.as_deref().is_none_or(|wanted| wanted == level)
                && entry.scenes.iter().any(|pattern| pattern.names(suite, scene))
        })
    }

    /// Holds a row against the expectations.
    #[must_use]
    pub fn status(&self, suite: &str, scene: &str, backend: &str, level: &str, counts: &ClassCounts) -> Status {
        let mut expected = [false; Class::ALL.len()];
        for entry in self.matching(suite, scene, backend, level) {
            expected[entry.class as usize] = true;
        }
        let found = |class: &Class| counts.get(*class) > 0;
        let wanted = |class: &Class| expected[*class as usize];
        let findings = || Class::ALL.iter().filter(|class| !class.is_legal());
        if findings().any(|class| found(class) && !wanted(class)) {
            Status::Unexpected
        } else if findings().any(|class| wanted(class) && !found(class)) {
            Status::UnexpectedPass
        } else if findings().any(found) {
            Status::Expected
        } else {
            Status::Ok
        }
    }
}
