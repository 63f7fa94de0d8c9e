//! A command that regenerates the pages which commands of the tool print.
//!
//! Tests of the tool compare each page with its command.

use std::process::{Command, Stdio};

use crate::command::{cargo, root, target_directory};

/// The start of the part of BOUNDS that a search has found: it is not derived, and stays.
const FOUND: &str = "\n## Worst cases\n";

/// Writes `docs/CHECKS.md`, `docs/BOUNDS.md`, `docs/COMMANDS.md` and the schema in `docs/DATA.md`.
///
/// # Errors
/// If the tool can't be built, a command fails or a page can't be written.
pub fn write() -> Result<(), String> {
    cargo("build the tool", &["build", "--profile", "ci", "--package", "predicament"])?;
    page("docs/CHECKS.md", &printed(&["setup", "selftest", "--checks", "--format", "md"])?)?;
    let bounds = read("docs/BOUNDS.md")?;
    let (_, found) = bounds.split_once(FOUND).ok_or("docs/BOUNDS.md has no worst cases")?;
    page("docs/BOUNDS.md", &(printed(&["study", "bounds", "--format", "md"])? + FOUND + found))?;
    page("docs/COMMANDS.md", &printed(&["setup", "man", "--format", "md"])?)?;
    printed(&["data", "schema", "--splice", "docs/DATA.md"])?;
    println!("docs/DATA.md");
    Ok(())
}

/// The output of the tool.
fn printed(words: &[&str]) -> Result<String, String> {
    let tool = target_directory()?.join("ci").join("predicament");
    let ran = Command::new(&tool).args(words).current_dir(root()).stderr(Stdio::inherit()).output();
    let ran = ran.map_err(|error| format!("{}: {error}", tool.display()))?;
    let text =
        String::from_utf8(ran.stdout).map_err(|_| format!("`predicament {}` prints no text", words.join(" ")))?;
    if ran.status.success() { Ok(text) } else { Err(format!("`predicament {}`: {}", words.join(" "), ran.status)) }
}

fn read(name: &str) -> Result<String, String> {
    std::fs::read_to_string(root().join(name)).map_err(|error| format!("{name}: {error}"))
}

/// Writes a page, and prints whether it changed.
fn page(name: &str, text: &str) -> Result<(), String> {
    let changed = read(name)? != text;
    println!("{name}{}", if changed { ": changed" } else { "" });
    std::fs::write(root().join(name), text).map_err(|error| format!("{name}: {error}"))
}
