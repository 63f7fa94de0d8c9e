//! Steps, which are commands shown with their duration, and the folders of commands.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Instant;

use crate::cpu;

/// The folder of the workspace.
pub fn root() -> PathBuf {
    // xtask lives in crates/xtask of the workspace that it serves.
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Makes a new, empty folder under the workspace's folder; returns the path as given.
pub fn fresh(dir: &str) -> Result<PathBuf, String> {
    let full = root().join(dir);
    if full.exists() {
        std::fs::remove_dir_all(&full).map_err(|error| format!("{}: {error}", full.display()))?;
    }
    std::fs::create_dir_all(&full).map_err(|error| format!("{}: {error}", full.display()))?;
    Ok(PathBuf::from(dir))
}

/// Cargo's target directory, from the environment or a configuration file.
pub fn target_directory() -> Result<PathBuf, String> {
    let output = Command::new(cargo_path())
        .args(["metadata", "--format-version", "1", "--no-deps"])
        .current_dir(root())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo metadata did not start: {error}"))?;
    target_of(&String::from_utf8_lossy(&output.stdout)).ok_or_else(|| "cargo metadata names no folder".to_owned())
}

/// The target directory in cargo's metadata.
fn target_of(metadata: &str) -> Option<PathBuf> {
    let (_, rest) = metadata.split_once("\"target_directory\":\"")?;
    let (path, _) = rest.split_once('"')?;
    Some(PathBuf::from(path.replace("\\\\", "\\")))
}

fn cargo_path() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

/// Returns true if the program can be run, and succeeds.
pub fn answers(program: &str, args: &[&str]) -> bool {
    let program = if program == "cargo" { cargo_path() } else { program.to_owned() };
    let ran =
        Command::new(program).args(args).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
    ran.is_ok_and(|status| status.success())
}

/// A command: a program and its arguments.
pub fn words(program: &str, args: &[&str]) -> Vec<String> {
    [program].iter().chain(args).map(|&word| word.to_owned()).collect()
}

/// A command of cargo.
pub fn cargo_command<S: AsRef<str>>(args: &[S]) -> Vec<String> {
    std::iter::once(cargo_path()).chain(args.iter().map(|word| word.as_ref().to_owned())).collect()
}

/// Runs cargo as a step.
///
/// # Errors
/// If it does not start, or fails.
pub fn cargo(what: &str, args: &[&str]) -> Result<(), String> {
    step(what, &cargo_command(args), &[])
}

/// Runs a command; prints its purpose and duration.
///
/// # Errors
/// If it does not start, or fails.
pub fn step(what: &str, words: &[String], env: &[(&str, String)]) -> Result<(), String> {
    step_ending(what, words, env, &[0])
}

/// Runs a command as [`step`] does, and accepts these exit codes.
pub fn step_ending(what: &str, words: &[String], env: &[(&str, String)], fine: &[i32]) -> Result<(), String> {
    println!("\n{}", title(what, words));
    let (start, cpu) = (Instant::now(), cpu::of_children());
    let status = command(words, env).status().map_err(not_started(what, words))?;
    ended(what, status.code().is_some_and(|code| fine.contains(&code)), &status.to_string(), start, cpu)
}

/// A step that runs beside others. It writes into a file, which is printed when it has ended.
pub struct Beside {
    what: String,
    title: String,
    log: PathBuf,
    child: Child,
    start: Instant,
}

impl Beside {
    /// Starts a command.
    ///
    /// # Errors
    /// If it does not start, or its file can't be written.
    pub fn start(what: &str, words: &[String], env: &[(&str, String)]) -> Result<Beside, String> {
        let log = target_directory()?.join(format!("{}.log", what.replace(' ', "-")));
        let file = File::create(&log).map_err(|error| format!("{}: {error}", log.display()))?;
        let both = file.try_clone().map_err(|error| format!("{}: {error}", log.display()))?;
        let child = command(words, env).stdin(Stdio::null()).stdout(file).stderr(both).spawn();
        let child = child.map_err(not_started(what, words))?;
        Ok(Beside { what: what.to_owned(), title: title(what, words), log, child, start: Instant::now() })
    }

    /// Waits for the command, prints what it wrote, and says how long it took.
    ///
    /// # Errors
    /// If it failed.
    pub fn finish(mut self) -> Result<(), String> {
        let cpu = cpu::of_children();
        let status = self.child.wait().map_err(|error| format!("{}: {error}", self.what))?;
        let log = std::fs::read(&self.log).map_err(|error| format!("{}: {error}", self.log.display()))?;
        println!("\n{}\n{}", self.title, String::from_utf8_lossy(&log));
        ended(&self.what, status.success(), &status.to_string(), self.start, cpu)
    }
}

/// Whatever fails first ends the chore, and leaves no process behind.
impl Drop for Beside {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn title(what: &str, words: &[String]) -> String {
    format!("== {what}: {} {}", name(words), words[1..].join(" "))
}

fn name(words: &[String]) -> String {
    Path::new(&words[0]).file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn command(words: &[String], env: &[(&str, String)]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]).envs(env.iter().map(|(name, value)| (name, value))).current_dir(root());
    command
}

fn not_started(what: &str, words: &[String]) -> impl FnOnce(std::io::Error) -> String {
    let text = format!("{what}: {} did not start", name(words));
    move |error| format!("{text}: {error}")
}

/// Says that a step has ended, with its time and the processor time of children since `cpu`.
pub fn ended(what: &str, is_fine: bool, status: &str, start: Instant, cpu: Option<f64>) -> Result<(), String> {
    if !is_fine {
        return Err(format!("{what} failed: {status}"));
    }
    let spent = cpu::of_children()
        .zip(cpu)
        .map_or(String::new(), |(after, before)| format!(" ({:.0} s of processor time)", after - before));
    println!("== {what}: ok, {:.0} s{spent}", start.elapsed().as_secs_f64());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_target_directory_is_read() {
        let metadata = r#"{"packages":[],"target_directory":"C:\\a\\target","version":1}"#;
        assert_eq!(target_of(metadata), Some(PathBuf::from(r"C:\a\target")));
        assert_eq!(target_of("{}"), None);
    }
}
