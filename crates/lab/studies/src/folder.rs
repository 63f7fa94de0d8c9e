//! The files of a study, read back for a report.

use std::path::{Path, PathBuf};

use predicament_report::{Block, Picture};
use serde::de::DeserializeOwned;

/// The reason why a study's files cannot be read back.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum FolderError {
    /// A file or a folder cannot be read.
    Unread {
        /// The file or folder.
        path: PathBuf,
        /// The message of the operating system, or of the reader.
        why: String,
    },
    /// A row does not fit the table.
    Row {
        /// The file.
        path: PathBuf,
        /// The line of the row, from 1.
        line: usize,
        /// The error of the row.
        why: String,
        /// The command that writes the file.
        command: String,
    },
    /// A table is empty.
    NoRows {
        /// The file.
        path: PathBuf,
    },
    /// A table lacks rows that a page needs.
    Lacks {
        /// The file, in the folder of a run.
        file: &'static str,
        /// The missing rows.
        what: String,
    },
    /// No part of a page has this name.
    UnknownPart {
        /// The unknown name.
        name: String,
        /// The known names.
        known: Vec<&'static str>,
    },
}

impl std::fmt::Display for FolderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            FolderError::Unread { path, why } => write!(f, "{}: {why}", path.display()),
            FolderError::Row { path, line, why, command } => {
                write!(f, "{}:{line}: {why}; recreate the file with `predicament study {command}`", path.display())
            }
            FolderError::NoRows { path } => write!(f, "{}: the table has no rows", path.display()),
            FolderError::Lacks { file, what } => write!(f, "{file} has no {what}"),
            FolderError::UnknownPart { name, known } => {
                write!(f, "no part is called `{name}`; the parts are {}", known.join(", "))
            }
        }
    }
}

impl std::error::Error for FolderError {}

/// The rows of a table that `predicament COMMAND` writes.
///
/// # Errors
/// [`FolderError`] with the file, and the wrong line.
pub fn rows_of<T: DeserializeOwned>(path: &Path, command: &str) -> Result<Vec<T>, FolderError> {
    let mut rows = csv::Reader::from_path(path)
        .map_err(|why| FolderError::Unread { path: path.to_owned(), why: why.to_string() })?;
    let row = |(at, row): (usize, Result<T, csv::Error>)| {
        // Below a header, counted from one.
        row.map_err(|why| FolderError::Row {
            path: path.to_owned(),
            line: at + 2,
            why: why.to_string(),
            command: command.to_owned(),
        })
    };
    rows.deserialize().enumerate().map(row).collect()
}

/// The plots of a folder with this name, or whose names begin with it and a dash, in their order.
///
/// # Errors
/// [`FolderError`] with the folder or the file, and why it can't be read.
pub fn plots_in(folder: &Path, name: &str, alt: &str) -> Result<Vec<Block>, FolderError> {
    let failed = |path: &Path, why: std::io::Error| FolderError::Unread { path: path.to_owned(), why: why.to_string() };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|why| failed(folder, why))? {
        let path = entry.map_err(|why| failed(folder, why))?.path();
        let (Some(stem), Some(extension)) = (path.file_stem(), path.extension()) else { continue };
        let stem = stem.to_string_lossy().into_owned();
        let is_it = stem == name || stem.strip_prefix(name).is_some_and(|rest| rest.starts_with('-'));
        if is_it && extension == "svg" {
            files.push((stem, path));
        }
    }
    files.sort();
    let plot = |(stem, path): (String, std::path::PathBuf)| {
        let svg = std::fs::read_to_string(&path).map_err(|why| failed(&path, why))?;
        let beside = path.with_extension("pdf");
        let pdf = match std::fs::read(&beside) {
            // Earlier versions did not write PDFs.
            Err(why) if why.kind() == std::io::ErrorKind::NotFound => None,
            read => Some(read.map_err(|why| failed(&beside, why))?),
        };
        let picture = Picture { svg, pdf };
        Ok(Block::Plot { picture, file: format!("{stem}.svg").into(), alt: format!("{alt} ({stem})").into() })
    };
    files.into_iter().map(plot).collect()
}
