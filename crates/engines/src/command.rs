//! Chores of an engine: to install, to build and to clean it, and to ask for its version.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Config;

/// A chore of an engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Step {
    /// Install the library behind it.
    Install,
    /// Build it.
    Build,
    /// Remove what was built.
    Clean,
}

/// Runs the commands of a chore in turn, in the engine's folder; `tell` hears each before it starts.
///
/// # Errors
/// The first command that fails, with the last lines that it printed.
pub fn chore(config: &Config, step: Step, mut tell: impl FnMut(&str)) -> Result<(), String> {
    let commands = match step {
        Step::Install => &config.install,
        Step::Build => &config.build,
        Step::Clean => &config.clean,
    };
    for words in commands {
        let shown = words.join(" ");
        tell(&shown);
        let output = command(config, words)?.output().map_err(|error| format!("`{shown}` did not start: {error}"))?;
        if !output.status.success() {
            let said = [output.stdout, output.stderr].concat();
            let said = String::from_utf8_lossy(&said);
            let lines: Vec<&str> = said.lines().filter(|line| !line.trim().is_empty()).collect();
            let last = lines[lines.len().saturating_sub(8)..].join("\n  ");
            return Err(format!("`{shown}` failed: {}\n  {last}", output.status));
        }
    }
    Ok(())
}

/// The first line that the engine's version command prints; none where it has no such command.
pub(crate) fn version(config: &Config) -> Result<Option<String>, String> {
    if config.version.is_empty() {
        return Ok(None);
    }
    let shown = config.version.join(" ");
    let output =
        command(config, &config.version)?.output().map_err(|error| format!("`{shown}` did not start: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    match text.lines().map(str::trim).find(|line| !line.is_empty()) {
        Some(line) if output.status.success() => Ok(Some(line.to_owned())),
        _ => Err(format!("`{shown}` printed no version: {}", output.status)),
    }
}

/// A command in the engine's folder with its environment. A program that is a path is one of that folder.
pub(crate) fn command(config: &Config, words: &[String]) -> Result<Command, String> {
    let [program, args @ ..] = words else {
        return Err(format!("{}: an empty command", config.name));
    };
    let path = Path::new(program);
    let program: PathBuf = if program.contains(['/', '\\']) { config.folder.join(path) } else { path.to_owned() };
    let mut command = Command::new(program);
    command.args(args).current_dir(&config.folder).envs(&config.environment).stdin(Stdio::null());
    Ok(command)
}
