//! The sample scoreboard: the engines of whole tasks on the embedded and the fetched suites, in `reports/scoreboard`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{cargo, fresh, root, target_directory};
use crate::sample::{fetched_suites, once};

/// The folder of the runs, beside the build.
const WORK: &str = "target/scoreboard";
/// The folder of the sample.
const SAMPLE: &str = "reports/scoreboard";
/// The backend whose times are the unit of all others.
const UNIT: &str = "exact";
/// A run ends with 100 if it has findings.
const FOUND: [i32; 2] = [0, 100];

/// Runs and times all engines of whole tasks that start, and writes their scoreboard.
///
/// It leaves out engines that do not start, and says which engines it runs. With `resume` it keeps the steps that an
/// earlier call has done.
pub fn make(resume: bool) -> Result<(), String> {
    let work = if resume { PathBuf::from(WORK) } else { fresh(WORK)? };
    std::fs::create_dir_all(root().join(&work)).map_err(|error| format!("{}: {error}", work.display()))?;
    let path = |name: &str| work.join(name).display().to_string();
    let (run, bench, board) = (path("run"), path("bench"), path("scoreboard"));
    cargo("build the tool", &["build", "--release"])?;
    let program = target_directory()?.join("release").join("predicament").display().to_string();
    let tool = |what: &str, args: &[&str], fine: &[i32]| {
        let words: Vec<String> = [program.as_str()].iter().chain(args).map(|&word| word.to_owned()).collect();
        once(&work, what, &words, fine)
    };
    tool("fetch real data", &["corpus", "fetch", "--quiet"], &[0])?;
    let engines = engines(&program)?;
    println!("\n== {} engines answer whole tasks: {}", engines.len(), engines.join(", "));
    let backends = engines.iter().map(|name| format!("engine:{name},")).collect::<String>() + UNIT;
    let [embedded, fetched] = suites(&program)?;
    let suites: Vec<&str> = embedded.iter().chain(&fetched).map(String::as_str).collect();
    let all = |args: &[&'static str]| [args, &suites, &["-b", &backends, "--quiet", "--out"]].concat();
    tool("run the suites", &[&all(&["run", "--timeout", "20"])[..], &[&run]].concat(), &FOUND)?;
    let timed = ["bench", "--judged", &run, "--seconds", "300", "--quiet", "-b", &backends, "--out", &bench];
    tool("time the libraries", &timed, &[0])?;
    tool("write the scoreboard", &["scoreboard", &run, &bench, "--out", &board], &[0])?;
    keep(&root().join(&board))?;
    println!("\n{SAMPLE} is new; `docs/WHICH.md` has a section that rests on it");
    Ok(())
}

/// The engines that start and answer whole tasks.
fn engines(program: &str) -> Result<Vec<String>, String> {
    let text = printed(program, &["engines"])?;
    // A line such as `-b engine:spade: version 2.15.1; tasks delaunay2d`.
    let ready = text.lines().filter(|line| line.contains("tasks "));
    let name = |line: &str| line.trim().strip_prefix("-b engine:")?.split(':').next().map(str::to_owned);
    let engines: Vec<String> = ready.filter_map(name).collect();
    let why = "no engine of a whole task starts; install engines by `cargo xtask engines NAME...`";
    if engines.is_empty() { Err(why.to_owned()) } else { Ok(engines) }
}

/// The suites that are embedded, and those whose data is fetched.
fn suites(program: &str) -> Result<[Vec<String>; 2], String> {
    let fetched = fetched_suites(program)?;
    let text = printed(program, &["corpus", "list"])?;
    let all = text.lines().filter_map(|line| line.split_whitespace().next().map(str::to_owned));
    Ok([all.filter(|name| !fetched.contains(name)).collect(), fetched])
}

/// The standard output of the tool.
fn printed(program: &str, args: &[&str]) -> Result<String, String> {
    let output = Command::new(program)
        .args(args)
        .current_dir(root())
        .output()
        .map_err(|error| format!("{}: {error}", args.join(" ")))?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Replaces the sample by the parts of the scoreboard that a forge shows: pages in Markdown, figures, scenes.
fn keep(board: &Path) -> Result<(), String> {
    let sample = root().join(SAMPLE);
    let failed = |error: std::io::Error| format!("{}: {error}", sample.display());
    let is_kept = |name: &str| (name.ends_with(".md") || name.ends_with(".csv")) && name != "MADE.md";
    for (folder, all) in [("", false), ("scenes", true)] {
        let (from, to) = (board.join(folder), sample.join(folder));
        std::fs::create_dir_all(&to).map_err(failed)?;
        let files = |folder: &Path| -> Result<Vec<String>, String> {
            let entries = std::fs::read_dir(folder).map_err(failed)?;
            let names = entries.map(|entry| Ok(entry.map_err(failed)?.file_name().to_string_lossy().into_owned()));
            Ok(names.collect::<Result<Vec<_>, String>>()?.into_iter().filter(|name| all || is_kept(name)).collect())
        };
        for name in files(&to)? {
            std::fs::remove_file(to.join(&name)).map_err(failed)?;
        }
        for name in files(&from)? {
            std::fs::copy(from.join(&name), to.join(&name)).map_err(failed)?;
        }
    }
    Ok(())
}
