//! Reasons why files of an answer are not written.

use std::path::Path;

/// The largest number of names in a message.
const NAMED: usize = 12;

/// The reason why a file of an answer is not written.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Error {
    /// The file system refuses a file.
    System(predicament_records::Error),
    /// A file, or any file, cannot hold the answer, for example because a vertex of it is not a point.
    Answer {
        /// The file's name; `None` if no file can.
        file: Option<String>,
        /// The reason.
        why: String,
    },
    /// The user names a format or a part that the answer does not have.
    Unknown {
        /// `format` or `part`.
        what: &'static str,
        /// The name.
        name: String,
        /// The names that the answer has, ascending.
        known: Vec<String>,
        /// Remarks about files that the answer does not have.
        notes: Vec<String>,
    },
    /// The user names a format and parts, or a part and formats, and no file has both.
    NoFile {
        /// `format` or `part`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The parts that have the format, or the formats that the part has, ascending.
        known: Vec<String>,
    },
}

impl Error {
    /// The error that a closure has returned while it was writing a file. The operating system's errors have a number.
    pub(super) fn of(path: &Path, name: &str, error: std::io::Error) -> Error {
        if error.raw_os_error().is_some() || error.kind() == std::io::ErrorKind::WriteZero {
            Error::System(predicament_records::Error::io(path)(error))
        } else {
            Error::Answer { file: Some(name.to_owned()), why: error.to_string() }
        }
    }

    /// The name in the spelling of the known ones, whatever its case.
    pub(super) fn known<'n>(
        what: &'static str,
        given: &str,
        name: &str,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> Result<String, Error> {
        let found = known.clone().find(|other| *other == name);
        let found = found.or_else(|| known.clone().find(|other| other.eq_ignore_ascii_case(name)));
        found.map(str::to_owned).ok_or_else(|| Error::Unknown {
            what,
            name: given.to_owned(),
            known: sorted(known),
            notes: Vec::new(),
        })
    }

    /// The error with remarks about files that the answer does not have.
    pub(super) fn with(self, remarks: Vec<String>) -> Error {
        match self {
            Error::Unknown { what, name, known, .. } => Error::Unknown { what, name, known, notes: remarks },
            other => other,
        }
    }

    pub(super) fn none<'n>(what: &'static str, name: &str, known: impl Iterator<Item = &'n str>) -> Error {
        Error::NoFile { what, name: name.to_owned(), known: sorted(known) }
    }
}

fn sorted<'n>(names: impl Iterator<Item = &'n str>) -> Vec<String> {
    let names: std::collections::BTreeSet<&str> = names.collect();
    names.into_iter().map(str::to_owned).collect()
}

/// The first names of a list, and the number of the others.
fn listed(names: &[String]) -> String {
    match names {
        [] => "none".to_owned(),
        _ if names.len() <= NAMED => names.join(", "),
        _ => format!("{} and {} more", names[..NAMED].join(", "), names.len() - NAMED),
    }
}

impl From<predicament_records::Error> for Error {
    fn from(error: predicament_records::Error) -> Error {
        Error::System(error)
    }
}

/// The reason why an answer cannot be prepared for its files.
impl From<std::io::Error> for Error {
    fn from(error: std::io::Error) -> Error {
        Error::Answer { file: None, why: error.to_string() }
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Error::System(error) => error.fmt(f),
            Error::Answer { file: Some(file), why } => write!(f, "{file} can't hold the answer: {why}"),
            Error::Answer { file: None, why } => f.write_str(why),
            Error::Unknown { what, name, known, notes } => {
                write!(f, "the answer has no {what} `{name}`; it has {}", listed(known))?;
                notes.iter().try_for_each(|note| write!(f, "; {note}"))
            }
            Error::NoFile { what: "format", name, known } => {
                write!(f, "no named part has the format `{name}`; the parts that have it are {}", listed(known))
            }
            Error::NoFile { name, known, .. } => {
                write!(f, "part `{name}` does not have any of the named formats; it has {}", listed(known))
            }
        }
    }
}

impl std::error::Error for Error {}
