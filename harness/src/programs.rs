//! Decides which of the engines that a folder names may be started.
//!
//! Folders of runs, shrinks and hunts are passed on to other people. If a folder could say what is started, reading it
//! would run a stranger's command. Therefore a folder only names an engine. The program is one that the user names on
//! the command line, or the engine of that name in the user's own folder of engines. The latter must be the same
//! engine: the digest of its `engine.toml` and the version of its library must match the recorded ones.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use predicament_engines::{Config, FOLDER, PREFIX};
use predicament_formats::hex;
use predicament_records::EngineFile;
use predicament_tasks::Contestant;
use sha2::{Digest, Sha256};

use crate::exit::Failure;
use crate::out::word;
use crate::tool::{Tool, each};

/// The engines that the command line names for a folder.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct Programs {
    /// The program of an engine that the folder names, as its name and its engine.toml. Otherwise only engines of your
    /// own engines folder are started, and only if they have not changed
    #[arg(long = "engine", value_name = "NAME=FILE")]
    engines: Vec<String>,

    /// Engines that the command line names without their files, as `-b` does.
    #[arg(skip)]
    typed: BTreeSet<String>,
}

/// The engines that a file records.
#[derive(Clone, Copy)]
pub struct Recorded<'a> {
    /// The file: a plan, or the state of a shrink or a hunt.
    pub file: &'a Path,
    /// The folder that the file came with, or `None` if it came alone.
    pub folder: Option<&'a Path>,
    /// The recorded files and versions, by backend name.
    pub engines: &'a BTreeMap<String, EngineFile>,
}

/// Backends that a folder names, ready to answer.
pub struct Picked {
    /// The backends, in the order of their names in the folder.
    pub backends: Vec<Box<dyn Contestant>>,
    /// The `engine.toml` of each engine, by backend name.
    pub files: BTreeMap<String, String>,
}

impl Picked {
    /// The records of its engines, for a file that names them.
    pub fn recorded(&self) -> Result<BTreeMap<String, EngineFile>, Failure> {
        record(self.files.clone(), &self.backends)
    }
}

impl Programs {
    /// Adds the engines that `-b` or a similar option names; also returns all these names as a plan writes them.
    pub fn and_named(mut self, backends: &[String]) -> Result<(Programs, Vec<String>), Failure> {
        let mut names = Vec::new();
        for argument in each(backends) {
            match argument.strip_prefix(PREFIX) {
                Some(file) if is_file(file) => {
                    let config = predicament_engines::find(file).map_err(Failure::usage)?;
                    names.push(format!("{PREFIX}{}", config.name));
                    let [name, file] = [&config.name, file].map(|text| predicament_engines::split(text).0);
                    self.engines.push(format!("{name}={file}"));
                }
                engine => {
                    names.push(argument.to_owned());
                    self.typed.extend(engine.map(ToOwned::to_owned));
                }
            }
        }
        Ok((self, names))
    }

    /// The backends that a folder names, given its records of engines.
    ///
    /// # Errors
    /// If a backend does not exist, or is an engine that the user has not named; the message has the option that would
    /// start it.
    pub fn pick(&self, tool: &Tool, names: &[String], recorded: Recorded<'_>) -> Result<Picked, Failure> {
        let mut files = BTreeMap::new();
        let mut arguments = Vec::new();
        for name in names {
            arguments.push(match name.strip_prefix(PREFIX) {
                None => name.clone(),
                Some(engine) => {
                    let config = self.config(engine, recorded)?;
                    let file = config.file.display().to_string();
                    files.insert(name.clone(), file.clone());
                    let settings = predicament_engines::split(engine).1.map(|settings| format!(":{settings}"));
                    format!("{PREFIX}{file}{}", settings.unwrap_or_default())
                }
            });
        }
        let mut backends: Vec<Box<dyn Contestant>> = Vec::new();
        for (name, argument) in names.iter().zip(&arguments) {
            let backend = tool.backend(argument).map_err(Failure::usage)?;
            if backend.name() != *name {
                let message = format!("it names `{name}`, which is now `{}`; start again", backend.name());
                return Err(refused(recorded.file, &message));
            }
            self.same_version(backend.as_ref(), recorded)?;
            if backends.iter().all(|other| other.name() != backend.name()) {
                backends.push(backend);
            }
        }
        Ok(Picked { backends, files })
    }

    /// The configuration of an engine: from the file that the command line names, or from the user's own folder of
    /// engines.
    fn config(&self, engine: &str, recorded: Recorded<'_>) -> Result<Config, Failure> {
        let Recorded { file, folder: with, engines } = recorded;
        let (engine, then) = (predicament_engines::split(engine).0, engines.get(&format!("{PREFIX}{engine}")));
        if let Some(place) = self.place(engine)? {
            let config = Config::read(&place).map_err(Failure::usage)?;
            if config.name != engine {
                let message =
                    format!("--engine {engine}={}: the engine there is called `{}`", place.display(), config.name);
                return Err(Failure::usage(format!("{message}; use that name, or change it back")));
            }
            return Ok(config);
        }
        let was = then.map_or("FILE", |then| &then.file);
        let cure = format!("if that is the program you mean, add --engine {}", word(&format!("{engine}={was}")));
        let refuse = |why: String| refused(file, &format!("it names the engine `{engine}`, and {why}; {cure}"));
        let is_named = self.typed.iter().any(|typed| predicament_engines::split(typed).0 == engine);
        let folder = predicament_engines::folder();
        let own = folder.join(engine).join(predicament_engines::FILE);
        if is_file(engine) || !own.is_file() {
            let folder = folder.display();
            return Err(refuse(format!(
                "the tool starts a program only if you name it, and {folder} has no such engine"
            )));
        }
        if with.is_some_and(|with| is_within(&folder, with)) {
            return Err(refuse(format!(
                "{} is in the same folder, so it may not be yours; set ${FOLDER}",
                folder.display()
            )));
        }
        let config = Config::read(&own).map_err(Failure::usage)?;
        let bytes = std::fs::read(&own).map_err(Failure::io(&own))?;
        let is_same = then.is_some_and(|then| hex(&Sha256::digest(&bytes)) == then.sha256);
        if config.name != engine || !is_same && !is_named {
            return Err(refuse(format!("{} has changed since", own.display())));
        }
        Ok(config)
    }

    /// The file that the command line names for an engine.
    fn place(&self, engine: &str) -> Result<Option<PathBuf>, Failure> {
        let mut place = None;
        for named in &self.engines {
            let Some((name, file)) = named.split_once('=') else {
                let message = format!("--engine {named}: write its name, `=` and its engine.toml");
                return Err(Failure::usage(format!("{message}, as in --engine mine=mine/engine.toml")));
            };
            if name.strip_prefix(PREFIX).unwrap_or(name) == engine {
                let file = Path::new(file);
                place = Some(if file.is_dir() { file.join(predicament_engines::FILE) } else { file.to_owned() });
            }
        }
        Ok(place)
    }

    /// Refuses an engine whose version has changed, unless the command line names it.
    fn same_version(&self, backend: &dyn Contestant, recorded: Recorded<'_>) -> Result<(), Failure> {
        let name = backend.name();
        let Some(engine) = name.strip_prefix(PREFIX) else { return Ok(()) };
        let (now, then) = (backend.version(), recorded.engines.get(&name).and_then(|then| then.version.clone()));
        if now == then || self.typed.contains(engine) || self.place(predicament_engines::split(engine).0)?.is_some() {
            return Ok(());
        }
        let told =
            |version: Option<String>| version.map_or_else(|| "unknown".to_owned(), |version| format!("`{version}`"));
        let message = format!("the version of {name} was {} then, and is {} now", told(then), told(now));
        Err(refused(recorded.file, &format!("{message}; restore it, or name the engine by --engine {engine}=FILE")))
    }
}

/// The records of the engines that the command line names, for a plan.
pub fn recorded(names: &[String], backends: &[Box<dyn Contestant>]) -> Result<BTreeMap<String, EngineFile>, Failure> {
    record(crate::tool::engines(names)?, backends)
}

fn record(
    files: BTreeMap<String, String>,
    backends: &[Box<dyn Contestant>],
) -> Result<BTreeMap<String, EngineFile>, Failure> {
    let record = |(name, file): (String, String)| {
        let bytes = std::fs::read(&file).map_err(Failure::io(Path::new(&file)))?;
        let version = backends.iter().find(|backend| backend.name() == name).and_then(|backend| backend.version());
        Ok((name, EngineFile { file, sha256: hex(&Sha256::digest(&bytes)), version }))
    };
    files.into_iter().map(record).collect()
}

/// True if an engine is given by its file, not by its name.
fn is_file(engine: &str) -> bool {
    engine.ends_with(".toml") || engine.contains(['/', '\\'])
}

/// True if a path is a folder or is inside it.
pub fn is_within(path: &Path, folder: &Path) -> bool {
    let canonical = |path: &Path| std::fs::canonicalize(path).ok();
    canonical(path).zip(canonical(folder)).is_some_and(|(path, folder)| path.starts_with(folder))
}

fn refused(file: &Path, why: &str) -> Failure {
    Failure::usage(format!("{}: {why}", file.display()))
}
