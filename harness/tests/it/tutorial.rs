//! The files and commands of `docs/TUTORIAL.md`.

use std::path::Path;

use crate::common::tool;

/// The page.
const PAGE: &str = include_str!("../../../docs/TUTORIAL.md");

/// Writes the files of a job and runs its commands; returns the number of commands.
fn follow(job: &str, folder: &Path) -> usize {
    let (mut ran, mut file, mut block) = (0, None, None::<(String, String)>);
    for line in job.lines() {
        match &mut block {
            None => {
                if let Some(kind) = line.strip_prefix("```") {
                    block = Some((kind.to_owned(), String::new()));
                } else if let Some(name) = line.strip_prefix("**`").and_then(|name| name.strip_suffix("`**")) {
                    file = Some(name.to_owned());
                }
            }
            Some((kind, text)) if line == "```" => {
                match (kind.as_str(), file.take()) {
                    ("sh", _) => ran += text.lines().filter(|line| call(line, folder)).count(),
                    (_, Some(name)) => std::fs::write(folder.join(name), text).unwrap(),
                    _ => {}
                }
                block = None;
            }
            Some((_, text)) => *text += &format!("{line}\n"),
        }
    }
    ran
}

/// Runs a command line of the tool and asserts its exit code.
fn call(line: &str, folder: &Path) -> bool {
    let (command, code) = line.split_once('#').unwrap_or((line, "0"));
    let code: i32 = code.trim().parse().unwrap_or_else(|_| panic!("{line}: no exit code behind #"));
    let mut words = command.split_whitespace();
    if words.next() != Some("predicament") {
        return false;
    }
    let words: Vec<&str> = words.collect();
    let output = tool(&words).current_dir(folder).env_remove("PREDICAMENT_ENGINES").output().unwrap();
    let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    assert_eq!(output.status.code(), Some(code), "{line}\n{said}");
    true
}

#[test]
fn jobs_with_the_tool_alone_go_as_they_are_written() {
    [(1, 8), (2, 4), (5, 2)].into_iter().for_each(goes);
}

#[test]
#[ignore = "needs Python"]
fn the_jobs_in_python_go_as_they_are_written() {
    [(4, 5), (6, 6)].into_iter().for_each(goes);
}

/// A job by its number goes as it is written, and has so many commands.
fn goes((number, commands): (usize, usize)) {
    let job = PAGE.split("\n## ").nth(number).unwrap();
    let folder = tempfile::tempdir().unwrap();
    assert!(job.starts_with(&number.to_string()), "{job}");
    assert_eq!(follow(job, folder.path()), commands, "job {number}");
}

/// The commands of README with their outputs: `$ predicament …`, and the lines below are what it prints.
#[test]
fn readme_shows_what_the_tool_prints() {
    let readme = include_str!("../../../README.md");
    let folder = tempfile::tempdir().unwrap();
    let (_, survey) = PAGE.split_once("```csv\n").unwrap();
    std::fs::write(folder.path().join("survey.csv"), survey.split("```").next().unwrap()).unwrap();
    let mut calls = 0;
    for block in readme.split("```text\n").skip(1).map(|block| block.split("```").next().unwrap()) {
        for call in block.split("$ predicament ").skip(1) {
            let (line, printed) = call.split_once('\n').unwrap();
            let line = line.split(" # ").next().unwrap();
            let mut output = String::new();
            for one in line.split("&& predicament ") {
                let words: Vec<&str> = one.split_whitespace().collect();
                let told = tool(&words).current_dir(folder.path()).output().unwrap();
                output += &String::from_utf8(told.stdout).unwrap();
            }
            let shown: Vec<&str> = printed.lines().filter(|line| !line.is_empty()).collect();
            // A line may be left out; what is shown is as it is printed, in its order.
            let mut lines = output.lines();
            for shown in &shown {
                assert!(lines.any(|line| line == *shown), "`{line}` does not print `{shown}`, but\n{output}");
            }
            calls += 1;
            // The reasons are the user's.
            let file = folder.path().join("expected.toml");
            if let Ok(text) = std::fs::read_to_string(&file) {
                std::fs::write(&file, text.replace("reason = \"\"", "reason = \"rounded\"")).unwrap();
            }
        }
    }
    assert_eq!(calls, 4, "the commands of README");
}
