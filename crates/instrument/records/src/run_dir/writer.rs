//! Writing a run folder, scene by scene.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::costs::{CostLog, CostRow};
use super::csv_file::CsvFile;
use super::hashed::digest;
use super::lock::Lock;
use super::regular::read_regular;
use super::sealed::write_json;
use super::segments::SegmentRow;
use super::state::{Outcome, State, map_key, tables};
use super::tables::{Record, TableSpec};
use super::{ENV, MAPS, PLAN, TABLES};
use crate::replace::{make_folder, sweep_all};
use crate::{Env, Error, Plan, Row, RunDir, replace};

/// A writer of a run folder.
///
/// [`write`](RunWriter::write) the rows of a scene to all its tables, then call
/// [`commit_if_due`](RunWriter::commit_if_due). A commit survives a kill and a power cut: all that `state.json` lists
/// is on the disk before it. Waiting for the disk takes at most a hundredth of the time. If a writer is dropped without
/// [`finish`](RunWriter::finish), its folder counts as incomplete.
pub struct RunWriter {
    folder: PathBuf,
    tables: BTreeMap<&'static str, CsvFile>,
    state: State,
    pace: Pace,
    costs: CostLog,
    /// The lock, held as long as the folder is written.
    _lock: Lock,
}

impl RunWriter {
    /// Makes the folder, writes the plan first, and starts the tables: those of every run, and `more`.
    ///
    /// # Errors
    /// If the folder exists and is not empty (a run never overwrites another), or another process is writing it.
    pub fn create(folder: impl AsRef<Path>, plan: &Plan, env: &Env, more: &[TableSpec]) -> Result<RunWriter, Error> {
        let folder = folder.as_ref();
        make_folder(folder)?;
        let refuse_others = || {
            let message = "the folder is not empty; name another, or resume the run in it";
            if Lock::others(folder)? { Err(Error::new(folder, message)) } else { Ok(()) }
        };
        // First without a lock, as a foreign folder must not get a lock file; then again, as a run may have written it
        // since.
        refuse_others()?;
        let lock = Lock::take(folder)?;
        refuse_others()?;
        sweep_all(folder);
        write_json(&folder.join(PLAN), plan)?;
        RunWriter::start(folder, lock, env, more)
    }

    /// Starts the tables of a folder that already has its plan.
    fn start(folder: &Path, lock: Lock, env: &Env, more: &[TableSpec]) -> Result<RunWriter, Error> {
        write_json(&folder.join(ENV), env)?;
        let mut tables = BTreeMap::new();
        for TableSpec { file, columns, .. } in TABLES.iter().chain(more).copied() {
            tables.insert(file, CsvFile::create(folder.join(file), columns)?);
        }
        let plan = digest(&read_regular(&folder.join(PLAN))?);
        let digests = [(PLAN.to_owned(), plan)].into();
        let state = State { outcome: Outcome::Unfinished, committed: BTreeMap::new(), digests };
        let (folder, pace, costs) = (folder.to_owned(), Pace::default(), CostLog::default());
        let mut writer = RunWriter { folder, tables, state, pace, costs, _lock: lock };
        writer.commit()?;
        Ok(writer)
    }

    /// Resumes an incomplete run: drops what came after its last commit, and returns the remaining run, so that the
    /// caller knows what to skip.
    ///
    /// A run that was ended before its first commit has only its plan. It is started, on the machine that `env`
    /// describes.
    ///
    /// # Errors
    /// If the run is complete or being written, the folder is not a run, or its files have changed.
    pub fn resume(
        folder: impl AsRef<Path>,
        env: impl FnOnce() -> Env,
        more: &[TableSpec],
    ) -> Result<(RunWriter, RunDir), Error> {
        let folder = folder.as_ref();
        // A folder that is not a run does not get a lock file.
        RunDir::plan(folder)?;
        let lock = Lock::take(folder)?;
        sweep_all(folder);
        sweep_all(&folder.join(MAPS));
        if State::is_missing(folder) {
            clear(folder)?;
            let writer = RunWriter::start(folder, lock, &env(), more)?;
            return Ok((writer, RunDir::open(folder)?));
        }
        let mut state = State::read(folder)?;
        state.refuse_strangers(folder, TABLES.iter().chain(more).map(|table| table.file))?;
        let plan = digest(&read_regular(&folder.join(PLAN))?);
        state.digests.entry(PLAN.to_owned()).or_insert(plan);
        if state.outcome == Outcome::Complete {
            return Err(Error::new(folder, "the run is complete: there is nothing to resume"));
        }
        let mut tables = BTreeMap::new();
        for TableSpec { file, columns, .. } in TABLES.iter().chain(more).copied() {
            let path = folder.join(file);
            let table = match state.committed.get(file) {
                Some(&length) => CsvFile::reopen(path, columns, length, state.digests.get(file))?,
                None if path.exists() => {
                    let message = format!(
                        "state.json doesn't say how much of {file} was written; restore both from a copy, or start a new run"
                    );
                    return Err(Error::new(folder, message));
                }
                None => CsvFile::create(path, columns)?,
            };
            tables.insert(file, table);
        }
        state.outcome = Outcome::Unfinished;
        let (pace, costs) = (Pace::default(), CostLog::default());
        let mut writer = RunWriter { folder: folder.to_owned(), tables, state, pace, costs, _lock: lock };
        // New tables get their header, and the state lists them.
        writer.commit()?;
        let done = RunDir::open(folder)?;
        Ok((writer, done))
    }

    /// Appends rows to their table.
    ///
    /// # Errors
    /// If the disk refuses, or a row fails its [`check`](Row::check).
    pub fn write<R: Row>(&mut self, rows: &[R]) -> Result<(), Error> {
        let Some(table) = self.tables.get_mut(R::FILE) else {
            return Err(Error::new(&self.folder.join(R::FILE), "a run folder has no such table"));
        };
        rows.iter().try_for_each(|row| table.append(row))
    }

    /// Appends rows to any of the tables that the folder was made with.
    ///
    /// # Errors
    /// If the disk refuses, or the folder does not have the table.
    pub fn append(&mut self, records: &[Record]) -> Result<(), Error> {
        for record in records {
            let Some(table) = self.tables.get_mut(record.file) else {
                return Err(Error::new(&self.folder.join(record.file), "a run folder has no such table"));
            };
            table.append_fields(&record.fields)?;
        }
        Ok(())
    }

    /// Makes all that was written so far permanent.
    ///
    /// # Errors
    /// If the disk refuses.
    pub fn commit(&mut self) -> Result<(), Error> {
        self.note()?;
        self.save()
    }

    /// Commits if waiting for the disk costs at most a hundredth of the time; called after each scene.
    ///
    /// # Errors
    /// If the disk refuses.
    pub fn commit_if_due(&mut self) -> Result<(), Error> {
        self.note()?;
        if self.pace.is_due() { self.save() } else { Ok(()) }
    }

    /// Notes the present lengths of the tables as a consistent state.
    fn note(&mut self) -> Result<(), Error> {
        for (file, table) in &mut self.tables {
            self.state.committed.insert((*file).to_owned(), table.flush()?);
            self.state.digests.insert((*file).to_owned(), table.digest());
        }
        Ok(())
    }

    /// Makes the noted state permanent: first the tables, then the state that lists them.
    fn save(&mut self) -> Result<(), Error> {
        let start = Instant::now();
        self.tables.values().try_for_each(CsvFile::sync)?;
        self.state.write(&self.folder)?;
        self.pace.took(start.elapsed());
        Ok(())
    }

    /// Commits, if it is due, the rows of a backend on the scene at this place of the whole selection. The folder of a
    /// part, which has the table `segments.csv`, records their place.
    ///
    /// # Errors
    /// If the disk refuses.
    pub fn commit_of(&mut self, place: u64, backend: &str) -> Result<(), Error> {
        if let Some(mut segments) = self.tables.remove(SegmentRow::FILE) {
            for (file, table) in &mut self.tables {
                let bytes = table.flush()?;
                if self.state.committed.get(*file) != Some(&bytes) {
                    let (backend, table) = (backend.to_owned(), (*file).to_owned());
                    segments.append(&SegmentRow { place, backend, table, bytes })?;
                }
            }
            self.tables.insert(SegmentRow::FILE, segments);
        }
        self.commit_if_due()
    }

    /// Appends the cost of a scene. Costs are not part of a commit: a killed run may have noted a scene twice, and the
    /// last note counts.
    ///
    /// # Errors
    /// If the disk refuses.
    pub fn cost(&mut self, rows: &[CostRow]) -> Result<(), Error> {
        if rows.is_empty() { Ok(()) } else { self.costs.append(&self.folder, rows) }
    }

    /// Appends rows of a table byte for byte.
    pub(super) fn append_bytes(&mut self, file: &str, rows: &[u8]) -> Result<(), Error> {
        match self.tables.get_mut(file) {
            Some(table) => table.append_bytes(rows),
            None => Err(Error::new(&self.folder.join(file), "a run folder has no such table")),
        }
    }

    /// Keeps a PNG picture, such as a pixel map, for the HTML page. [`RunDir::map_name`] gives the name for a scene on
    /// a backend.
    ///
    /// # Errors
    /// If the disk refuses, or the name is not a plain file name.
    pub fn add_map(&mut self, name: &str, png: &[u8]) -> Result<(), Error> {
        let maps = self.folder.join(MAPS);
        let plain = !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':', '\0']);
        if !plain {
            return Err(Error::new(&maps, format!("`{name}` can't be a file's name")));
        }
        make_folder(&maps)?;
        let file = format!("{name}.png");
        replace(&maps.join(&file), png)?;
        self.state.digests.insert(map_key(&file), digest(png));
        Ok(())
    }

    /// Records the end of the run, and ends the writing. For an interrupted run, rows since the last commit are
    /// removed, as after a kill: they belong to an unfinished scene.
    ///
    /// # Errors
    /// If the disk refuses.
    pub fn finish(mut self, outcome: Outcome) -> Result<(), Error> {
        if matches!(outcome, Outcome::Interrupted | Outcome::Unfinished) {
            for (file, table) in &mut self.tables {
                table.cut(self.state.committed.get(*file).copied().unwrap_or(0))?;
            }
        } else {
            self.note()?;
            self.tables.values().try_for_each(CsvFile::check)?;
        }
        self.costs.sync(&self.folder)?;
        self.state.outcome = outcome;
        self.save()
    }
}

/// The schedule of commits: the first one is made permanent, and later ones as often as costs at most a hundredth of
/// the time. After a kill or a power cut, the run repeats the work since the last permanent commit.
#[derive(Default)]
struct Pace {
    /// The end of the last commit, and its duration.
    last: Option<(Instant, Duration)>,
}

impl Pace {
    /// The time between two commits, as a multiple of a commit's duration.
    const REST: u32 = 99;

    fn is_due(&self) -> bool {
        self.last.is_none_or(|(end, took)| end.elapsed() >= took.saturating_mul(Pace::REST))
    }

    fn took(&mut self, time: Duration) {
        self.last = Some((Instant::now(), time));
    }
}

/// Removes the tables of a run that was ended before its first commit. Tables with rows are not removed: there, the
/// state was lost.
fn clear(folder: &Path) -> Result<(), Error> {
    if let Some(table) = State::lost(folder)? {
        let message = "it has rows, but state.json is missing; restore state.json from a copy, or start a new run";
        return Err(Error::new(&folder.join(table), message));
    }
    tables(folder)?.into_iter().try_for_each(|path| fs::remove_file(&path).map_err(Error::io(&path)))
}
