//! The reports of `docs/defects`: each has a complete program, which is compiled, run, and compared with what the
//! page says.
//!
//! A page has one block of code, then a paragraph **To run.** with commands in backticks, then a block with the
//! output. A page whose client or library is not on this machine is named and counted.

use std::path::Path;
use std::process::Command;

use crate::command::{answers, fresh, root};

const PAGES: &str = "docs/defects";
const FOLDER: &str = "target/defects";

/// The program of a page.
#[derive(PartialEq, Debug)]
struct Program<'p> {
    /// The language of the block.
    language: &'p str,
    code: &'p str,
    /// The commands that fetch libraries and compile.
    commands: Vec<&'p str>,
    /// The whole output.
    output: &'p str,
}

/// Reads the program of a page.
///
/// # Errors
/// What the page lacks.
fn program(page: &str) -> Result<Program<'_>, String> {
    let (before, after) = page.split_once("\n**To run.** ").ok_or("the page has no paragraph **To run.**")?;
    let block = before.rsplit("\n```").nth(1).ok_or("there is no program before **To run.**")?;
    let (language, code) = block.split_once('\n').ok_or("the program is empty")?;
    let (how, rest) = after.split_once("\n```text\n").ok_or("there is no output after **To run.**")?;
    let (output, _) = rest.split_once("\n```").ok_or("the output does not end")?;
    if how.contains("\n**") || how.contains("```") {
        return Err("there is no output after **To run.**".to_owned());
    }
    Ok(Program { language, code, commands: how.split('`').skip(1).step_by(2).collect(), output })
}

/// The file of a program, and the command that runs it.
fn file(language: &str) -> Result<(&'static str, &'static str), String> {
    match language {
        "rust" => Ok(("src/main.rs", "cargo run --quiet --release")),
        "cpp" => Ok(("main.cpp", "./main")),
        "python" => Ok(("main.py", "venv/bin/python main.py")),
        "js" => Ok(("main.mjs", "node main.mjs")),
        other => Err(format!("no program is in the language `{other}`")),
    }
}

/// Runs the program of each page.
///
/// # Errors
/// The pages that say something else.
pub fn check() -> Result<(), String> {
    let folder = root().join(fresh(FOLDER)?);
    let (mut failed, mut missing, mut right) = (Vec::new(), Vec::new(), 0);
    for (name, text) in pages()? {
        println!("== {PAGES}/{name}.md");
        match run(&folder, &name, &text) {
            Ok(None) => right += 1,
            Ok(Some(why)) => missing.push(format!("{name}: {why}")),
            Err(why) => failed.push(format!("{PAGES}/{name}.md: {why}")),
        }
    }
    println!("\n{right} programs print what their pages say; {} did not run", missing.len());
    missing.iter().for_each(|why| println!("NOT RUN: {why}"));
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// The pages of reports, by name.
fn pages() -> Result<Vec<(String, String)>, String> {
    let folder = root().join(PAGES);
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut all = Vec::new();
    for path in entries.flatten().map(|entry| entry.path()).filter(|path| !path.ends_with("README.md")) {
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        all.push((path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), text));
    }
    all.sort();
    Ok(all)
}

/// Runs one program; returns what is missing for it.
fn run(folder: &Path, name: &str, page: &str) -> Result<Option<String>, String> {
    let program = program(page)?;
    let (source, runs) = file(program.language)?;
    let own = folder.join(name);
    let write = |file: &str, text: &str| {
        let path = own.join(file);
        let made = path.parent().map_or(Ok(()), std::fs::create_dir_all);
        made.and_then(|()| std::fs::write(&path, text)).map_err(|error| format!("{}: {error}", path.display()))
    };
    write(source, program.code)?;
    if program.language == "rust" {
        write("Cargo.toml", &format!("[package]\nname = \"{name}\"\nedition = \"2024\"\n\n[workspace]\n"))?;
    }
    if program.commands.iter().any(|command| command.starts_with("pip ")) {
        shell(&own, "python3 -m venv venv")?;
    }
    for command in program.commands {
        let words: Vec<&str> = command.split_whitespace().collect();
        match words[..] {
            // What needs an administrator is only looked for.
            ["apt", "install", package] => {
                if !answers("dpkg", &["-s", package]) {
                    return Ok(Some(format!("type `{command}`")));
                }
            }
            ["pip", ..] => drop(shell(&own, &format!("venv/bin/{command} --quiet"))?),
            [client, ..] if !answers(client, &["--version"]) => {
                return Ok(Some(format!("there is no `{client}` here")));
            }
            _ => drop(shell(&own, command)?),
        }
    }
    let printed = shell_any(&own, runs)?;
    if printed.trim() == program.output.trim() {
        return Ok(None);
    }
    Err(format!("the program prints\n{printed}\nand not\n{}", program.output))
}

/// Runs a command in a folder; returns its output.
///
/// # Errors
/// If it fails.
fn shell(folder: &Path, command: &str) -> Result<String, String> {
    let output = output(folder, command)?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(format!("`{command}` failed: {}", String::from_utf8_lossy(&output.stderr)))
}

/// The output of a command that may crash.
fn shell_any(folder: &Path, command: &str) -> Result<String, String> {
    Ok(String::from_utf8_lossy(&output(folder, command)?.stdout).into_owned())
}

fn output(folder: &Path, command: &str) -> Result<std::process::Output, String> {
    let mut shell = Command::new("sh");
    // One folder of builds: programs share dependencies.
    shell.args(["-c", command]).current_dir(folder).env("CARGO_TARGET_DIR", "../target");
    shell.output().map_err(|error| format!("`{command}`: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_page_has_a_whole_program_and_a_cure() {
        let pages = pages().expect("pages");
        assert!(pages.len() > 15, "{} pages", pages.len());
        for (name, page) in pages {
            let program = program(&page).unwrap_or_else(|why| panic!("{name}: {why}"));
            let begins = match program.language {
                "rust" => program.code.contains("use ") && program.code.contains("fn main()"),
                "cpp" => program.code.contains("#include <") && program.code.contains("int main()"),
                _ => program.code.contains("import "),
            };
            assert!(begins && !program.commands.is_empty(), "{name}: the program is not complete");
            assert!(file(program.language).is_ok(), "{name}");
            let has_cure = ["\n**A cure.** ", "\n**No cure.** "].iter().any(|words| page.contains(words));
            assert!(has_cure, "{name} suggests no fix, and does not say why not");
        }
    }

    #[test]
    fn a_page_without_its_output_is_seen() {
        let page = "# a\n\n```js\nimport a;\n```\n\n**To run.** `npm install a@1`. It prints\n\n```text\n0\n1\n```\n\n**A cure.** None.\n";
        let whole = Program { language: "js", code: "import a;", commands: vec!["npm install a@1"], output: "0\n1" };
        assert_eq!(program(page), Ok(whole));
        assert!(program(&page.replace("**To run.**", "Run")).is_err());
        assert!(program(&page.replace("text\n0", "js\n0")).is_err());
        assert!(file("perl").is_err());
    }
}
