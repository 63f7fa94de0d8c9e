//! Merging the parts of a run: the result is byte for byte equal to a run on one machine.
//!
//! A part that is missing, repeated, incomplete or of another plan is refused by name. Otherwise a report on a part of
//! the work would look like a report on all of it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::costs::CostRow;
use super::csv_file::check_columns;
use super::lock::{FILE as LOCK, Lock};
use super::regular::header_length;
use super::segments::{Piece, SegmentRow, pieces};
use super::state::State;
use super::{RunDir, RunWriter, TABLES, TableSpec};
use crate::replace::{folder_of, sync_folder};
use crate::{Env, Error, ExpectedFile, Outcome, Plan, PlannedScene, Row, Shard};

/// An error of a merge.
#[derive(Clone, PartialEq, Debug)]
pub struct NotMerged {
    /// The folder, and the message about it.
    pub error: Error,
    /// True if the only error is a part that is missing or incomplete.
    pub is_incomplete: bool,
}

impl From<Error> for NotMerged {
    fn from(error: Error) -> NotMerged {
        NotMerged { error, is_incomplete: false }
    }
}

/// A part as read from its folder, with the places of its rows.
struct Part {
    run: RunDir,
    pieces: BTreeMap<(u64, String), Vec<Piece>>,
    /// The bytes of its tables.
    tables: BTreeMap<String, Vec<u8>>,
    costs: Vec<CostRow>,
}

/// Merges the parts of a run into a new folder: the folders that `run --shard k/N` has written. `tables` are the tables
/// of a run besides the tables that every run has.
///
/// The new folder is complete or absent: it is made beside its place, as `NAME.merging`, and moved there at the end. If
/// a merge was killed, the next merge removes its `NAME.merging`.
///
/// # Errors
/// [`NotMerged`] with the folder of the first part that does not fit, and the reason; nothing is written then. Also if
/// the new folder can't be written.
pub fn merge(
    folders: &[PathBuf],
    out: &Path,
    tables: &[TableSpec],
    env: impl FnOnce(&[RunDir]) -> Env,
) -> Result<RunDir, NotMerged> {
    // If `out` is a link, its target is replaced, and the link stays.
    let led = out.is_symlink().then(|| out.canonicalize().ok()).flatten();
    let out = led.as_deref().unwrap_or(out);
    let open = |folder: &PathBuf| {
        RunDir::open(folder).map_err(|error| NotMerged { error, is_incomplete: RunDir::is_unbegun(folder) })
    };
    let runs: Vec<RunDir> = folders.iter().map(open).collect::<Result<_, _>>()?;
    if let [run] = runs.as_slice()
        && run.plan.shard == Shard::WHOLE
        && !run.plan.timed
    {
        return copied(run, out, tables, &env(&runs));
    }
    let plan = whole(&runs)?;
    let mut parts = BTreeMap::new();
    let env = env(&runs);
    for run in runs {
        let part = Part::read(run)?;
        let places = part.run.plan.whole.iter().flat_map(|whole| whole.places.clone()).collect::<Vec<_>>();
        let part = std::rc::Rc::new(part);
        parts.extend(places.into_iter().map(|place| (place, part.clone())));
    }
    let tables: Vec<TableSpec> = tables.iter().copied().filter(|table| table.file != SegmentRow::FILE).collect();
    let site = Site::new(out)?;
    let mut writer = RunWriter::create(&site.folder, &plan, &env, &tables)?;
    for (place, part) in &parts {
        for backend in &plan.backends {
            for (table, from, to) in part.pieces.get(&(*place, backend.clone())).into_iter().flatten() {
                let bytes = part.tables.get(table).map_or(&[][..], Vec::as_slice);
                let [from, to] = [*from, *to].map(|end| usize::try_from(end).unwrap_or(usize::MAX));
                let rows =
                    bytes.get(from..to).ok_or_else(|| Error::new(&part.run.path.join(table), "it was cut off"))?;
                writer.append_bytes(table, rows)?;
            }
        }
        writer.commit()?;
    }
    for (place, part) in &parts {
        let Some(scene) = usize::try_from(*place).ok().and_then(|place| plan.scenes.get(place)) else { continue };
        let is_its = |row: &&CostRow| [&row.suite, &row.scene] == [&scene.suite, &scene.scene];
        writer.cost(&part.costs.iter().filter(is_its).cloned().collect::<Vec<_>>())?;
    }
    for part in parts.values() {
        for (name, png) in &part.run.maps {
            writer.add_map(name, png)?;
        }
    }
    writer.finish(Outcome::Complete)?;
    site.move_to(out)?;
    Ok(RunDir::open(out)?)
}

/// The only part of a run, which is the whole run, copied to a new folder.
fn copied(run: &RunDir, out: &Path, tables: &[TableSpec], env: &Env) -> Result<RunDir, NotMerged> {
    if !run.is_complete() {
        return Err(not_complete(run));
    }
    let site = Site::new(out)?;
    let mut writer = RunWriter::create(&site.folder, &run.plan, env, tables)?;
    for file in State::read(&run.path)?.committed.keys() {
        let path = run.path.join(file);
        let bytes = fs::read(&path).map_err(Error::io(&path))?;
        check_table(file, &path, &bytes)?;
        let from = usize::try_from(header_length(&bytes)).unwrap_or(bytes.len());
        writer.append_bytes(file, &bytes[from..])?;
    }
    writer.commit()?;
    writer.cost(&CostRow::read(&run.path)?)?;
    for (name, png) in &run.maps {
        writer.add_map(name, png)?;
    }
    writer.finish(Outcome::Complete)?;
    site.move_to(out)?;
    Ok(RunDir::open(out)?)
}

/// The folder in which the parts are merged. It is removed when the value is dropped, unless it was moved.
struct Site {
    folder: PathBuf,
    is_moved: bool,
}

impl Site {
    fn new(out: &Path) -> Result<Site, Error> {
        if out.exists() && Lock::others(out)? {
            return Err(Error::new(out, "the folder is not empty; name another"));
        }
        let mut name =
            out.file_name().ok_or_else(|| Error::new(out, "this can't be made; name a new folder"))?.to_owned();
        name.push(".merging");
        let folder = out.with_file_name(name);
        if folder.join(LOCK).exists() {
            // Refuse while another process uses the folder.
            drop(Lock::take(&folder)?);
            fs::remove_dir_all(&folder).map_err(Error::io(&folder))?;
        }
        Ok(Site { folder, is_moved: false })
    }

    fn move_to(mut self, out: &Path) -> Result<(), Error> {
        // An empty folder may be in its place.
        if out.exists() {
            let _ = fs::remove_file(out.join(LOCK));
            fs::remove_dir(out).map_err(Error::io(out))?;
        }
        fs::rename(&self.folder, out).map_err(Error::io(out))?;
        self.is_moved = true;
        sync_folder(folder_of(out))
    }
}

impl Drop for Site {
    fn drop(&mut self) {
        // If another process writes there, this process failed because of that lock.
        if !self.is_moved && self.folder.join(LOCK).exists() && Lock::take(&self.folder).is_ok() {
            let _ = fs::remove_dir_all(&self.folder);
        }
    }
}

impl Part {
    fn read(run: RunDir) -> Result<Part, Error> {
        let state = State::read(&run.path)?;
        let rows = run.rows::<SegmentRow>()?;
        let mut tables = BTreeMap::new();
        let mut headers = BTreeMap::new();
        for file in state.committed.keys().filter(|file| *file != SegmentRow::FILE) {
            let path = run.path.join(file);
            let bytes = fs::read(&path).map_err(Error::io(&path))?;
            check_table(file, &path, &bytes)?;
            headers.insert(file.clone(), header_length(&bytes));
            tables.insert(file.clone(), bytes);
        }
        let lengths = tables.iter().map(|(file, bytes)| (file.clone(), bytes.len() as u64)).collect();
        let pieces = pieces(&rows, &headers, &lengths)
            .map_err(|error| Error::new(&run.path.join(SegmentRow::FILE), error.to_string()))?;
        let costs = CostRow::read(&run.path)?;
        Ok(Part { run, pieces, tables, costs })
    }
}

/// Refuses a table of every run whose columns differ from those of this version of the tool.
fn check_table(file: &str, path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let table = TABLES.iter().find(|table| table.file == file);
    table.map_or(Ok(()), |table| check_columns(path, bytes, table.columns))
}

/// The maximum number of missing parts that the message names.
const NAMED: usize = 100;

/// The error about a part that is not complete.
fn not_complete(run: &RunDir) -> NotMerged {
    let why = match run.outcome {
        Outcome::Timeout => "ran out of time; run it again in another folder, with a longer --timeout",
        _ => "is not complete; `run --resume` completes it",
    };
    NotMerged { error: Error::new(&run.path, format!("part {} {why}", run.plan.shard)), is_incomplete: true }
}

/// The plan of the whole run that these are the parts of.
fn whole(runs: &[RunDir]) -> Result<Plan, NotMerged> {
    let Some(first) = runs.first() else {
        return Err(Error::new("merge".as_ref(), "name the folders of all parts").into());
    };
    let mut seen: BTreeMap<u32, &RunDir> = BTreeMap::new();
    for run in runs {
        let refuse = |message: String| Err(NotMerged::from(Error::new(&run.path, message)));
        let shard = run.plan.shard;
        if run.plan.timed {
            return refuse("it is a bench: its times belong to one machine and cannot be merged".to_owned());
        }
        if shard == Shard::WHOLE {
            return refuse("it is a whole run, not a part".to_owned());
        }
        if run.plan.whole.is_none() {
            return refuse("a version of the tool that cannot merge parts made it; run it again".to_owned());
        }
        if !run.is_complete() {
            return Err(not_complete(run));
        }
        if let Some(difference) = difference(&first.plan, &run.plan) {
            return refuse(format!("its plan differs from the plan of {}: {difference}", first.path.display()));
        }
        let build = |run: &RunDir| (run.env.package_version.clone(), run.env.commit.clone(), run.env.dirty);
        if build(run) != build(first) {
            return refuse(format!("its build of the tool differs from the build of {}", first.path.display()));
        }
        if let Some(difference) = other_version(&first.env, &run.env) {
            return refuse(format!("a version differs from {}: {difference}; run it again", first.path.display()));
        }
        if let Some(other) = seen.insert(shard.index(), run) {
            return refuse(format!("part {shard} is {} already", other.path.display()));
        }
    }
    let count = first.plan.shard.count();
    let missing: Vec<String> = (1..=count)
        .filter(|index| !seen.contains_key(index))
        .take(NAMED)
        .map(|index| format!("{index}/{count}"))
        .collect();
    if !missing.is_empty() {
        let more = (count as usize - seen.len()).saturating_sub(NAMED);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let missing = missing.join(", ");
        let error = Error::new(&first.path, format!("of the {count} parts, these are missing: {missing}{more}"));
        return Err(NotMerged { error, is_incomplete: true });
    }
    let mut scenes: BTreeMap<u64, PlannedScene> = BTreeMap::new();
    for run in runs {
        let places = run.plan.whole.iter().flat_map(|whole| &whole.places);
        for (place, scene) in places.zip(&run.plan.scenes) {
            if scenes.insert(*place, scene.clone()).is_some() {
                return Err(Error::new(&run.path, format!("scene {place} of the whole is also in another part")).into());
            }
        }
    }
    let expected = first.plan.whole.as_ref().map_or(0, |whole| whole.scenes);
    if scenes.keys().copied().ne(0..expected) {
        let message = format!("the parts have {} scenes of {expected}", scenes.len());
        return Err(Error::new(&first.path, message).into());
    }
    // The paths of files are those of the first part, independently of the order of the folders.
    let first = seen.first_key_value().map_or(first, |(_, run)| run);
    Ok(Plan { scenes: scenes.into_values().collect(), shard: Shard::WHOLE, whole: None, ..first.plan.clone() })
}

/// The first library or engine with different versions in two runs, if any.
fn other_version(one: &Env, other: &Env) -> Option<String> {
    let names = one.peers.keys().chain(other.peers.keys());
    let version = |env: &Env, name: &str| {
        env.peers.get(name).map_or_else(|| "unknown".to_owned(), |version| format!("`{version}`"))
    };
    let differs = |name: &&String| one.peers.get(*name) != other.peers.get(*name);
    names.filter(differs).min().map(|name| format!("{name} is {} and not {}", version(other, name), version(one, name)))
}

/// The difference between the plans of two parts, apart from the part's number; `None` if they agree.
fn difference(one: &Plan, other: &Plan) -> Option<String> {
    let digest = |plan: &Plan| plan.whole.as_ref().map(|whole| whole.digest.clone()).unwrap_or_default();
    let expected = |plan: &Plan| plan.whole.as_ref().and_then(|whole| whole.expected.clone());
    let work = |plan: &Plan| match plan.whole.as_ref().and_then(|whole| whole.plan.as_ref()) {
        Some(hash) => format!("made by the plan {}", hash.get(..12).unwrap_or(hash)),
        None => "made without a plan".to_owned(),
    };
    let backends = |plan: &Plan| plan.backends.join(", ");
    if one.shard.count() != other.shard.count() {
        Some(format!("{} parts and not {}", other.shard.count(), one.shard.count()))
    } else if one.level != other.level {
        Some(format!("level {} and not {}", other.level, one.level))
    } else if one.backends != other.backends {
        Some(format!("backends {} and not {}", backends(other), backends(one)))
    } else if one.suites != other.suites {
        Some(format!("suites {} and not {}", other.suites.join(", "), one.suites.join(", ")))
    } else if digest(one) != digest(other) {
        Some("other scenes, or scenes with other contents".to_owned())
    } else if work(one) != work(other) {
        Some(format!("{} and not {}", work(other), work(one)))
    } else if expected(one) != expected(other) {
        Some("compared with other expectations".to_owned())
    } else {
        let rest = |plan: &Plan| Plan {
            scenes: Vec::new(),
            shard: Shard::WHOLE,
            whole: None,
            paths: BTreeMap::new(),
            expected: plan.expected.clone().map(|expected| ExpectedFile { file: String::new(), ..expected }),
            ..plan.clone()
        };
        (rest(one) != rest(other)).then(|| "other settings (plan.json)".to_owned())
    }
}
