//! The switches of all algorithms of a copied tree, written into it, and the build of the tool from it.
//!
//! An algorithm is the folder `src/algorithm` of a system, and all of `grid`, on which they stand.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::render::{Rendered, render};
use crate::sites::{self, Switch};

/// The text of the module that each crate gets.
const MODULE: &str = include_str!("switch.rs.txt");
/// Builds after which a tree that still does not compile is an error.
const ROUNDS: usize = 12;

/// A system: its name, its files with their texts, and its switches with the index of their file.
pub struct System {
    pub name: String,
    library: [String; 2],
    files: Vec<(PathBuf, String)>,
    pub switches: Vec<(usize, Switch)>,
    /// The switches that do not compile.
    pub dropped: Vec<usize>,
}

impl System {
    /// The file of a switch below the folder of systems, without the folders of an algorithm.
    pub fn path(&self, number: usize) -> String {
        let path = self.files[self.switches[number].0].0.display().to_string();
        path.trim_start_matches("crates/systems/").replacen("/src/", "/", 1).replacen("/algorithm/", "/", 1)
    }

    /// The place of a switch, for people.
    pub fn told(&self, number: usize) -> String {
        let (file, switch) = &self.switches[number];
        let path = self.files[*file].0.display();
        format!("{path}:{}:{}: {}", switch.line, switch.column, switch.what)
    }
}

fn text(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if std::fs::read_to_string(path).is_ok_and(|there| there == text) {
        return Ok(());
    }
    std::fs::write(path, text).map_err(|why| format!("{}: {why}", path.display()))
}

/// The Rust files of a folder and its subfolders, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let of = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    let mut all: Vec<PathBuf> = entries.flat_map(of).collect();
    all.retain(|path| path.extension().is_some_and(|end| end == "rs") && !path.ends_with("tests.rs"));
    all.sort();
    all
}

/// The system that is an algorithm as a whole.
const WHOLE: &str = "grid";

/// The systems of a tree that have an algorithm.
pub fn systems(root: &Path) -> Result<Vec<System>, String> {
    let folder = root.join("crates/systems");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(&folder).map_err(|why| format!("{}: {why}", folder.display()))?.flatten() {
        let name = entry.file_name().into_string().map_err(|name| format!("{name:?} is not text"))?;
        let source = entry.path().join("src");
        let algorithm = if name == WHOLE { source.clone() } else { source.join("algorithm") };
        if !algorithm.is_dir() {
            continue;
        }
        let mut system = System {
            name,
            library: [source.join("lib.rs").display().to_string(), text(&source.join("lib.rs"))?],
            files: Vec::new(),
            switches: Vec::new(),
            dropped: Vec::new(),
        };
        for path in files(&algorithm).into_iter().filter(|path| *path != source.join("lib.rs")) {
            let text = text(&path)?;
            let (switches, _) = sites::of(&text, 0, &[]).map_err(|why| format!("{}: {why}", path.display()))?;
            let file = system.files.len();
            system.switches.extend(switches.into_iter().map(|switch| (file, switch)));
            let short = path.strip_prefix(root).unwrap_or(&path).to_path_buf();
            system.files.push((short, text));
        }
        found.push(system);
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// Writes the switches of a system; returns its files as written.
fn plant(root: &Path, system: &System) -> Result<BTreeMap<PathBuf, Rendered>, String> {
    let mut written = BTreeMap::new();
    let mut first = 0;
    for (path, text) in &system.files {
        let (switches, edits) = sites::of(text, first, &system.dropped).map_err(|why| why.to_string())?;
        first += switches.len();
        let rendered = render(text, &edits);
        write(&root.join(path), &rendered.text)?;
        written.insert(path.clone(), rendered);
    }
    let [library, text] = &system.library;
    write(Path::new(library), &format!("{text}\n#[allow(missing_docs)]\nmod switch;\n"))?;
    let module = MODULE.replace("@NAME@", &system.name).replace("@COUNT@", &first.max(1).to_string());
    write(&Path::new(library).with_file_name("switch.rs"), &module)?;
    Ok(written)
}

/// Plants all switches and builds the tool; switches that do not compile are dropped, until the rest compiles.
///
/// # Errors
/// If cargo does not start, or a tree without the dropped switches still does not compile.
pub fn build(root: &Path, target: &Path, systems: &mut [System]) -> Result<(), String> {
    let mut written = BTreeMap::new();
    for system in systems.iter() {
        written.insert(system.name.clone(), plant(root, system)?);
    }
    let cargo = |words: &[&str]| {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(words).args(["--profile", "ci", "--message-format", "short"]);
        cargo.current_dir(root).env("CARGO_TARGET_DIR", target).output().map_err(|why| format!("cargo: {why}"))
    };
    for round in 1..=ROUNDS {
        let mut words = vec!["check", "--keep-going"];
        let names: Vec<String> = systems.iter().map(|system| format!("predicament-{}", system.name)).collect();
        words.extend(names.iter().flat_map(|name| ["-p", name]));
        let output = cargo(&words)?;
        if output.status.success() {
            let output = cargo(&["build", "--bin", "predicament"])?;
            let told = String::from_utf8_lossy(&output.stderr);
            return if output.status.success() { Ok(()) } else { Err(told.into_owned()) };
        }
        let told = String::from_utf8_lossy(&output.stderr);
        let told: String = told.split_inclusive('\n').filter(|line| line.contains("error")).collect();
        let mut dropped = 0;
        for system in systems.iter_mut() {
            let before = system.dropped.len();
            for (path, rendered) in &written[&system.name] {
                let prefix = format!("{}:", path.display());
                for line in told.lines().filter(|line| line.starts_with(&prefix) && line.contains(": error")) {
                    let mut place = line[prefix.len()..].split(':').map(str::parse);
                    if let (Some(Ok(line)), Some(Ok(column))) = (place.next(), place.next()) {
                        system.dropped.extend(rendered.culprits(line, column));
                        system.dropped.sort_unstable();
                        system.dropped.dedup();
                    }
                }
            }
            dropped += system.dropped.len() - before;
            if system.dropped.len() > before {
                written.insert(system.name.clone(), plant(root, system)?);
            }
        }
        println!("round {round}: {dropped} switches do not compile");
        if dropped == 0 {
            return Err(told);
        }
    }
    Err(format!("switches: the tree does not compile after {ROUNDS} rounds"))
}
