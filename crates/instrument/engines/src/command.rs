//! Maintenance commands of an engine: install, build, clean, and print the version.

use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;

use crate::group::Group;
use crate::{Config, EngineError, EngineFailure};

/// The maximum number of bytes read of a version command's output.
const MOST_BYTES: u64 = 4096;

/// A maintenance step of an engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Step {
    /// Installs the library behind the engine.
    Install,
    /// Builds the engine.
    Build,
    /// Removes the build outputs.
    Clean,
}

/// Runs the commands of a step in turn, in the engine's folder; `tell` is called with each before it starts.
///
/// # Errors
/// [`EngineError`] with the engine, its file, the first command that fails, and the last lines that the command
/// printed.
pub fn chore(config: &Config, step: Step, mut tell: impl FnMut(&str)) -> Result<(), EngineError> {
    let commands = match step {
        Step::Install => &config.install,
        Step::Build => &config.build,
        Step::Clean => &config.clean,
    };
    for words in commands {
        let shown = words.join(" ");
        tell(&shown);
        let mut command = command(config, words).map_err(|why| config.error(why))?;
        let output = command.output();
        let output =
            output.map_err(|error| config.error(EngineFailure::NotStarted { command: shown.clone(), error }))?;
        if !output.status.success() {
            let said = [output.stdout, output.stderr].concat();
            let said = String::from_utf8_lossy(&said);
            let lines: Vec<&str> = said.lines().filter(|line| !line.trim().is_empty()).collect();
            let last = lines[lines.len().saturating_sub(8)..].join("\n  ");
            return Err(config.error(EngineFailure::Command { command: shown, status: output.status, said: last }));
        }
    }
    Ok(())
}

/// The first line that the engine's version command prints; `None` if it has no such command. The command may take as
/// long as the engine's silence limit, and only as much of its output is read as a line may have.
pub(crate) fn version(config: &Config) -> Result<Option<String>, EngineFailure> {
    if config.version.is_empty() {
        return Ok(None);
    }
    let shown = config.version.join(" ");
    let mut command = command(config, &config.version)?;
    command.stdout(Stdio::piped()).stderr(Stdio::null());
    let group = Group::start(&mut command, config.memory());
    let mut group = group.map_err(|error| EngineFailure::NotStarted { command: shown.clone(), error })?;
    let (tell, told) = channel();
    if let Some(stdout) = group.child.stdout.take() {
        std::thread::spawn(move || {
            let lines = BufReader::new(stdout.take(MOST_BYTES)).lines().map_while(Result::ok);
            let line = lines.map(|line| printable(&line)).find(|line| !line.is_empty());
            let _ = tell.send(line);
        });
    }
    let line = told.recv_timeout(config.silence());
    drop(group);
    match line {
        Ok(Some(line)) => Ok(Some(line)),
        Ok(None) => Err(EngineFailure::NoVersion { command: shown }),
        Err(_) => Err(EngineFailure::SilentVersion { command: shown, silence: config.silence() }),
    }
}

/// A text that is safe to print on one line: control characters escaped, long texts truncated.
pub(crate) fn printable(text: &str) -> String {
    const MOST: usize = 300;
    let text = text.trim();
    let mut printed = String::new();
    for c in text.chars().take(MOST) {
        if c.is_control() { printed.extend(c.escape_default()) } else { printed.push(c) }
    }
    if text.chars().nth(MOST).is_some() {
        printed.push('…');
    }
    printed
}

/// A command in the engine's folder with its environment. A program given as a path is relative to that folder.
pub(crate) fn command(config: &Config, words: &[String]) -> Result<Command, EngineFailure> {
    let [program, args @ ..] = words else {
        return Err(EngineFailure::NoProgram);
    };
    let path = Path::new(program);
    let program: PathBuf = if program.contains(['/', '\\']) { config.folder.join(path) } else { path.to_owned() };
    let mut command = Command::new(program);
    command.args(args).current_dir(&config.folder).envs(&config.environment).stdin(Stdio::null());
    Ok(command)
}
