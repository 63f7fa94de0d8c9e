//! `engine.toml`: how an engine is installed, built and run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Deserialize;

/// The file that makes a folder an engine.
const FILE: &str = "engine.toml";
/// The variable that names the folder of engines.
const FOLDER: &str = "PREDICAMENT_ENGINES";
/// A configuration is a few lines.
const MOST_BYTES: u64 = 1 << 20;
/// Seconds of silence after which a process is ended, where the file does not say.
const SILENCE: u64 = 60;

/// The configuration of one engine.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The name; reports call the engine `engine:NAME`.
    pub name: String,
    /// What it is, in one line.
    #[serde(default)]
    pub about: String,
    /// The licence of the library behind it.
    #[serde(default)]
    pub licence: String,
    /// What has to be installed, as a person would type it.
    #[serde(default)]
    pub needs: String,
    /// The command whose first line of output is the library's version.
    #[serde(default)]
    pub version: Vec<String>,
    /// Commands that install the library.
    #[serde(default)]
    pub install: Vec<Vec<String>>,
    /// Commands that build the engine.
    #[serde(default)]
    pub build: Vec<Vec<String>>,
    /// The command that starts it.
    pub run: Vec<String>,
    /// Commands that remove what was built.
    #[serde(default)]
    pub clean: Vec<Vec<String>>,
    /// Variables that all commands get.
    #[serde(default)]
    pub environment: BTreeMap<String, String>,
    /// Seconds of silence after which the process is ended.
    timeout: Option<u64>,
    /// The folder of the file: all commands run there.
    #[serde(skip)]
    pub folder: PathBuf,
    /// The file itself, absolute: [`find`] finds the engine by it from any folder.
    #[serde(skip)]
    pub file: PathBuf,
}

impl Config {
    /// The configuration in a file such as `engine.toml`.
    ///
    /// # Errors
    /// One line that names the file, the line and the cure.
    pub fn read(file: &Path) -> Result<Config, String> {
        let shown = file.display();
        let found = std::fs::metadata(file).map_err(|error| format!("{shown}: {error}"))?;
        if !found.is_file() || found.len() > MOST_BYTES {
            return Err(format!("{shown}: it is no regular file of at most {MOST_BYTES} bytes"));
        }
        let text = std::fs::read_to_string(file).map_err(|error| format!("{shown}: {error}"))?;
        let line_of = |at: usize| text[..at.min(text.len())].matches('\n').count() + 1;
        let mut config: Config = toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(span.start));
            format!("{shown}:{line}: {}; see docs/ENGINES.md for the keys", error.message().replace('\n', " "))
        })?;
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
        if config.name.is_empty() || !config.name.chars().all(plain) {
            return Err(format!("{shown}: the name `{}`; use letters, digits, `-`, `_` and `.`", config.name));
        }
        if config.run.is_empty() {
            return Err(format!("{shown}: `run` is empty; write the command that starts the engine"));
        }
        if config.timeout == Some(0) {
            return Err(format!("{shown}: `timeout` is 0; write the seconds of silence to wait for"));
        }
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        config.folder = std::path::absolute(folder).map_err(|error| format!("{shown}: {error}"))?;
        config.file = std::path::absolute(file).map_err(|error| format!("{shown}: {error}"))?;
        Ok(config)
    }

    /// The silence after which the process is ended.
    #[must_use]
    pub fn silence(&self) -> Duration {
        Duration::from_secs(self.timeout.unwrap_or(SILENCE))
    }
}

/// The folder of engines: `$PREDICAMENT_ENGINES`, or `engines`.
fn folder() -> PathBuf {
    std::env::var_os(FOLDER).map_or_else(|| PathBuf::from("engines"), PathBuf::from)
}

/// The engine with this name in the folder of engines, or with this file.
///
/// # Errors
/// One line with the engines that there are, or what is wrong with the file.
pub fn find(name: &str) -> Result<Config, String> {
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
        return Config::read(&file);
    }
    let names: Vec<String> = all().into_iter().flatten().map(|config| config.name).collect();
    let there = if names.is_empty() { "there is none".to_owned() } else { format!("there are {}", names.join(", ")) };
    Err(format!(
        "no engine is called `{name}` in {}: {there}; name one, its {FILE}, or set ${FOLDER}",
        folder.display()
    ))
}

/// The engines of the folder of engines, by the names of their folders; for each an error where its file is wrong.
#[must_use]
pub fn all() -> Vec<Result<Config, String>> {
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
        Config::read(&file).map_err(|error| error.replace(&file.display().to_string(), "F"))
    }

    #[test]
    fn a_name_and_a_command_are_enough() {
        let config = read("name = \"mine\"\nrun = [\"./engine\", \"--fast\"]\n").unwrap();
        assert_eq!((config.name.as_str(), config.run.len()), ("mine", 2));
        assert_eq!(config.silence(), Duration::from_secs(60));
        assert!(config.folder.is_absolute());
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        for (text, said) in [
            ("name = \"a\"\nruns = [\"b\"]\n", "F:2: unknown field `runs`, expected one of"),
            ("name = \"a\"\n", "F:1: missing field `run`; see docs/ENGINES.md for the keys"),
            ("name = \"a\"\nrun = []\n", "F: `run` is empty; write the command that starts the engine"),
            ("name = \"a b\"\nrun = [\"c\"]\n", "F: the name `a b`; use letters"),
            ("name = \"a\"\nrun = [\"c\"]\ntimeout = 0\n", "F: `timeout` is 0; write"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.starts_with(said), "{error}");
        }
    }
}
