//! The search for run folders: the given folders, and run folders inside them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use predicament_records::{Error, RunFolder};

/// A run folder with its name in the exported rows.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Found {
    /// The folder's name, or its path from the folder in which it was found, with `/`.
    pub run: String,
    /// The path of the folder.
    pub path: PathBuf,
    /// The start time of the run, if recorded.
    pub started: Option<String>,
}

/// The result of the search.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Runs {
    /// The runs, by start time, then by name; runs without a start time come first.
    pub runs: Vec<Found>,
    /// Folders without a run, and links, which are not followed.
    pub others: Vec<PathBuf>,
}

/// Finds the runs in these folders. Each folder must be a run folder or contain some, at any depth.
///
/// # Errors
/// If a folder contains no run, if a run has lost its plan, if two runs have the same name, or if the file system
/// fails.
pub fn find(folders: &[PathBuf]) -> Result<Runs, Error> {
    let mut found = Runs::default();
    for folder in folders {
        if RunFolder::is_one(folder) {
            let full = fs::canonicalize(folder).map_err(Error::io(folder))?;
            let name = full.file_name().map_or_else(|| "run".into(), |name| name.to_string_lossy().into_owned());
            found.add(name, folder)?;
        } else {
            whole(folder)?;
            let before = found.runs.len();
            found.below(folder, "")?;
            if found.runs.len() == before {
                return Err(Error::new(folder, "it is not a run folder and does not contain run folders"));
            }
        }
    }
    let mut named: BTreeMap<&str, &Path> = BTreeMap::new();
    for Found { run, path, .. } in &found.runs {
        if let Some(other) = named.insert(run, path) {
            let message = format!(
                "the name of the run would be `{run}`, the same as for {}; name the folder that contains both",
                other.display()
            );
            return Err(Error::new(path, message));
        }
    }
    found.runs.sort_by(|a, b| (&a.started, &a.run).cmp(&(&b.started, &b.run)));
    found.others.sort();
    Ok(found)
}

/// Refuses a run folder that has lost its plan: its rows would be missing silently.
fn whole(folder: &Path) -> Result<(), Error> {
    if !RunFolder::has_lost_plan(folder)? {
        return Ok(());
    }
    let message = "the file is missing, but the folder has tables of a run; restore the file from a copy, or leave \
                   the folder out";
    Err(Error::new(&folder.join("plan.json"), message))
}

impl Runs {
    fn add(&mut self, run: String, path: &Path) -> Result<(), Error> {
        let started = RunFolder::env(path)?.started;
        self.runs.push(Found { run, path: path.to_owned(), started });
        Ok(())
    }

    /// Adds the runs in a folder, with names that begin with `prefix`; returns true if there are any.
    fn below(&mut self, folder: &Path, prefix: &str) -> Result<bool, Error> {
        let mut has_run = false;
        for entry in fs::read_dir(folder).map_err(Error::io(folder))? {
            let entry = entry.map_err(Error::io(folder))?;
            let (path, kind) = (entry.path(), entry.file_type().map_err(Error::io(&entry.path()))?);
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if kind.is_symlink() && path.is_dir() {
                self.others.push(path);
            } else if kind.is_dir() && RunFolder::is_one(&path) {
                self.add(name, &path)?;
                has_run = true;
            } else if kind.is_dir() {
                whole(&path)?;
                if self.below(&path, &format!("{name}/"))? {
                    has_run = true;
                } else {
                    self.others.push(path);
                }
            }
        }
        Ok(has_run)
    }
}
