//! The tasks, backends, suites and expectations that every command uses.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::OnceLock;

use predicament_corpus::{Library, SceneDef, Suite, Vocabulary};
use predicament_engines::PREFIX;
use predicament_formats::CorpusError;
use predicament_oracle::roster::{self, BackendError, Roster};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_studies::Entry as Study;
use predicament_tasks::{AnyTask, Contestant, vocabulary, with_signs};

use crate::BackendList;
use crate::exit::Failure;

type Find = Box<dyn Fn(&str) -> Result<Box<dyn Contestant>, BackendError> + Send + Sync>;

/// The tasks of each backend that runs for some tasks only.
pub type Only = BTreeMap<String, BTreeSet<String>>;

/// The names given to `-b`, separated by commas or repeated.
pub fn each(names: &[String]) -> impl Iterator<Item = &str> {
    names.iter().flat_map(|names| names.split(',')).filter(|name| !name.is_empty())
}

/// The files of the engines given to `-b`, by backend name. With them another process finds the engines, also from
/// another folder.
pub fn engines(names: &[String]) -> Result<BTreeMap<String, String>, Failure> {
    engine_files(each(names))
}

fn engine_files<'n>(names: impl Iterator<Item = &'n str>) -> Result<BTreeMap<String, String>, Failure> {
    let mut files = BTreeMap::new();
    for engine in names.filter_map(|name| name.strip_prefix(PREFIX)) {
        let config = predicament_engines::find(engine).map_err(Failure::usage)?;
        let (name, file) = (format!("{PREFIX}{}", config.name), config.file.display().to_string());
        if let Some(other) = files.insert(name.clone(), file.clone()).filter(|other| *other != file) {
            return Err(Failure::usage(format!(
                "two engines are called `{name}`: {other} and {file}; rename one, or run one"
            )));
        }
    }
    Ok(files)
}

/// Additions to the tool besides backends and tasks.
#[derive(Default)]
pub struct Guests {
    /// Folders of suites.
    pub suites: Vec<PathBuf>,
    /// A file of expectations.
    pub expected: Option<PathBuf>,
    /// Studies, in the order of the help.
    pub studies: Vec<Study>,
    /// Sections of reports that do not belong to a task.
    pub sections: Vec<ReportSection>,
}

/// A section of a report, made from the reported runs; `None` if they have no rows for it.
pub type ReportSection = fn(&[RunDir]) -> Result<Option<Section>, predicament_records::Error>;

/// The tasks, backends and suites of the tool.
pub struct Tool {
    tasks: Vec<&'static dyn AnyTask>,
    vocabulary: Vocabulary,
    own_backends: Vec<String>,
    find: Find,
    guests: Guests,
    library: OnceLock<Result<Library, CorpusError>>,
}

impl Tool {
    pub fn new<B: BackendList, T: Roster>(backends: B, list: &T, guests: Guests) -> Tool {
        let tasks = with_signs(list);
        let vocabulary = vocabulary(&tasks);
        let own_backends = backends.names();
        let list = list.clone();
        let find: Find = Box::new(move |name| backends.find(name, &list).map_or_else(|| list.backend(name), Ok));
        Tool { tasks, vocabulary, own_backends, find, guests, library: OnceLock::new() }
    }

    /// The file of expectations that was added to the tool, if any.
    pub fn expected(&self) -> Option<&PathBuf> {
        self.guests.expected.as_ref()
    }

    /// The studies, in the order of the help.
    pub fn studies(&self) -> &[Study] {
        &self.guests.studies
    }

    /// All tasks: those that ask for signs, then the systems and added tasks.
    pub fn tasks(&self) -> &[&'static dyn AnyTask] {
        &self.tasks
    }

    /// The task with this name.
    ///
    /// # Panics
    /// If there is no such task. This can't happen for suites, which are read with this tool's vocabulary.
    pub fn task(&self, name: &str) -> &'static dyn AnyTask {
        let task = self.tasks.iter().copied().find(|task| task.name() == name);
        task.unwrap_or_else(|| panic!("no task is called `{name}`"))
    }

    /// The vocabulary of the tasks, for reading suites.
    pub fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// The tables of all tasks.
    pub fn tables(&self) -> Vec<TableSpec> {
        let mut tables: Vec<TableSpec> = Vec::new();
        for table in self.tasks.iter().flat_map(|task| task.own_tables()) {
            if !tables.contains(&table) {
                tables.push(table);
            }
        }
        tables
    }

    /// The sections of all tasks, each once.
    pub fn sections(&self, runs: &[RunDir]) -> Result<Vec<Section>, predicament_records::Error> {
        let mut sections: Vec<Section> = Vec::new();
        for task in &self.tasks {
            if let Some(section) = task.own_section(runs)?
                && sections.iter().all(|other| other.id != section.id)
            {
                sections.push(section);
            }
        }
        for section in &self.guests.sections {
            sections.extend(section(runs)?);
        }
        Ok(sections)
    }

    /// The backend with this name.
    pub fn backend(&self, name: &str) -> Result<Box<dyn Contestant>, String> {
        (self.find)(name).map_err(|why| match self.own_backends.as_slice() {
            [] => why.to_string(),
            own => format!("{why}, or one of this tool's own: {}", own.join(", ")),
        })
    }

    /// True if there is a backend with this name. No backend is started.
    pub fn knows_backend(&self, name: &str) -> bool {
        self.own_backends.iter().any(|own| own == name) || roster::knows(name)
    }

    /// True if a backend was added by the crate that built the tool.
    pub fn is_foreign(&self, name: &str) -> bool {
        self.own_backends.iter().any(|own| own == name)
    }

    /// The backends named by `-b`, or all that run by default, each once.
    pub fn pick(&self, names: &[String]) -> Result<Vec<Box<dyn Contestant>>, Failure> {
        let default = || self.own_backends.iter().map(String::as_str).chain(roster::DEFAULT.iter().copied());
        let names: Vec<&str> = if names.is_empty() { default().collect() } else { each(names).collect() };
        engine_files(names.iter().copied())?;
        let mut picked: Vec<Box<dyn Contestant>> = Vec::new();
        for name in names {
            let backend = self.backend(name).map_err(Failure::usage)?;
            if picked.iter().all(|other| other.name() != backend.name()) {
                picked.push(backend);
            }
        }
        if picked.is_empty() {
            return Err(Failure::nothing("no backend is selected; name one with -b"));
        }
        Ok(picked)
    }

    /// The backends of a run over these scenes, and the tasks of each backend that runs for some tasks only.
    ///
    /// Without `-b` they are the default backends and, if a scene has two meshes, those that move a mesh as a whole.
    pub fn pick_for(
        &self,
        names: &[String],
        scenes: &[&SceneDef],
    ) -> Result<(Vec<Box<dyn Contestant>>, Only), Failure> {
        let mut picked = self.pick(names)?;
        let mut only = Only::new();
        let has_two = |name: &&str| self.task(name).is_on_two_meshes();
        let tasks: BTreeSet<String> =
            scenes.iter().map(|scene| scene.task).filter(has_two).map(str::to_owned).collect();
        if names.is_empty() && !tasks.is_empty() {
            for &name in roster::ON_TWO_MESHES {
                picked.push(self.backend(name).map_err(Failure::usage)?);
                only.insert(name.to_owned(), tasks.clone());
            }
        }
        Ok((picked, only))
    }

    /// The built-in backends that the plan has not and `-b` would add; empty if `-b` names backends.
    pub fn left_out(&self, names: &[String], only: &Only) -> Vec<String> {
        let more: &[&str] = if names.is_empty() { roster::MORE } else { &[] };
        more.iter().filter(|&&name| !only.contains_key(name)).map(|&name| name.to_owned()).collect()
    }

    /// The help for the values of `-b`.
    pub fn backend_help(&self) -> String {
        let own = self.own_backends.iter().map(|name| format!("{name:<23} of this tool\n"));
        own.chain([roster::HELP.to_owned()]).collect()
    }

    /// The embedded library of suites.
    pub fn library(&self) -> Result<&Library, CorpusError> {
        self.library.get_or_init(|| Library::embedded(&self.vocabulary)).as_ref().map_err(Clone::clone)
    }

    /// The suites of the added folders, in the order of folders and names.
    pub fn own_suites(&self) -> Result<Vec<Suite>, CorpusError> {
        let mut suites = Vec::new();
        for folder in &self.guests.suites {
            suites.extend(Library::from_dir(&self.vocabulary, folder)?.suites()?.iter().cloned());
        }
        Ok(suites)
    }
}
