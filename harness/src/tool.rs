//! The tasks, backends, suites and expectations that every command works with.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::OnceLock;

use predicament_corpus::{Library, Suite, Vocabulary};
use predicament_engines::PREFIX;
use predicament_formats::CorpusError;
use predicament_oracle::roster::{self, BackendError};
use predicament_records::{RunDir, TableSpec};
use predicament_report::Section;
use predicament_studies::Entry as Study;
use predicament_tasks::{AnyTask, Contestant, TaskList, vocabulary, with_signs};

use crate::BackendList;
use crate::exit::Failure;

type Find = Box<dyn Fn(&str) -> Result<Box<dyn Contestant>, BackendError> + Send + Sync>;

/// The names that `-b` was given: several with commas, or by repeating.
pub fn each(names: &[String]) -> impl Iterator<Item = &str> {
    names.iter().flat_map(|names| names.split(',')).filter(|name| !name.is_empty())
}

/// The files of the engines that `-b` was given, by the backends' names: from there they are found by another process,
/// and from another folder.
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

/// What the tool was told of besides backends and tasks.
#[derive(Default)]
pub struct Guests {
    /// Folders of suites.
    pub suites: Vec<PathBuf>,
    /// A file of expectations.
    pub expected: Option<PathBuf>,
    /// Studies, in the order of the help.
    pub studies: Vec<Study>,
    /// Sections of reports that are no task's.
    pub sections: Vec<ReportSection>,
}

/// A section of a report, made of the runs that the report is about; none where they have nothing for it.
pub type ReportSection = fn(&[RunDir]) -> Result<Option<Section>, predicament_records::Error>;

/// The tasks, backends and suites that the tool was put together from.
pub struct Tool {
    tasks: Vec<&'static dyn AnyTask>,
    vocabulary: Vocabulary,
    own_backends: Vec<String>,
    find: Find,
    guests: Guests,
    library: OnceLock<Result<Library, CorpusError>>,
}

impl Tool {
    pub fn new<B: BackendList, T: TaskList>(backends: B, list: &T, guests: Guests) -> Tool {
        let tasks = with_signs(list);
        let vocabulary = vocabulary(&tasks);
        let own_backends = backends.names();
        let list = list.clone();
        let find: Find =
            Box::new(move |name| backends.find(name, &list).map_or_else(|| roster::backend(name, &list), Ok));
        Tool { tasks, vocabulary, own_backends, find, guests, library: OnceLock::new() }
    }

    /// The file of expectations that the tool was told of, if any.
    pub fn expected(&self) -> Option<&PathBuf> {
        self.guests.expected.as_ref()
    }

    /// The studies, in the order of the help.
    pub fn studies(&self) -> &[Study] {
        &self.guests.studies
    }

    /// All tasks: those that ask for signs, then those that the tool was told of.
    pub fn tasks(&self) -> &[&'static dyn AnyTask] {
        &self.tasks
    }

    /// The task with this name.
    ///
    /// # Panics
    /// If there is none: suites were read with this tool's vocabulary.
    pub fn task(&self, name: &str) -> &'static dyn AnyTask {
        let task = self.tasks.iter().copied().find(|task| task.name() == name);
        task.unwrap_or_else(|| panic!("no task is called `{name}`"))
    }

    /// The tasks as suites know them.
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
            own => format!("{why}, and of this tool's own {}", own.join(", ")),
        })
    }

    /// Whether there is a backend with this name. None is started.
    pub fn knows_backend(&self, name: &str) -> bool {
        self.own_backends.iter().any(|own| own == name) || roster::knows(name)
    }

    /// Whether a backend is the tool's maker's own.
    pub fn is_foreign(&self, name: &str) -> bool {
        self.own_backends.iter().any(|own| own == name)
    }

    /// The backends named by `-b`, or all that run by default; each once.
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
            return Err(Failure::nothing("no backend is left; name one with -b"));
        }
        Ok(picked)
    }

    /// The house's backends that do not run where `-b` names none; nothing where it names some.
    pub fn left_out(&self, names: &[String]) -> Vec<String> {
        let more: &[&str] = if names.is_empty() { roster::MORE } else { &[] };
        more.iter().map(|&name| name.to_owned()).collect()
    }

    /// What can be written after `-b`.
    pub fn backend_help(&self) -> String {
        let own = self.own_backends.iter().map(|name| format!("{name:<23} of this tool\n"));
        own.chain([roster::HELP.to_owned()]).collect()
    }

    /// The embedded library.
    pub fn library(&self) -> Result<&Library, CorpusError> {
        self.library.get_or_init(|| Library::embedded(&self.vocabulary)).as_ref().map_err(Clone::clone)
    }

    /// The suites of the folders that the tool's maker named, in the order of folders and names.
    pub fn own_suites(&self) -> Result<Vec<Suite>, CorpusError> {
        let mut suites = Vec::new();
        for folder in &self.guests.suites {
            suites.extend(Library::from_dir(&self.vocabulary, folder)?.suites()?.iter().cloned());
        }
        Ok(suites)
    }
}
