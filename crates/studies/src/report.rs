//! The files of a study.

use predicament_records::replace;
use std::path::Path;

use serde::Serialize;

use crate::Error;

/// A file that a study writes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// Its name, with the extension; a path where it goes to another folder than the rest.
    pub name: String,
    /// Its contents.
    pub text: String,
}

impl File {
    /// A file with this name.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> File {
        File { name: name.into(), text: text.into() }
    }

    /// Rows as CSV, under a header of their fields' names.
    ///
    /// # Errors
    /// [`Error::Format`] for rows that CSV cannot hold.
    pub fn csv(name: impl Into<String>, rows: impl IntoIterator<Item = impl Serialize>) -> Result<File, Error> {
        let mut csv = csv::Writer::from_writer(Vec::new());
        rows.into_iter().try_for_each(|row| csv.serialize(row)).map_err(Error::format)?;
        let bytes = csv.into_inner().map_err(Error::format)?;
        Ok(File { name: name.into(), text: String::from_utf8(bytes).map_err(Error::format)? })
    }
}

/// Everything that a study has to show.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Report {
    /// What goes to standard output: the page, or the rows where the arguments ask for them.
    pub printed: String,
    /// The rows, the page, plots and suites.
    pub files: Vec<File>,
    /// Whether every promise held that the study is about.
    pub holds: bool,
}

impl Report {
    /// Writes all files to a folder that exists; other folders are made.
    ///
    /// # Errors
    /// One line with the path that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), String> {
        self.files.iter().try_for_each(|file| {
            let path = folder.join(&file.name);
            if let Some(parent) = path.parent().filter(|parent| *parent != folder) {
                std::fs::create_dir_all(parent).map_err(|error| format!("{}: {error}", parent.display()))?;
            }
            replace(&path, file.text.as_bytes()).map_err(|error| error.to_string())
        })
    }
}
