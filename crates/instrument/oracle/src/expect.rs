//! Expected disagreements: known errors, each recorded with its reason.
//!
//! Both directions are failures: an unexpected finding, and an expectation that no longer comes true. So the file stays
//! accurate.

use predicament_predicates::UnknownName;
use std::path::Path;
use std::sync::Arc;

use predicament_formats::{CorpusError, Document, Field, Fields, TableKind, shown};
use predicament_tasks::{Class, ClassCounts, Status};

use crate::known::Scenes;
use crate::pattern::Pattern;

/// An `[[expect]]` table.
#[derive(Clone, Debug)]
pub struct Expectation {
    scenes: Arc<[Pattern]>,
    /// The backend, by its full name.
    pub backend: String,
    /// The class that is expected to occur.
    pub class: Class,
    /// The reason for the error, for the report.
    pub reason: String,
    level: Option<String>,
    /// The position of the table, as `file:line`.
    pub place: Arc<str>,
}

impl Expectation {
    /// The expectation's first pattern that matches a scene.
    #[must_use]
    pub fn pattern(&self, suite: &str, scene: &str) -> Option<&str> {
        self.scenes.iter().find(|pattern| pattern.names(suite, scene)).map(Pattern::text)
    }
}

/// The parsed expectations of a file.
#[derive(Clone, Default, Debug)]
pub struct Expectations {
    entries: Vec<Expectation>,
    tables: Vec<Written>,
}

/// A table as written, to be checked against existing scenes and backends.
#[derive(Clone, Debug)]
struct Written {
    /// The position of the table, as `file:line`.
    place: String,
    scenes: Arc<[Pattern]>,
    backends: Vec<String>,
    level: Option<String>,
}

/// The scenes and backends of a tool and a run that expectations can refer to.
pub struct Known<'a> {
    /// Every scene that the tool knows.
    pub scenes: &'a Scenes,
    /// The scenes of the run's plan.
    pub planned: &'a Scenes,
    /// True if a backend with this name exists, or may exist.
    pub backend: &'a dyn Fn(&str) -> bool,
    /// The backends of the run's plan.
    pub backends: &'a [String],
    /// The level of the run.
    pub level: &'a str,
}

/// Expectations that a run does not test.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Unused {
    /// Expectations that no run of this tool can test, since their scene or backend does not exist. One line each.
    pub never: Vec<String>,
    /// Expectations outside of this run's selection or about unavailable suites, by position.
    pub here: Vec<String>,
}

static FILE: TableKind = TableKind::new("file of expectations", &["expect"]);
static EXPECT: TableKind = TableKind::new("table [[expect]]", &["scene", "backend", "class", "reason", "level"]);

/// Reads a name or a list of names; empty names and lists are refused.
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

/// The class with this name; a legal class cannot be expected.
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
    /// [`CorpusError`] with the file, the line and the fix.
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

    /// Adds other expectations to these.
    #[must_use]
    pub fn and(mut self, others: Expectations) -> Expectations {
        self.entries.extend(others.entries);
        self.tables.extend(others.tables);
        self
    }

    /// The expectations that a run does not test: because their scene or backend does not exist, or because of the
    /// run's selection.
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

    /// The expectations that match one row.
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

    /// The status of a row, compared with the expectations.
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
