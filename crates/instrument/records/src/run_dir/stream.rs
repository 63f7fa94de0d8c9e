//! Reading a run folder row by row, so that a table may be larger than memory.
//!
//! [`RunDir`](super::RunDir) holds all of a folder in memory, as a report needs it. Code that only copies rows reads
//! them one at a time: up to the length in the folder's state, and for a complete run to the last byte.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, StringRecord};
use sha2::{Digest, Sha256};

use super::csv_file::{Extent, failed};
use super::hashed::hex;
use super::lock::Lock;
use super::sealed::read_json;
use super::state::{Outcome, State};
use super::{ENV, PLAN, TABLES};
use crate::{Env, Error, FORMAT, Plan};

/// A run folder whose tables stay on the disk.
#[derive(Clone, PartialEq, Debug)]
pub struct RunFolder {
    /// The folder, as the caller named it.
    pub path: PathBuf,
    /// The planned work.
    pub plan: Plan,
    /// The machine.
    pub env: Env,
    /// The end of the run.
    pub outcome: Outcome,
    /// True if a process is writing the folder now.
    pub is_being_written: bool,
    state: State,
}

impl RunFolder {
    /// True if a folder is a run folder.
    #[must_use]
    pub fn is_one(folder: &Path) -> bool {
        folder.join(PLAN).is_file()
    }

    /// True if a folder is a run folder without its `plan.json`: it has a state, or a table of every run with rows.
    ///
    /// A table of the same name with other columns is not a run's table, but for example an export.
    ///
    /// # Errors
    /// If the folder has such a table that can't be read.
    pub fn has_lost_plan(folder: &Path) -> Result<bool, Error> {
        if RunFolder::is_one(folder) {
            return Ok(false);
        }
        let mut is_lost = !State::is_missing(folder);
        for table in TABLES {
            is_lost = is_lost || has_rows(&folder.join(table.file), table.columns)?;
        }
        Ok(is_lost)
    }

    /// The machine of a run; the rest of the folder is not read.
    ///
    /// # Errors
    /// If `env.json` can't be read.
    pub fn env(folder: &Path) -> Result<Env, Error> {
        read_json(&folder.join(ENV))
    }

    /// The run in a folder.
    ///
    /// # Errors
    /// If a file can't be read; the error names the file and line.
    pub fn open(folder: &Path) -> Result<RunFolder, Error> {
        let plan: Plan = read_json(&folder.join(PLAN))?;
        if plan.format > FORMAT {
            let message = format!("the run has format {}, and this tool reads formats up to {FORMAT}", plan.format);
            return Err(Error::new(folder, message));
        }
        let is_being_written = Lock::is_taken(folder)?;
        let state = State::read(folder)?;
        let outcome = state.outcome;
        Ok(RunFolder { path: folder.to_owned(), plan, env: RunFolder::env(folder)?, outcome, is_being_written, state })
    }

    /// The files of the run's tables, sorted: committed tables, even if their files are missing, and tables in the
    /// folder.
    ///
    /// # Errors
    /// If the folder can't be read, or its state lists a name that is not a table's.
    pub fn tables(&self) -> Result<BTreeSet<String>, Error> {
        let mut files: BTreeSet<String> = self.state.committed.keys().cloned().collect();
        for entry in fs::read_dir(&self.path).map_err(Error::io(&self.path))? {
            let name = entry.map_err(Error::io(&self.path))?.file_name();
            files.extend(name.to_str().filter(|file| file.ends_with(".csv")).map(str::to_owned));
        }
        match files.iter().find(|file| file.contains(['/', '\\'])) {
            Some(strange) => {
                Err(Error::new(&self.path, format!("state.json names `{strange}`, which is not a table of the folder")))
            }
            None => Ok(files),
        }
    }

    /// Calls a function with each record of a table and its line: the header first, as line 1, then each row.
    ///
    /// Rows that an incomplete run has written after its last finished scene are left out; the number of their bytes is
    /// returned.
    ///
    /// # Errors
    /// If the caller's function fails, a row has another number of fields, or a table of a complete run has changed. A
    /// change is found only at the end: the caller then has to discard what it made of the rows.
    pub fn each_row(
        &self,
        file: &str,
        mut each: impl FnMut(u64, &StringRecord) -> Result<(), Error>,
    ) -> Result<u64, Error> {
        let path = self.path.join(file);
        if !fs::metadata(&path).map_err(Error::io(&path))?.is_file() {
            return Err(Error::new(&path, "it is not a regular file (a folder, a pipe or a device)"));
        }
        let mut open = File::open(&path).map_err(Error::io(&path))?;
        let found = open.metadata().map_err(Error::io(&path))?.len();
        let extent = Extent::of(&self.state, file);
        let length = match extent {
            Extent::Lines => last_line_end(&mut open, found).map_err(Error::io(&path))?,
            Extent::All(length) | Extent::First(length) => length,
        };
        extent.check(found, &path)?;
        let mut reader = Digesting { from: BufReader::new(open.take(length)), sum: Sha256::new() };
        {
            let mut rows = ReaderBuilder::new().from_reader(&mut reader);
            each(1, rows.headers().map_err(|error| failed(&path, &error))?)?;
            let mut record = StringRecord::new();
            while rows.read_record(&mut record).map_err(|error| failed(&path, &error))? {
                each(record.position().map_or(0, csv::Position::line), &record)?;
            }
        }
        if self.state.digests.get(file).is_some_and(|written| *written != hex(&reader.sum.finalize())) {
            return Err(Error::new(&path, "it was edited after the run was complete; restore the file"));
        }
        Ok(found - length)
    }
}

/// A reader that computes the digest of the bytes read.
struct Digesting<R> {
    from: R,
    sum: Sha256,
}

impl<R: Read> Read for Digesting<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let count = self.from.read(into)?;
        self.sum.update(&into[..count]);
        Ok(count)
    }
}

/// The number of bytes up to the end of the last whole line; rewinds the file to its start.
fn last_line_end(file: &mut File, length: u64) -> io::Result<u64> {
    const BLOCK: u64 = 1 << 16;
    let mut end = length;
    let mut block = Vec::new();
    while end > 0 {
        let start = end.saturating_sub(BLOCK);
        file.seek(SeekFrom::Start(start))?;
        block.clear();
        Read::by_ref(file).take(end - start).read_to_end(&mut block)?;
        if let Some(at) = block.iter().rposition(|&byte| byte == b'\n') {
            end = start + at as u64 + 1;
            break;
        }
        end = start;
    }
    file.seek(SeekFrom::Start(0))?;
    Ok(end)
}

/// True if a file is a table with these columns and at least one row.
fn has_rows(path: &Path, columns: &[&str]) -> Result<bool, Error> {
    if !path.is_file() {
        return Ok(false);
    }
    let mut file = BufReader::new(fs::File::open(path).map_err(Error::io(path))?);
    let header = columns.join(",");
    let mut first = Vec::new();
    file.by_ref().take(header.len() as u64 + 2).read_until(b'\n', &mut first).map_err(Error::io(path))?;
    let has_header = first.trim_ascii_end() == header.as_bytes() && first.ends_with(b"\n");
    Ok(has_header && !file.fill_buf().map_err(Error::io(path))?.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_whole_line_is_found_from_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        for (text, end) in [("a\nb\ncut", 4), ("a\n", 2), ("cut", 0), ("", 0)] {
            fs::write(&path, text).unwrap();
            assert_eq!(last_line_end(&mut File::open(&path).unwrap(), text.len() as u64).unwrap(), end, "{text:?}");
        }
        let long = format!("a\n{}", "x".repeat(200_000));
        fs::write(&path, &long).unwrap();
        assert_eq!(last_line_end(&mut File::open(&path).unwrap(), long.len() as u64).unwrap(), 2);
    }
}
