//! Reading a run folder in any state.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use super::costs::CostRow;
use super::csv_file::{self, CHANGED, Extent};
use super::hashed::digest;
use super::regular::read_regular;
use super::sealed::{of_json, read_json};
use super::state::{Outcome, State, map_key};
use super::tables::{Record, TableSpec};
use super::{ENV, MAPS, PLAN, TABLES};
use crate::rows::{MOST, NO_COUNT};
use crate::{
    DecimalsRow, Env, Error, FORMAT, FindingRow, Interface, Plan, PrecisionRow, Row, Rows, SampledRow, StageRow,
    SummaryRow, ThroughputRow,
};

/// The key of a pair of scene and backend: suite, scene, id, task, backend.
pub(super) type Pair = [String; 5];

/// A run that was read from its folder. Rows are in the order of their files.
#[derive(Clone, PartialEq, Debug)]
pub struct RunDir {
    /// The folder, as the caller named it.
    pub path: PathBuf,
    /// The planned work.
    pub plan: Plan,
    /// The machine.
    pub env: Env,
    /// The end of the run.
    pub outcome: Outcome,
    /// `summary.csv`.
    pub summary: Rows<SummaryRow>,
    /// `findings.csv`.
    pub findings: Rows<FindingRow>,
    /// `throughput.csv`.
    pub throughput: Rows<ThroughputRow>,
    /// `stages.csv`.
    pub stages: Rows<StageRow>,
    /// `precision.csv`; empty in folders of versions that did not write it.
    pub precision: Rows<PrecisionRow>,
    /// The PNG pictures in `maps/` with their names, sorted.
    pub maps: Vec<(String, Vec<u8>)>,
    /// The tables of single tasks, as text.
    pub(super) tables: BTreeMap<String, csv_file::Text>,
    /// Planned pairs that other folders contain, if folders are read together.
    pub(super) elsewhere: BTreeSet<Pair>,
    /// Problems of the files that do not prevent reading.
    pub warnings: Vec<String>,
}

/// A planned pair of scene and backend without any result.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct NotRun {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// The task.
    pub task: String,
    /// The backend's name.
    pub backend: String,
}

impl RunDir {
    /// The run in a folder.
    ///
    /// Rows that an incomplete run has written after its last finished scene are left out, with a warning. Repeated
    /// rows, and tables of other sizes than the run has written, are refused.
    ///
    /// # Errors
    /// If a file can't be read; the error names the file and line.
    pub fn open(path: impl AsRef<Path>) -> Result<RunDir, Error> {
        let path = path.as_ref();
        let plan = RunDir::plan(path)?;
        let state = State::read(path)?;
        let mut warnings = Vec::new();
        let run = RunDir {
            path: path.to_owned(),
            plan,
            env: read_json(&path.join(ENV))?,
            outcome: state.outcome,
            summary: read_table(path, &state, &mut warnings)?,
            findings: read_table(path, &state, &mut warnings)?,
            throughput: read_table(path, &state, &mut warnings)?,
            stages: read_table(path, &state, &mut warnings)?,
            precision: read_table(path, &state, &mut warnings)?,
            tables: read_others(path, &state, &mut warnings)?,
            elsewhere: BTreeSet::new(),
            maps: read_maps(path, &state)?,
            warnings,
        };
        run.check_planned()?;
        Ok(run)
    }

    /// The plan of the run in a folder, without its results. A run that ended before its first commit may have only a
    /// plan.
    ///
    /// # Errors
    /// If the plan can't be read, is not as the run has written it, or has another format.
    pub fn plan(path: impl AsRef<Path>) -> Result<Plan, Error> {
        let (folder, path) = (path.as_ref(), path.as_ref().join(PLAN));
        let bytes = read_regular(&path)?;
        let plan: Plan = of_json(&path, &bytes)?;
        if plan.format != FORMAT {
            let cure = if plan.format < FORMAT { "run its suites again" } else { "use a newer version of the tool" };
            let message = format!("the run has format {}, and this tool reads format {FORMAT}; {cure}", plan.format);
            return Err(Error::new(folder, message));
        }
        // Names are printed and copied to files of other programs.
        let scenes = plan.scenes.iter().flat_map(|scene| [&scene.suite, &scene.scene, &scene.task, &scene.family]);
        if let Some(name) =
            plan.backends.iter().chain(&plan.suites).chain(scenes).find(|name| name.chars().any(char::is_control))
        {
            let message =
                format!("the name `{}` has control characters, and no run writes such names", name.escape_debug());
            return Err(Error::new(&path, message));
        }
        if !State::is_missing(folder) {
            check(&path, &bytes, State::read(folder)?.digests.get(PLAN))?;
        }
        Ok(plan)
    }

    /// The file name of a picture of a scene on a backend. It contains the scene's id, as several suites may use one
    /// name, and a name need not be a valid file name.
    #[must_use]
    pub fn map_name(scene_id: &str, backend: &str) -> String {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_.+".contains(c);
        let plain: String = backend.chars().take(60).map(|c| if is_plain(c) { c } else { '-' }).collect();
        let digest = if plain == backend { String::new() } else { format!(" {}", &digest(backend.as_bytes())[..8]) };
        format!("{scene_id} {plain}{digest}")
    }

    /// The title of a picture: suite, scene and backend; the picture's file name if the scene is not in the plan.
    #[must_use]
    pub fn map_title(&self, name: &str) -> String {
        let id = name.split_once(' ').map_or(name, |(id, _)| id);
        let scene = self.plan.scenes.iter().find(|scene| scene.scene_id == id);
        let backend = self.plan.backends.iter().find(|backend| RunDir::map_name(id, backend) == name);
        match scene.zip(backend) {
            Some((scene, backend)) => format!("{}/{} {backend}", scene.suite, scene.scene),
            None => name.to_owned(),
        }
    }

    /// True if a folder has a plan and no results: the run ended before its first commit, and can be resumed.
    #[must_use]
    pub fn is_unbegun(path: impl AsRef<Path>) -> bool {
        let path = path.as_ref();
        State::is_missing(path) && RunDir::plan(path).is_ok() && State::lost(path) == Ok(None)
    }

    /// Refuses rows about scenes that are not in the plan, and scenes with impossible counts.
    fn check_planned(&self) -> Result<(), Error> {
        if let Some(scene) = self.plan.scenes.iter().find(|scene| scene.queries > MOST) {
            let message = format!("{}/{} has {} queries: {NO_COUNT}", scene.suite, scene.scene, scene.queries);
            return Err(Error::new(&self.path.join(PLAN), message));
        }
        let planned = self.plan.families();
        let stranger =
            self.summary.iter().find(|r| !planned.contains_key(&[&*r.suite, &*r.scene, &*r.scene_id, &*r.task]));
        stranger.map_or(Ok(()), |row| {
            let message = format!("a row about {}/{}, which the plan does not have", row.suite, row.scene);
            Err(Error::new(&self.path.join(SummaryRow::FILE), message))
        })
    }

    /// The rows of a task's table; empty if the folder does not have the table.
    ///
    /// # Errors
    /// If a row is not of this type; the error names the file and line.
    pub fn rows<R: Row>(&self) -> Result<Rows<R>, Error> {
        self.tables.get(R::FILE).map_or(Ok(Rows::default()), csv_file::Text::typed)
    }

    /// The rows of a task's table as text; empty if the folder does not have the table, or the table has other columns.
    #[must_use]
    pub fn records(&self, table: TableSpec) -> Vec<Record> {
        self.tables.get(table.file).map_or_else(Vec::new, |text| text.records(table))
    }

    /// The rows of `throughput.csv` of each scene, by task, family and backend, for single queries or whole answers. A
    /// backend that was timed on a family only in batches has only batch rows.
    #[must_use]
    pub fn timed_scenes(&self) -> BTreeMap<[&str; 3], Vec<Vec<&ThroughputRow>>> {
        let mut timed = self.timed_scenes_by(&[Interface::Batch, Interface::Loop]);
        timed.extend(self.timed_scenes_by(&[Interface::Single, Interface::Whole]));
        timed
    }

    /// The rows of `throughput.csv` of each scene for these interfaces, by task, family and backend.
    ///
    /// Rows are in the order of measurement: where the sample number starts again, the next scene of the family begins.
    /// Therefore at most one of the interfaces may have timed a backend on a task.
    #[must_use]
    pub fn timed_scenes_by(&self, interfaces: &[Interface]) -> BTreeMap<[&str; 3], Vec<Vec<&ThroughputRow>>> {
        let mut timed: BTreeMap<_, Vec<Vec<&ThroughputRow>>> = BTreeMap::new();
        for row in self.throughput.iter().filter(|row| interfaces.contains(&row.interface)) {
            let scenes = timed.entry([&*row.task, &*row.family, &*row.backend]).or_default();
            match scenes.last_mut().filter(|scene| scene.last().is_some_and(|last| row.sample > last.sample)) {
                Some(scene) => scene.push(row),
                None => scenes.push(vec![row]),
            }
        }
        timed
    }

    /// True if all planned work was done, and the run recorded that.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.outcome == Outcome::Complete && self.not_run().is_empty()
    }

    /// The planned pairs of scene and backend without a summary row, whose task and family were not timed on that
    /// backend either; sorted. If folders were read together, each pair is named at most once, and only if no folder
    /// has it.
    #[must_use]
    pub fn not_run(&self) -> Vec<NotRun> {
        let checked: BTreeSet<[&str; 5]> =
            self.summary.iter().map(|r| [&*r.suite, &*r.scene, &*r.scene_id, &*r.task, &*r.backend]).collect();
        let timed: BTreeSet<[&str; 3]> = self.throughput.iter().map(|r| [&*r.task, &*r.family, &*r.backend]).collect();
        let elsewhere: BTreeSet<[&str; 5]> =
            self.elsewhere.iter().map(|pair| pair.each_ref().map(String::as_str)).collect();
        let mut missing = Vec::new();
        for scene in &self.plan.scenes {
            for backend in self.plan.backends_for(&scene.task) {
                let pair = [&*scene.suite, &*scene.scene, &*scene.scene_id, &*scene.task, &**backend];
                let is_told = checked.contains(&pair) || elsewhere.contains(&pair);
                if !is_told && !timed.contains(&[&*scene.task, &*scene.family, &**backend]) {
                    missing.push(NotRun {
                        suite: scene.suite.clone(),
                        scene: scene.scene.clone(),
                        scene_id: scene.scene_id.clone(),
                        task: scene.task.clone(),
                        backend: backend.clone(),
                    });
                }
            }
        }
        missing.sort_unstable();
        missing.dedup();
        missing
    }
}

fn read_table<R: Row>(folder: &Path, state: &State, warnings: &mut Vec<String>) -> Result<Rows<R>, Error> {
    if !state.committed.contains_key(R::FILE) && !folder.join(R::FILE).exists() {
        return Ok(Rows::default());
    }
    read_text(folder, R::FILE, state, warnings)?.typed()
}

/// Reads the part of a table that the run has committed, and refuses repeated rows.
fn read_text(folder: &Path, file: &str, state: &State, warnings: &mut Vec<String>) -> Result<csv_file::Text, Error> {
    let (mut text, warning) = csv_file::read(&folder.join(file), Extent::of(state, file), state.digests.get(file))?;
    text.is_part = warning.is_some();
    warnings.extend(warning);
    if let Some((_, key)) = UNIQUE.iter().find(|(of, _)| *of == file) {
        text.check_unique(key)?;
    }
    Ok(text)
}

/// The tables with at most one row per scene and backend, or per scene.
const UNIQUE: [(&str, &[&str]); 4] = [
    (SummaryRow::FILE, &["suite", "scene", "scene_id", "task", "backend"]),
    (SampledRow::FILE, &["suite", "scene", "scene_id", "task", "backend"]),
    (DecimalsRow::FILE, &["suite", "scene", "scene_id", "task", "backend"]),
    (PrecisionRow::FILE, &["suite", "scene", "scene_id"]),
];

/// The tables besides the tables that every run has.
fn read_others(
    folder: &Path,
    state: &State,
    warnings: &mut Vec<String>,
) -> Result<BTreeMap<String, csv_file::Text>, Error> {
    // Tables in the state, even if their files are missing, and tables in the folder.
    let mut files: BTreeSet<String> = state.committed.keys().cloned().collect();
    for entry in fs::read_dir(folder).map_err(Error::io(folder))? {
        let name = entry.map_err(Error::io(folder))?.file_name();
        files.extend(name.to_str().filter(|file| file.ends_with(".csv")).map(str::to_owned));
    }
    if let Some(strange) = files.iter().find(|file| file.contains(['/', '\\'])) {
        return Err(Error::new(folder, format!("state.json names `{strange}`, which is not a table of the folder")));
    }
    // Times are read separately: `CostRow::read`.
    files.remove(CostRow::FILE);
    let mut tables = BTreeMap::new();
    for file in files.into_iter().filter(|file| TABLES.iter().all(|table| table.file != file)) {
        let text = read_text(folder, &file, state, warnings)?;
        tables.insert(file, text);
    }
    Ok(tables)
}

/// Refuses bytes whose digest differs from the recorded one, if there is one.
fn check(path: &Path, bytes: &[u8], written: Option<&String>) -> Result<(), Error> {
    match written {
        Some(written) if *written != digest(bytes) => Err(Error::new(path, CHANGED)),
        _ => Ok(()),
    }
}

/// The pictures of a folder. Committed pictures must exist unchanged.
fn read_maps(folder: &Path, state: &State) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let folder = folder.join(MAPS);
    let mut files: BTreeSet<PathBuf> = state
        .digests
        .keys()
        .filter_map(|key| key.strip_prefix(MAPS)?.strip_prefix('/'))
        .filter(|file| !file.contains(['/', '\\']))
        .map(|file| folder.join(file))
        .collect();
    if folder.exists() {
        for entry in fs::read_dir(&folder).map_err(Error::io(&folder))? {
            files.insert(entry.map_err(Error::io(&folder))?.path());
        }
    }
    let mut maps = Vec::new();
    for path in files.into_iter().filter(|path| path.extension() == Some(OsStr::new("png"))) {
        let [name, file] = [path.file_stem(), path.file_name()].map(|name| name.unwrap_or_default().to_string_lossy());
        let png = read_regular(&path)?;
        check(&path, &png, state.digests.get(&map_key(&file)))?;
        maps.push((name.into_owned(), png));
    }
    maps.sort_unstable();
    Ok(maps)
}
