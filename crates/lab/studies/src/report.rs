//! The files and the report of a study.

use std::fmt::Display;
use std::path::Path;

use predicament_records::replace;
use predicament_report::Picture;
use serde::Serialize;

use crate::Error;

/// A file that a study writes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// The file's name, with the extension; a path if it goes to another folder than the rest.
    pub name: String,
    /// The contents of the file.
    pub bytes: Vec<u8>,
}

impl File {
    /// A file with this name.
    pub fn new(name: impl Into<String>, contents: impl Into<Vec<u8>>) -> File {
        File { name: name.into(), bytes: contents.into() }
    }

    /// A plot as SVG and as PDF, with this name before the extension; no files without a picture.
    pub fn plot(name: impl Display, picture: impl Into<Option<Picture>>) -> Vec<File> {
        let Some(Picture { svg, pdf }) = picture.into() else { return Vec::new() };
        let svg = File::new(format!("{name}.svg"), svg);
        [svg].into_iter().chain(pdf.map(|pdf| File::new(format!("{name}.pdf"), pdf))).collect()
    }

    /// The contents as text; empty if they are not text.
    #[must_use]
    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.bytes).unwrap_or_default()
    }

    /// Rows as CSV, under a header of their fields' names.
    ///
    /// # Errors
    /// [`Error::Format`] for rows that CSV cannot hold.
    pub fn csv(name: impl Into<String>, rows: impl IntoIterator<Item = impl Serialize>) -> Result<File, Error> {
        let mut csv = csv::Writer::from_writer(Vec::new());
        rows.into_iter().try_for_each(|row| csv.serialize(row)).map_err(Error::format)?;
        Ok(File::new(name, csv.into_inner().map_err(Error::format)?))
    }
}

/// The complete output of a study.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Report {
    /// The text for standard output: the page, or the rows if the arguments ask for them.
    pub printed: String,
    /// The rows, the page, plots and suites.
    pub files: Vec<File>,
    /// True if every promise that the study tests held.
    pub holds: bool,
}

impl Report {
    /// Writes all files to an existing folder; it makes other folders.
    ///
    /// # Errors
    /// The path that cannot be written, and why.
    pub fn write(&self, folder: &Path) -> Result<(), predicament_records::Error> {
        self.files.iter().try_for_each(|file| {
            let path = folder.join(&file.name);
            if let Some(parent) = path.parent().filter(|parent| *parent != folder) {
                std::fs::create_dir_all(parent).map_err(predicament_records::Error::io(parent))?;
            }
            replace(&path, &file.bytes)
        })
    }
}
