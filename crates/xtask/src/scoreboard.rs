//! The sample scoreboard: the engines of whole tasks on the embedded and the fetched suites, in `reports/scoreboard`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{cargo, fresh, root, target_directory};
use crate::sample::once;

/// The folder of the runs, beside the build.
const WORK: &str = "target/scoreboard";
/// The folder of the sample.
const SAMPLE: &str = "reports/scoreboard";
/// The backend whose times are the unit of all others.
const UNIT: &str = "exact";
/// The seconds of a task's bench.
const SECONDS: &str = "20";
/// A run ends with 100 if it has findings, and with 103 if an engine has timed out. A bench ends with 100 if the
/// answers of an engine change while it is timed.
const FOUND: [i32; 3] = [0, 100, 103];

/// Runs and times all engines of whole tasks that start, each on the scenes of its tasks, and writes their scoreboard.
///
/// It leaves out engines that do not start, and says which engines it runs. With `resume` it keeps the steps that an
/// earlier call has done.
pub fn make(resume: bool) -> Result<(), String> {
    let work = if resume { PathBuf::from(WORK) } else { fresh(WORK)? };
    std::fs::create_dir_all(root().join(&work)).map_err(|error| format!("{}: {error}", work.display()))?;
    let path = |name: &str| work.join(name).display().to_string();
    cargo("build the tool", &["build", "--release"])?;
    let program = target_directory()?.join("release").join("predicament").display().to_string();
    let tool = |what: &str, args: &[&str], fine: &[i32]| {
        let words: Vec<String> = [program.as_str()].iter().chain(args).map(|&word| word.to_owned()).collect();
        once(&work, what, &words, fine)
    };
    tool("fetch real data", &["corpus", "fetch", "--quiet"], &[0])?;
    let engines = engines(&printed(&program, &["engines"])?);
    if engines.is_empty() {
        return Err("no engine of a whole task starts; install engines by `cargo xtask engines NAME...`".to_owned());
    }
    let scenes = scenes(&printed(&program, &["corpus", "list", "--format", "json"])?);
    let mut folders = Vec::new();
    for (task, names) in &engines {
        let Some(of_task) = scenes.get(task) else { continue };
        let backends = names.iter().map(|name| format!("engine:{name},")).collect::<String>() + UNIT;
        let (run, bench) = (path(&format!("run-{task}")), path(&format!("bench-{task}")));
        let suites: BTreeSet<&str> = of_task.iter().filter_map(|scene| Some(scene.split_once('/')?.0)).collect();
        let only = format!("^({})$", of_task.join("|").replace('.', "\\."));
        let mut words = vec!["run", "--quiet", "-f", &only, "-b", &backends, "--out", &run];
        words.extend(suites);
        tool(&format!("run {task}"), &words, &FOUND)?;
        let timed = ["bench", "--quiet", "--judged", &run, "--seconds", SECONDS, "-b", &backends, "--out", &bench];
        tool(&format!("time {task}"), &timed, &FOUND)?;
        folders.extend([run, bench]);
    }
    let board = path("scoreboard");
    let folders: Vec<&str> = folders.iter().map(String::as_str).collect();
    tool("write the scoreboard", &[&["scoreboard", "--out", &board], &folders[..]].concat(), &[0])?;
    keep(&root().join(&board))?;
    println!("\n{SAMPLE} is new; `docs/WHICH.md` has a section that rests on it");
    Ok(())
}

/// The engines that start, by the whole tasks that they answer. Engines whose licence is for noncommercial use are left
/// out: they are run by name alone.
fn engines(list: &str) -> BTreeMap<String, Vec<String>> {
    let mut engines: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let lines: Vec<&str> = list.lines().map(str::trim).collect();
    // The licence, then a line such as `-b engine:spade: version 2.15.1; tasks delaunay2d`.
    for pair in lines.windows(2).filter(|pair| !pair[0].to_lowercase().contains("noncommercial")) {
        let Some(line) = pair[1].strip_prefix("-b engine:") else { continue };
        if let (Some((name, _)), Some((_, tasks))) = (line.split_once(':'), line.split_once("tasks ")) {
            tasks.split(", ").for_each(|task| engines.entry(task.to_owned()).or_default().push(name.to_owned()));
        }
    }
    engines
}

/// The scenes of each task, as `suite/scene`, from a list with an object for each suite.
fn scenes(list: &str) -> BTreeMap<String, Vec<String>> {
    let mut scenes: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for line in list.lines() {
        let Some(suite) = value(line, "suite") else { continue };
        for scene in line.split("{\"family\"").skip(1) {
            if let (Some(name), Some(task)) = (value(scene, "name"), value(scene, "task")) {
                scenes.entry(task.to_owned()).or_default().push(format!("{suite}/{name}"));
            }
        }
    }
    scenes
}

/// The first value of a key in a line of JSON: a text without quotes in it.
fn value<'l>(line: &'l str, key: &str) -> Option<&'l str> {
    Some(line.split_once(&format!("\"{key}\":\""))?.1.split_once('"')?.0)
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
        // A program's stderr may name its folder.
        let folder = format!("{}/", root().display());
        for name in files(&from)? {
            let text = std::fs::read_to_string(from.join(&name)).map_err(failed)?;
            std::fs::write(to.join(&name), text.replace(&folder, "")).map_err(failed)?;
        }
    }
    Ok(())
}

#[test]
fn engines_and_scenes_are_read_from_what_the_tool_prints() {
    let list = "a   about tasks\n    -b engine:a: version 1; tasks hull2d, hull3d\n    engine:b (b.toml): start: it did not\n    \
        -b engine:c: orient2d\n    -b engine:d: version 2; tasks hull2d\n    Noncommercial 1\n    -b engine:e: tasks hull2d\n";
    let engines = engines(list);
    assert_eq!(engines["hull2d"], ["a", "d"]);
    assert_eq!([engines["hull3d"].len(), engines.len()], [1, 2]);
    let list = r#"{"needs_fetch":false,"scenes":[{"family":"f","name":"x","tags":[],"task":"t"},{"family":"f","name":"y","tags":[],"task":"u"}],"suite":"s","title":"S"}"#;
    let scenes = scenes(&format!("{list}\n{list}"));
    assert_eq!((&scenes["t"], &scenes["u"]), (&vec!["s/x".to_owned(); 2], &vec!["s/y".to_owned(); 2]));
}
