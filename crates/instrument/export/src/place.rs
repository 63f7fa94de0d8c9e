//! Files that are moved into place together, when all are complete.
//!
//! Each file is written beside its place. They move only when all are finished. After an error or an interrupt the
//! folder still has only the files of the earlier export.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use predicament_records::{Beside, Error, Hold, make_folder};

/// The files of an export, which are removed unless they are kept.
pub(crate) struct Places {
    folder: PathBuf,
    /// The final names of the files.
    files: Vec<(String, Beside)>,
    /// A lock, so that two exports into one folder do not mix their files.
    _hold: Hold,
}

impl Places {
    pub fn new(folder: &Path) -> Result<Places, Error> {
        make_folder(folder)?;
        let hold = Hold::take(&folder.join("tables"), "export")?;
        Ok(Places { folder: folder.to_owned(), files: Vec::new(), _hold: hold })
    }

    /// The final path of the file with this name.
    pub fn place(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Creates an empty file that will get this name.
    pub fn start(&mut self, name: &str) -> Result<File, Error> {
        let place = self.place(name);
        let beside = Beside::new(&place)?;
        let file = beside.file().try_clone().map_err(Error::io(&place))?;
        self.files.push((name.to_owned(), beside));
        Ok(file)
    }

    /// Refuses a folder that has files with this ending from another export: they would look like files of this one.
    pub fn check_others(&self, ending: &str) -> Result<(), Error> {
        for entry in fs::read_dir(&self.folder).map_err(Error::io(&self.folder))? {
            let path = entry.map_err(Error::io(&self.folder))?.path();
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            if name.ends_with(&format!(".{ending}")) && self.files.iter().all(|(own, _)| *own != name) {
                let message = "this export does not have this table, so the file would look like a part of it; \
                               remove the file, or name another folder";
                return Err(Error::new(&path, message));
            }
        }
        Ok(())
    }

    /// Moves all files into place; returns their paths and sizes.
    pub fn keep(self) -> Result<Vec<(PathBuf, u64)>, Error> {
        let length = |(name, beside): &(String, Beside)| Ok((self.folder.join(name), beside.length()?));
        let kept = self.files.iter().map(length).collect::<Result<_, Error>>()?;
        Beside::keep(self.files.into_iter().map(|(_, beside)| beside).collect())?;
        Ok(kept)
    }
}
