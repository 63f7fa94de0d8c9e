//! The run folders of one report, in which each scene on each backend counts once.
//!
//! A bench copies the judgement of the answers that it times, and folders may overlap in other ways. For each scene on
//! each backend, the first folder that has it counts; later folders lose their rows. Timings belong to a folder and
//! stay there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use csv::StringRecord;

use super::csv_file::Text;
use super::reader::Pair;
use super::{Outcome, RunDir};
use crate::{Error, PhaseRow, PrecisionRow, Row, StageRow, SummaryRow};

/// The key of rows of stages: task, family, backend.
type Group = [String; 3];

/// The columns that identify scene and backend in the tables of tasks.
const KEY: [&str; 5] = ["suite", "scene", "scene_id", "task", "backend"];

impl RunDir {
    /// Reads the folders of one report: each scene on each backend counts once, in the first folder that has it.
    ///
    /// A folder that is named twice is read once. Warnings list the rows that were left out and differed.
    ///
    /// # Errors
    /// If a folder can't be read, or two folders of one level disagree about a scene on a backend.
    pub fn open_all(paths: impl IntoIterator<Item = impl AsRef<Path>>) -> Result<Vec<RunDir>, Error> {
        let mut places: Vec<PathBuf> = Vec::new();
        let mut runs: Vec<RunDir> = Vec::new();
        for path in paths {
            let path = path.as_ref();
            let place = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
            match places.iter().position(|other| *other == place) {
                Some(first) => {
                    let warning = format!("{}: named more than once, read once", path.display());
                    runs[first].warnings.push(warning);
                }
                None => {
                    runs.push(RunDir::open(path)?);
                    places.push(place);
                }
            }
        }
        count_once(&mut runs)?;
        Ok(runs)
    }
}

/// Removes from each folder the rows that an earlier folder has.
fn count_once(runs: &mut [RunDir]) -> Result<(), Error> {
    let judged: Vec<BTreeSet<Pair>> = runs.iter().map(|run| run.summary.iter().map(pair_of).collect()).collect();
    let planned: Vec<BTreeSet<Pair>> = runs.iter().map(planned).collect();
    for (at, run) in runs.iter_mut().enumerate() {
        let others = judged.iter().enumerate().filter(|(other, _)| *other != at);
        run.elsewhere = others.flat_map(|(_, pairs)| pairs).chain(planned[..at].iter().flatten()).cloned().collect();
    }
    let scenes: Vec<_> = runs.iter().map(scenes).collect();
    let mut counted: Vec<BTreeSet<Group>> = Vec::new();
    for at in 0..runs.len() {
        let (earlier, later) = runs.split_at_mut(at);
        let Some(run) = later.first_mut() else { break };
        counted.push(drop_stages(run, &scenes, &counted));
        drop_rows(run, earlier)?;
        drop_precision(run, earlier)?;
        drop_of_tasks(run, earlier)?;
        run.maps.retain(|map| earlier.iter().all(|other| !other.maps.contains(map)));
    }
    Ok(())
}

fn pair_of(row: &SummaryRow) -> Pair {
    [&row.suite, &row.scene, &row.scene_id, &row.task, &row.backend].map(String::clone)
}

fn planned(run: &RunDir) -> BTreeSet<Pair> {
    let scenes = run.plan.scenes.iter();
    let pairs = scenes.flat_map(|scene| run.plan.backends_for(&scene.task).map(move |backend| (scene, backend)));
    pairs.map(|(s, backend)| [&s.suite, &s.scene, &s.scene_id, &s.task, backend].map(String::clone)).collect()
}

/// Drops rows of `summary.csv` that an earlier folder has, and their findings.
fn drop_rows(run: &mut RunDir, earlier: &[RunDir]) -> Result<(), Error> {
    let mut repeated: BTreeSet<Pair> = BTreeSet::new();
    for before in earlier {
        let rows: BTreeMap<Pair, &SummaryRow> = before.summary.iter().map(|row| (pair_of(row), row)).collect();
        let (mut other_counts, mut other_status) = (0, 0);
        for row in &run.summary {
            let pair = pair_of(row);
            let Some(&first) = rows.get(&pair) else { continue };
            let same_counts = *first == SummaryRow { status: first.status, ..row.clone() };
            if !same_counts && before.plan.level == run.plan.level {
                let what = format!("{}/{} ({}) on {}", row.suite, row.scene, row.task, row.backend);
                return Err(disagree(run, before, SummaryRow::FILE, &format!("{what} has other counts")));
            }
            other_counts += usize::from(!same_counts);
            other_status += usize::from(same_counts && first.status != row.status);
            repeated.insert(pair);
        }
        for (count, what) in
            [(other_counts, "counts at another level"), (other_status, "a status by other expectations")]
        {
            if count > 0 {
                run.warnings.push(format!(
                    "{}: {count} rows have {what} than in {}, whose rows are shown",
                    run.path.display(),
                    before.path.display()
                ));
            }
        }
    }
    run.summary.retain(|row| !repeated.contains(&pair_of(row)));
    run.findings.retain(|row| {
        !repeated.contains(&[&row.suite, &row.scene, &row.scene_id, &row.task, &row.backend].map(String::clone))
    });
    Ok(())
}

/// Drops rows of `precision.csv` that an earlier folder has. These rows depend only on the scene.
fn drop_precision(run: &mut RunDir, earlier: &[RunDir]) -> Result<(), Error> {
    let scene = |row: &PrecisionRow| [&row.suite, &row.scene, &row.scene_id].map(String::clone);
    let mut repeated = BTreeSet::new();
    for before in earlier {
        let rows: BTreeMap<_, &PrecisionRow> = before.precision.iter().map(|row| (scene(row), row)).collect();
        for row in &run.precision {
            match rows.get(&scene(row)) {
                Some(&first) if first == row => repeated.insert(scene(row)),
                Some(_) => {
                    let what = format!("{}/{} has another row", row.suite, row.scene);
                    return Err(disagree(run, before, PrecisionRow::FILE, &what));
                }
                None => continue,
            };
        }
    }
    run.precision.retain(|row| !repeated.contains(&scene(row)));
    Ok(())
}

/// The judged scenes, by task, family and backend.
fn scenes(run: &RunDir) -> BTreeMap<Group, BTreeSet<[String; 3]>> {
    let families = run.plan.families();
    let mut scenes: BTreeMap<Group, BTreeSet<_>> = BTreeMap::new();
    for row in &run.summary {
        if let Some(family) = families.get(&[&*row.suite, &*row.scene, &*row.scene_id, &*row.task]) {
            let group = [row.task.clone(), (*family).to_owned(), row.backend.clone()];
            scenes.entry(group).or_default().insert([&row.suite, &row.scene, &row.scene_id].map(String::clone));
        }
    }
    scenes
}

/// Drops the counts of stages that earlier folders have, and returns the remaining groups. A row covers all scenes of a
/// family, so partly repeated counts can't be separated: they are left out with a warning.
fn drop_stages(
    run: &mut RunDir,
    scenes: &[BTreeMap<Group, BTreeSet<[String; 3]>>],
    counted: &[BTreeSet<Group>],
) -> BTreeSet<Group> {
    let group = |row: &StageRow| [&row.task, &row.family, &row.backend].map(String::clone);
    let mut left: BTreeSet<Group> = run.stages.iter().map(group).collect();
    let mut mixed = Vec::new();
    left.retain(|group| {
        let before = scenes.iter().zip(counted).filter(|(_, counted)| counted.contains(group));
        let before: BTreeSet<_> = before.filter_map(|(scenes, _)| scenes.get(group)).flatten().collect();
        let own: BTreeSet<_> = scenes[counted.len()].get(group).into_iter().flatten().collect();
        if own.is_disjoint(&before) {
            return true;
        }
        if !own.is_subset(&before) {
            mixed.push(group.join(" "));
        }
        false
    });
    run.stages.retain(|row| left.contains(&group(row)));
    if let Some(first) = mixed.first() {
        run.warnings.push(format!(
            "{}: stages of {} groups, first {first}, partly repeat another folder and can't be separated; they are \
             left out",
            run.path.join(StageRow::FILE).display(),
            mixed.len()
        ));
    }
    left
}

/// Drops rows of the tasks' tables that an earlier folder has. A table without the name of a scene stays as it is, and
/// so do timings.
fn drop_of_tasks(run: &mut RunDir, earlier: &[RunDir]) -> Result<(), Error> {
    let mut tables = std::mem::take(&mut run.tables);
    for (file, table) in tables.iter_mut().filter(|(file, _)| *file != PhaseRow::FILE) {
        for before in earlier {
            let Some(first) = before.tables.get(file) else { continue };
            let (rows, own) = (by_key(first), by_key(table));
            let repeated: BTreeSet<Vec<String>> = own.keys().filter(|key| rows.contains_key(*key)).cloned().collect();
            let is_certain = before.plan.level == run.plan.level
                && [before.outcome, run.outcome] == [Outcome::Complete; 2]
                && first.header == table.header;
            if let Some(key) = repeated.iter().find(|key| is_certain && rows[*key] != own[*key]) {
                return Err(disagree(run, before, file, &format!("{} has other rows", key.join(" "))));
            }
            let places = key_columns(table);
            table.is_part |= !repeated.is_empty();
            table.rows.retain(|(_, row)| !repeated.contains(&key(row, &places)));
        }
    }
    run.tables = tables;
    Ok(())
}

/// The indices of the key's columns that a table has.
fn key_columns(table: &Text) -> Vec<usize> {
    KEY.iter().filter_map(|name| table.header.iter().position(|column| column == *name)).collect()
}

fn key(row: &StringRecord, places: &[usize]) -> Vec<String> {
    places.iter().map(|&place| row.get(place).unwrap_or_default().to_owned()).collect()
}

/// The rows of a table by scene and backend; empty if the table does not name scenes.
fn by_key(table: &Text) -> BTreeMap<Vec<String>, Vec<&StringRecord>> {
    let mut rows: BTreeMap<_, Vec<_>> = BTreeMap::new();
    if table.header.iter().any(|column| column == "scene_id") {
        let places = key_columns(table);
        for (_, row) in &table.rows {
            rows.entry(key(row, &places)).or_default().push(row);
        }
    }
    rows
}

/// The error about two folders that contradict each other about one scene.
fn disagree(run: &RunDir, before: &RunDir, file: &str, what: &str) -> Error {
    let cure = "report one of the two; `bench --judged RUN` times the answers that a run has judged";
    Error::new(&run.path.join(file), format!("{what} than in {}; {cure}", before.path.join(file).display()))
}
