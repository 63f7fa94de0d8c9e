//! `costs.csv`: the time of each scene on each backend.
//!
//! Times differ from run to run, so the file is not compared byte for byte, and `state.json` does not list it. Rows are
//! appended without a commit: after a kill, the file may have more rows than the state lists. So no digest covers the
//! file. The file serves only to distribute a later run evenly. A wrong time in it makes the parts of that run uneven,
//! and does not change an answer.

use std::fs::{File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, WriterBuilder};

use crate::{Error, PlannedScene, Row};

crate::table! {
    /// `costs.csv`: the cost of one scene on one backend.
    pub struct CostRow [Clone, PartialEq, Eq, Debug] in "costs.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The family of inputs.
        pub family: String,
        /// The backend's name, with its parameters; `truth` for the work that all backends share.
        pub backend: String,
        /// The number of queries.
        pub queries: u64,
        /// The wall time.
        pub wall_us: u64 ["µs"],
        /// The processor time of all threads; for a separate process or an engine, the wall time.
        pub cpu_us: u64 ["µs"],
    }
}

impl CostRow {
    /// The name in the backend column for work that all backends share: reading the scene, computing the truth, and
    /// verdicts about equal answers of several backends.
    pub const TRUTH: &'static str = "truth";

    /// The cost of a scene on a backend.
    #[must_use]
    pub fn new(scene: &PlannedScene, backend: &str, wall_us: u64, cpu_us: u64) -> CostRow {
        let ([suite, name, scene_id, task], family) = (scene.labels(), scene.family.clone());
        let backend = backend.to_owned();
        CostRow { suite, scene: name, scene_id, task, family, backend, queries: scene.queries, wall_us, cpu_us }
    }

    /// The costs in a run folder, in the order of measurement; empty if the file is missing. An incomplete last line is
    /// left out.
    ///
    /// # Errors
    /// If a line is not a cost; the error names the line.
    pub fn read(folder: &Path) -> Result<Vec<CostRow>, Error> {
        let path = folder.join(CostRow::FILE);
        if !path.exists() {
            return Ok(Vec::new());
        }
        let bytes = super::regular::read_regular(&path)?;
        let mut reader = ReaderBuilder::new().from_reader(&bytes[..whole_lines(&bytes)]);
        let failed = |error: csv::Error| {
            let line = error.position().map(csv::Position::line);
            Error { path: path.clone(), line, message: format!("it is not a row of costs: {error}") }
        };
        if *reader.headers().map_err(failed)? != *CostRow::COLUMNS {
            let message = format!("the columns must be {}", CostRow::COLUMNS.join(","));
            return Err(Error::at(&path, 1, message));
        }
        reader.deserialize().map(|row| row.map_err(failed)).collect()
    }
}

/// The bytes up to the end of the last whole line.
fn whole_lines(bytes: &[u8]) -> usize {
    bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1)
}

/// The open file of costs. The first row creates it.
#[derive(Default)]
pub(super) struct CostLog {
    file: Option<File>,
}

impl CostLog {
    /// Appends rows.
    pub fn append(&mut self, folder: &Path, rows: &[CostRow]) -> Result<(), Error> {
        let path = folder.join(CostRow::FILE);
        let mut writer = WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        let failed = |error: csv::Error| Error::new(&path, error.to_string());
        let file = match &mut self.file {
            Some(file) => file,
            None => {
                let (file, is_new) = open(&path)?;
                if is_new {
                    writer.write_record(CostRow::COLUMNS).map_err(failed)?;
                }
                self.file.insert(file)
            }
        };
        rows.iter().try_for_each(|row| writer.serialize(row)).map_err(failed)?;
        let bytes = writer.into_inner().map_err(|error| Error::new(&path, error.to_string()))?;
        file.write_all(&bytes).map_err(Error::io(&path))
    }

    /// Asks the disk to keep what was appended.
    pub fn sync(&self, folder: &Path) -> Result<(), Error> {
        self.file.as_ref().map_or(Ok(()), File::sync_data).map_err(Error::io(&folder.join(CostRow::FILE)))
    }
}

/// The file, cut back to whole lines, and true if it is empty.
fn open(path: &PathBuf) -> Result<(File, bool), Error> {
    let length = match std::fs::read(path) {
        Ok(bytes) => whole_lines(&bytes),
        Err(_) => 0,
    };
    let file = OpenOptions::new().append(true).create(true).open(path).map_err(Error::io(path))?;
    file.set_len(length as u64).map_err(Error::io(path))?;
    Ok((file, length == 0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, wall_us: u64) -> CostRow {
        let text = |text: &str| text.to_owned();
        let (suite, scene, scene_id) = (text("s"), text(scene), text("0123"));
        let scene = PlannedScene { suite, scene, scene_id, task: text("orient2d"), family: text("near"), queries: 3 };
        CostRow::new(&scene, "exact", wall_us, 2 * wall_us)
    }

    #[test]
    fn a_line_that_was_cut_off_is_left_out_and_not_built_upon() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(CostRow::read(folder.path()).unwrap(), []);
        CostLog::default().append(folder.path(), &[row("a", 1), row("b", 2)]).unwrap();
        let path = folder.path().join(CostRow::FILE);
        let whole = std::fs::read(&path).unwrap();
        std::fs::write(&path, &whole[..whole.len() - 3]).unwrap();
        assert_eq!(CostRow::read(folder.path()).unwrap(), [row("a", 1)]);
        CostLog::default().append(folder.path(), &[row("b", 5)]).unwrap();
        assert_eq!(CostRow::read(folder.path()).unwrap(), [row("a", 1), row("b", 5)]);
        std::fs::write(&path, "a,b\n1,2\n").unwrap();
        assert_eq!(CostRow::read(folder.path()).unwrap_err().line, Some(1));
    }
}
