//! The configuration `engine.toml`: how to install, build and run an engine.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::parameter::{self, Parameter};
use crate::{EngineError, EngineFailure};
use predicament_formats::{CorpusError, Document, Field, Fields, TableKind, shown};

/// The name of the file that makes a folder an engine.
pub const FILE: &str = "engine.toml";
/// The environment variable with the folder of engines.
pub const FOLDER: &str = "PREDICAMENT_ENGINES";
/// The maximum size of a configuration file.
pub(crate) const MOST_BYTES: u64 = 1 << 20;
/// The default silence limit in seconds, after which a process is ended.
const SILENCE: u64 = 60;
/// The maximum silence limit in seconds: eleven days.
const MOST_SILENCE: u64 = 1_000_000;
/// The default memory limit of each engine process, in MiB.
const MEMORY: u64 = 4096;
/// The maximum memory limit in MiB: an exbibyte.
const MOST_MEMORY: u64 = 1 << 40;
/// The maximum length of a name, in characters: names appear in tables, legends and file names.
const LONGEST_NAME: usize = 64;
/// The maximum length of the other texts, in characters: each is a line.
pub(crate) const LONGEST_TEXT: usize = 200;

static ENGINE: TableKind = TableKind::new(
    "configuration",
    &[
        "name",
        "about",
        "licence",
        "needs",
        "version",
        "install",
        "build",
        "run",
        "clean",
        "environment",
        "parameters",
        "timeout",
        "memory",
    ],
);

/// The configuration of one engine.
#[derive(Clone, PartialEq, Debug)]
pub struct Config {
    /// The engine's name; reports call it `engine:NAME`.
    pub name: String,
    /// A one-line description.
    pub about: String,
    /// The licence of the library behind it.
    pub licence: String,
    /// The software that must be installed, as a command a person would type.
    pub needs: String,
    /// The command whose first line of output is the library's version.
    pub version: Vec<String>,
    /// Commands that install the library.
    pub install: Vec<Vec<String>>,
    /// Commands that build the engine.
    pub build: Vec<Vec<String>>,
    /// The command that starts the engine.
    pub run: Vec<String>,
    /// Commands that remove the build outputs.
    pub clean: Vec<Vec<String>>,
    /// Environment variables of all commands.
    pub environment: BTreeMap<String, String>,
    /// The parameters that a backend's name can set.
    pub parameters: Vec<Parameter>,
    /// The silence limit in seconds, after which the process is ended.
    timeout: u64,
    /// The memory limit of each engine process, in MiB; 0 for no limit.
    memory: u64,
    /// The absolute path of the file: [`find`] finds the engine by it from any folder.
    pub file: PathBuf,
    /// The folder of the file, in which all commands run.
    pub folder: PathBuf,
}

impl Config {
    /// Reads the configuration in a file such as `engine.toml`.
    ///
    /// # Errors
    /// [`EngineError`] with the file, the line and the fix.
    pub fn read(file: &Path) -> Result<Config, EngineError> {
        let shown = file.display().to_string();
        let unread = |error| EngineError::Unread { file: file.to_owned(), error };
        let found = std::fs::metadata(file).map_err(unread)?;
        if !found.is_file() || found.len() > MOST_BYTES {
            return Err(EngineError::NotAFile { file: file.to_owned() });
        }
        let text = std::fs::read_to_string(file).map_err(unread)?;
        let mut config = parse(&shown, &text).map_err(EngineError::Config)?;
        config.file = std::path::absolute(file).map_err(unread)?;
        config.folder = config.file.parent().unwrap_or(Path::new(".")).to_owned();
        Ok(config)
    }

    /// An error about this engine, with its name and its file.
    #[must_use]
    pub(crate) fn error(&self, why: EngineFailure) -> EngineError {
        EngineError::Failed { name: self.name.clone(), file: self.file.clone(), why }
    }

    /// The silence limit after which the process is ended.
    #[must_use]
    pub fn silence(&self) -> Duration {
        Duration::from_secs(self.timeout)
    }

    /// The memory limit of each engine process, in MiB; `None` for no limit.
    #[must_use]
    pub fn memory(&self) -> Option<u64> {
        (self.memory > 0).then_some(self.memory)
    }
}

/// Reads the text of an `engine.toml`.
fn parse(file: &str, text: &str) -> Result<Config, CorpusError> {
    let document = Document::new(file, text);
    let root = document.parse()?;
    let fields = Fields::new(&document, &ENGINE, root.get_ref(), 0);
    let config = Config {
        name: name(&fields.required("name")?)?,
        about: line(&fields, "about")?,
        licence: line(&fields, "licence")?,
        needs: line(&fields, "needs")?,
        version: fields.get("version").map_or(Ok(Vec::new()), |words| command(&words))?,
        install: commands(&fields, "install")?,
        build: commands(&fields, "build")?,
        run: command(&fields.required("run")?)?,
        clean: commands(&fields, "clean")?,
        environment: environment(&fields)?,
        parameters: match fields.get("parameters") {
            Some(field) => field.entries()?.iter().map(parameter::read).collect::<Result<_, _>>()?,
            None => Vec::new(),
        },
        timeout: fields.integer_or("timeout", SILENCE, 1..=MOST_SILENCE)?,
        memory: fields.integer_or("memory", MEMORY, 0..=MOST_MEMORY)?,
        file: PathBuf::new(),
        folder: PathBuf::new(),
    };
    fields.finish()?;
    Ok(config)
}

/// The rule for names of engines, as a cure.
pub const NAME_RULE: &str = "use up to 64 letters, digits, `-`, `_` and `.`, a letter or digit first";

/// Returns true if a text can be the name of an engine: names are safe in tables, on command lines and in file names.
#[must_use]
pub fn is_name(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    let fits = text.len() <= LONGEST_NAME && text.starts_with(|c: char| c.is_ascii_alphanumeric());
    fits && text.chars().all(plain)
}

/// The name of the engine.
fn name(field: &Field<'_, '_>) -> Result<String, CorpusError> {
    let name = field.str()?;
    if is_name(name) {
        return Ok(name.to_owned());
    }
    Err(field.error(format!("`{}` is not a valid name of an engine", shown(name)), NAME_RULE))
}

/// Reads a line of text; empty if the key is missing.
fn line(fields: &Fields<'_, '_>, key: &'static str) -> Result<String, CorpusError> {
    let Some(field) = fields.get(key) else { return Ok(String::new()) };
    let text = field.string()?;
    if text.chars().any(char::is_control) || text.chars().nth(LONGEST_TEXT).is_some() {
        let message = format!("`{key}` is longer than {LONGEST_TEXT} characters, or has a line break or the like");
        return Err(field.error(message, "write one short line"));
    }
    Ok(text)
}

/// Reads a program and its arguments.
fn command(field: &Field<'_, '_>) -> Result<Vec<String>, CorpusError> {
    const WANTED: &str = "a command as an array of words: the program, then its arguments";
    let words = field.items(WANTED)?.map(|word| {
        let text = word.string()?;
        if text.contains('\0') { Err(word.error("a word with a NUL", "remove the NUL")) } else { Ok(text) }
    });
    let words = words.collect::<Result<Vec<_>, _>>()?;
    if words.first().is_none_or(String::is_empty) {
        return Err(
            field.error(format!("`{}` has a command without a program", field.key()), format!("write {WANTED}"))
        );
    }
    Ok(words)
}

/// Reads a list of commands, which run in turn.
fn commands(fields: &Fields<'_, '_>, key: &'static str) -> Result<Vec<Vec<String>>, CorpusError> {
    let Some(field) = fields.get(key) else { return Ok(Vec::new()) };
    field.items("an array of commands, each an array of words")?.map(|words| command(&words)).collect()
}

/// Reads environment variables.
fn environment(fields: &Fields<'_, '_>) -> Result<BTreeMap<String, String>, CorpusError> {
    let Some(field) = fields.get("environment") else { return Ok(BTreeMap::new()) };
    let variable = |value: Field<'_, '_>| {
        let (key, text) = (value.key(), value.string()?);
        if key.is_empty() || key.contains(['=', '\0']) {
            let message = format!("`{}` is not a valid name of a variable", shown(key));
            return Err(value.error(message, "write a name without `=`, as in { OMP_NUM_THREADS = \"1\" }"));
        }
        if text.contains('\0') {
            return Err(value.error(format!("the variable `{}` has a NUL", shown(key)), "remove the NUL"));
        }
        Ok((key.to_owned(), text))
    };
    field.entries()?.into_iter().map(variable).collect()
}

/// The folder of engines: `$PREDICAMENT_ENGINES`, or `engines`.
#[must_use]
pub fn folder() -> PathBuf {
    std::env::var_os(FOLDER).map_or_else(|| PathBuf::from("engines"), PathBuf::from)
}

/// The configuration of the engine with this name in the folder of engines, or with this file; `:key=value` after it
/// sets a parameter.
///
/// # Errors
/// [`EngineError`] with the known engines, or with the error in the file.
pub fn find(name: &str) -> Result<Config, EngineError> {
    let (name, settings) = parameter::split(name);
    let config = found(name)?;
    match settings {
        Some(settings) => config.with_settings(settings),
        None => Ok(config),
    }
}

/// The configuration of the engine with this name or file, without settings.
fn found(name: &str) -> Result<Config, EngineError> {
    let path = Path::new(name);
    if name.ends_with(".toml") {
        return Config::read(path);
    }
    if name.contains(['/', '\\']) {
        return Config::read(&path.join(FILE));
    }
    let folder = folder();
    let file = folder.join(name).join(FILE);
    if file.is_file() {
        let config = Config::read(&file)?;
        if config.name != name {
            // Reports would use a name that finds no engine, or another engine.
            return Err(EngineError::OtherName { file, called: config.name });
        }
        return Ok(config);
    }
    let known = all().into_iter().flatten().map(|config| config.name).collect();
    Err(EngineError::Unknown { name: name.to_owned(), folder, known })
}

/// The engines of the folder of engines, by the names of their folders; an invalid file gives an error in its place.
#[must_use]
pub fn all() -> Vec<Result<Config, EngineError>> {
    let Ok(entries) = std::fs::read_dir(folder()) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path().join(FILE)).collect();
    files.retain(|file| file.is_file());
    files.sort();
    files.iter().map(|file| Config::read(file)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Config, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(FILE);
        std::fs::write(&file, text).unwrap();
        Config::read(&file).map_err(|error| error.to_string().replace(&file.display().to_string(), "F"))
    }

    #[test]
    fn a_name_and_a_command_are_enough() {
        let config = read("name = \"mine\"\nrun = [\"./engine\", \"--fast\"]\n").unwrap();
        assert_eq!((config.name.as_str(), config.run.len()), ("mine", 2));
        assert_eq!(config.silence(), Duration::from_secs(60));
        assert_eq!(config.memory(), Some(4096));
        assert!(config.folder.is_absolute());
        let config = read("name = \"mine\"\nrun = [\"b\"]\nmemory = 0\n").unwrap();
        assert_eq!(config.memory(), None);
    }

    #[test]
    fn only_a_small_regular_file_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(FILE);
        std::fs::write(&file, " ".repeat(1 + usize::try_from(MOST_BYTES).unwrap())).unwrap();
        for place in [file.as_path(), folder.path()] {
            let error = Config::read(place).unwrap_err().to_string();
            assert!(
                error.ends_with("it is not a regular file of at most 1048576 bytes; name the engine.toml of an engine"),
                "{error}"
            );
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let long = "x".repeat(65);
        let about = "x".repeat(201);
        let long_name = format!("name = \"{long}\"\nrun = [\"b\"]\n");
        let long_about = format!("name = \"a\"\nrun = [\"b\"]\nabout = \"{about}\"\n");
        for (text, said) in [
            (
                "name = \"a\"\nruns = [\"b\"]\n",
                "F:2: a configuration has no key `runs`, and `run` is missing; correct the key",
            ),
            ("name = \"a\"\n", "F:1: configuration has no `run`; add `run = …`"),
            ("name = \"a\"\nrun = []\n", "F:2: `run` has a command without a program; write a command as an array"),
            ("name = \"a\"\nrun = [\"\"]\n", "F:2: `run` has a command without a program; write"),
            ("name = \"a\"\nrun = \"b\"\n", "F:2: `run` is of type string; write a command as an array of words"),
            ("name = \"a\"\nrun = [\"b\",\n3]\n", "F:3: `run` is of type integer; write a string"),
            ("name = \"a\"\nrun = [\"b\\u0000\"]\n", "F:2: a word with a NUL; remove"),
            ("name = \"a b\"\nrun = [\"c\"]\n", "F:1: `a b` is not a valid name of an engine; use up to 64 letters"),
            ("name = \"..\"\nrun = [\"c\"]\n", "F:1: `..` is not a valid name of an engine; use"),
            ("run = [\"c\"]\nname = 7\n", "F:2: `name` is of type integer; write a string"),
            (&long_name, "F:1: `xxx"),
            (&long_about, "F:3: `about` is longer than 200 characters, or has a line break or the like; write one"),
            ("name = \"a\"\nrun = [\"b\"]\nneeds = \"c\\nd\"\n", "F:3: `needs` is longer than 200 characters, or has"),
            ("name = \"a\"\nrun = [\"b\"]\nbuild = [\"make\"]\n", "F:3: `build` is of type string; write a command as"),
            ("name = \"a\"\nrun = [\"b\"]\nclean = [[]]\n", "F:3: `clean` has a command without a program; write"),
            ("name = \"a\"\nrun = [\"c\"]\ntimeout = 0\n", "F:3: `timeout` is 0; choose an integer from 1 to 1000000"),
            ("name = \"a\"\nrun = [\"c\"]\ntimeout = 1e9\n", "F:3: `timeout` is of type float; write an integer"),
            (
                "name = \"a\"\nrun = [\"c\"]\nmemory = -1\n",
                "F:3: `memory` is -1; choose an integer from 0 to 1099511627776",
            ),
            ("name = \"a\"\nrun = [\"c\"]\nenvironment = 1\n", "F:3: `environment` is of type integer; write a table"),
            (
                "name = \"a\"\nrun = [\"c\"]\n[environment]\nB = \"1\"\n\"\" = \"2\"\n",
                "F:5: `` is not a valid name of a variable; write a name without `=`",
            ),
            (
                "name = \"a\"\nrun = [\"c\"]\n[environment]\n\"A=B\" = \"2\"\n",
                "F:4: `A=B` is not a valid name of a variable; write a name without `=`",
            ),
            ("name = \"a\"\nrun = [\"c\"]\nenvironment = { A = 1 }\n", "F:3: `A` is of type integer; write a string"),
            ("name = \"a\"\nrun = [\"c\"]\nenvironment = { A = \"\\u0000\" }\n", "F:3: the variable `A` has a NUL"),
            ("name = \"a\"\nrun\n", "F:2: key with no value, expected `=`; correct the TOML"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.starts_with(said) && error.lines().count() == 1 && error.len() < 300, "{error}");
        }
    }
}
