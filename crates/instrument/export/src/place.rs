//! Files that come into their places together, when all are whole.
//!
//! Each is written beside its place. Only when every one is finished do they move; an error or an interrupt leaves the files of an earlier
//! export, and none of this one.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use predicament_records::{Beside, Error, Hold, make_folder};

/// The files of an export, which are removed unless they are kept.
pub(crate) struct Places {
    folder: PathBuf,
    /// The names that the files will have.
    files: Vec<(String, Beside)>,
    /// The files of two exports into one folder are not mixed.
    _hold: Hold,
}

impl Places {
    pub fn new(folder: &Path) -> Result<Places, Error> {
        make_folder(folder)?;
        let hold = Hold::take(&folder.join("tables"), "export")?;
        Ok(Places { folder: folder.to_owned(), files: Vec::new(), _hold: hold })
    }

    /// Where the file of this name will be.
    pub fn place(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// An empty file that will have this name.
    pub fn start(&mut self, name: &str) -> Result<File, Error> {
        let place = self.place(name);
        let beside = Beside::new(&place)?;
        let file = beside.file().try_clone().map_err(Error::io(&place))?;
        self.files.push((name.to_owned(), beside));
        Ok(file)
    }

    /// Refuses a folder in which there are files with this ending of another export: they would look like files of this one.
    pub fn check_others(&self, ending: &str) -> Result<(), Error> {
        for entry in fs::read_dir(&self.folder).map_err(Error::io(&self.folder))? {
            let path = entry.map_err(Error::io(&self.folder))?.path();
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            if name.ends_with(&format!(".{ending}")) && self.files.iter().all(|(own, _)| *own != name) {
                let message = "this export has no such table, and the file would look like one of it; remove it, or name another folder";
                return Err(Error::new(&path, message));
            }
        }
        Ok(())
    }

    /// Moves all files into their places; their names and lengths.
    pub fn keep(self) -> Result<Vec<(PathBuf, u64)>, Error> {
        let length = |(name, beside): &(String, Beside)| Ok((self.folder.join(name), beside.length()?));
        let kept = self.files.iter().map(length).collect::<Result<_, Error>>()?;
        Beside::keep(self.files.into_iter().map(|(_, beside)| beside).collect())?;
        Ok(kept)
    }
}
