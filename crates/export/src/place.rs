//! Files that come into their places together, when all are whole.
//!
//! Each is written beside its place, under its name with `.next` behind it. Only when every one is finished do they move; an error or an interrupt
//! leaves the files of an earlier export, and none of this one.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};

use predicament_records::Error;

/// The files of an export, which are removed unless they are kept.
pub(crate) struct Places {
    folder: PathBuf,
    /// The names that the files will have, and how many have moved already.
    names: Vec<String>,
    moved: usize,
}

impl Places {
    pub fn new(folder: &Path) -> Result<Places, Error> {
        fs::create_dir_all(folder).map_err(Error::io(folder))?;
        Ok(Places { folder: folder.to_owned(), names: Vec::new(), moved: 0 })
    }

    fn beside(&self, name: &str) -> PathBuf {
        let mut beside = OsString::from(self.folder.join(name));
        beside.push(".next");
        PathBuf::from(beside)
    }

    /// Where the file of this name will be.
    pub fn place(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// An empty file that will have this name. What a killed export has left of it is written over.
    pub fn start(&mut self, name: &str) -> Result<File, Error> {
        let beside = self.beside(name);
        let open = OpenOptions::new().create(true).truncate(false).write(true).open(&beside);
        let file = open.map_err(Error::io(&beside))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let message = "another process is exporting into this folder; wait for its end, or name another";
                return Err(Error::new(&self.folder, message));
            }
            Err(TryLockError::Error(error)) => return Err(Error::io(&beside)(error)),
        }
        file.set_len(0).map_err(Error::io(&beside))?;
        self.names.push(name.to_owned());
        Ok(file)
    }

    /// Refuses a folder in which there are files with this ending of another export: they would look like files of this one. What a killed
    /// export has left beside the places of such files is removed; none is being written, as every export holds its first file.
    pub fn check_others(&self, ending: &str) -> Result<(), Error> {
        for entry in fs::read_dir(&self.folder).map_err(Error::io(&self.folder))? {
            let path = entry.map_err(Error::io(&self.folder))?.path();
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            let left = name.strip_suffix(".next");
            let place = left.unwrap_or(&name);
            if !place.ends_with(&format!(".{ending}")) || self.names.iter().any(|own| own == place) {
                continue;
            }
            if left.is_some() {
                fs::remove_file(&path).map_err(Error::io(&path))?;
            } else {
                let message = "this export has no such table, and the file would look like one of it; remove it, or name another folder";
                return Err(Error::new(&path, message));
            }
        }
        Ok(())
    }

    /// Moves all files into their places; their names and lengths.
    pub fn keep(mut self) -> Result<Vec<(PathBuf, u64)>, Error> {
        let mut kept = Vec::new();
        for name in self.names.clone() {
            let (beside, place) = (self.beside(&name), self.folder.join(&name));
            let length = fs::metadata(&beside).map_err(Error::io(&beside))?.len();
            fs::rename(&beside, &place).map_err(Error::io(&place))?;
            self.moved += 1;
            kept.push((place, length));
        }
        Ok(kept)
    }
}

impl Drop for Places {
    fn drop(&mut self) {
        for name in &self.names[self.moved..] {
            let _ = fs::remove_file(self.beside(name));
        }
    }
}
