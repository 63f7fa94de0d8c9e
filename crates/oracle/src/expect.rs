//! Expected disagreements: what is known to be wrong, written down with the reason.
//!
//! Both ways are failures: a finding that nobody expected, and an expectation
//! that no longer comes true. So the file stays a description of the world.

use std::path::Path;

use globset::{Glob, GlobMatcher, GlobSet, GlobSetBuilder};
use serde::Deserialize;
use serde_spanned::Spanned;

use predicament_tasks::{Class, ClassCounts, Status};

/// One `[[expect]]` table.
#[derive(Clone, Debug)]
pub struct Expectation {
    scenes: GlobSet,
    /// The backend, by its full name.
    pub backend: String,
    /// The class that is expected to occur.
    pub class: Class,
    /// Why it is so; ends up in the report.
    pub reason: String,
    level: Option<String>,
    /// The line where the table starts.
    pub line: usize,
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
    scenes: Vec<(String, GlobMatcher)>,
    backends: Vec<String>,
    level: Option<String>,
}

/// What a tool and a run have that expectations can be about.
pub struct Known<'a> {
    /// Every scene that the tool knows, by suite and name.
    pub scenes: &'a [(String, String)],
    /// The scenes that were planned.
    pub planned: &'a [(String, String)],
    /// Whether there is a backend with this name.
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
    /// Those that this run's selection leaves out, by place.
    pub here: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    expect: Vec<Spanned<Table>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    scene: Names,
    backend: Names,
    class: Names,
    reason: String,
    level: Option<String>,
}

/// One name or a list of them.
#[derive(Deserialize)]
#[serde(untagged)]
enum Names {
    One(String),
    Many(Vec<String>),
}

impl Names {
    fn list(&self) -> &[String] {
        match self {
            Names::One(name) => std::slice::from_ref(name),
            Names::Many(names) => names,
        }
    }
}

fn globs(patterns: &[String]) -> Result<(GlobSet, Vec<(String, GlobMatcher)>), String> {
    let mut set = GlobSetBuilder::new();
    let mut each = Vec::new();
    for pattern in patterns {
        // globset's own message repeats the pattern.
        let glob = Glob::new(pattern).map_err(|error| format!("{error}; write e.g. `near-*`"))?;
        each.push((pattern.clone(), glob.compile_matcher()));
        set.add(glob);
    }
    Ok((set.build().map_err(|error| format!("the globs of `scene`: {error}"))?, each))
}

impl Expectations {
    /// Parses the text of `file`.
    ///
    /// # Errors
    /// One line that names the file, the line and the cure.
    pub fn parse(file: &Path, text: &str) -> Result<Expectations, String> {
        let line_of = |offset: usize| text[..offset.min(text.len())].matches('\n').count() + 1;
        let parsed: File = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(span.start));
            format!(
                "{}:{line}: {}; see docs/FORMAT.md for the keys",
                file.display(),
                error.message().replace('\n', " ")
            )
        })?;
        let (mut entries, mut tables) = (Vec::new(), Vec::new());
        for table in parsed.expect {
            let line = line_of(table.span().start);
            let table = table.into_inner();
            let fail = |message: String| format!("{}:{line}: {message}", file.display());
            for (key, names) in [("scene", &table.scene), ("backend", &table.backend), ("class", &table.class)] {
                if names.list().is_empty() {
                    return Err(fail(format!("`{key}` is an empty list; name at least one, or drop the entry")));
                }
            }
            let (scenes, each) = globs(table.scene.list()).map_err(fail)?;
            tables.push(Written {
                place: format!("{}:{line}", file.display()),
                scenes: each,
                backends: table.backend.list().to_vec(),
                level: table.level.clone(),
            });
            if table.reason.trim().is_empty() {
                return Err(fail("the reason is empty; say why this is expected".to_owned()));
            }
            if let Some(level) = table.level.as_deref().filter(|level| !["quick", "full"].contains(level)) {
                return Err(fail(format!("no level is called `{level}`; write `quick` or `full`, or leave it out")));
            }
            for backend in table.backend.list() {
                for class in table.class.list() {
                    let class: Class = class.parse().map_err(fail)?;
                    if class.is_legal() {
                        return Err(fail(format!("`{class}` is legal and needs no expectation; drop the entry")));
                    }
                    entries.push(Expectation {
                        scenes: scenes.clone(),
                        backend: backend.clone(),
                        class,
                        reason: table.reason.clone(),
                        level: table.level.clone(),
                        line,
                    });
                }
            }
        }
        Ok(Expectations { entries, tables })
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
        for table in &self.tables {
            let matches = |glob: &GlobMatcher, (suite, scene): &(String, String)| {
                glob.is_match(scene) || glob.is_match(format!("{suite}/{scene}"))
            };
            let before = unused.never.len();
            for name in table.backends.iter().filter(|name| !(known.backend)(name)) {
                unused.never.push(format!("{}: no backend is called `{name}`; correct or drop it", table.place));
            }
            for (pattern, glob) in &table.scenes {
                if !known.scenes.iter().any(|scene| matches(glob, scene)) {
                    unused.never.push(format!(
                        "{}: no scene is called `{pattern}`; correct or drop it, or name its suite in the run",
                        table.place
                    ));
                }
            }
            let level = table.level.as_deref().is_none_or(|level| level == known.level);
            let backend = table.backends.iter().any(|name| known.backends.contains(name));
            let scene = || known.planned.iter().any(|scene| table.scenes.iter().any(|(_, glob)| matches(glob, scene)));
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
        let full = format!("{suite}/{scene}");
        self.entries.iter().filter(move |entry| {
            entry.backend == backend
                && entry.level.as_deref().is_none_or(|wanted| wanted == level)
                && (entry.scenes.is_match(scene) || entry.scenes.is_match(&full))
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
