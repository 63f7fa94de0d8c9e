//! Errors about the files of a run folder: the file, the line, the message.

use std::fmt;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// An error in a file of a run folder.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Error {
    /// The file or folder.
    pub path: PathBuf,
    /// The line of the error in the file, from 1, if the error is in one line.
    pub line: Option<u64>,
    /// The message, in one line.
    pub message: String,
}

impl Error {
    /// An error without a line.
    #[must_use]
    pub fn new(path: &Path, message: impl Into<String>) -> Error {
        Error { path: path.to_owned(), line: None, message: message.into() }
    }

    /// An error with a line.
    #[must_use]
    pub fn at(path: &Path, line: u64, message: impl Into<String>) -> Error {
        Error { path: path.to_owned(), line: Some(line), message: message.into() }
    }

    /// Turns an operating system error into an error about this file, for `map_err`.
    pub fn io(path: &Path) -> impl FnOnce(std::io::Error) -> Error {
        move |error| Error::new(path, with_cure(&error))
    }

    /// Turns an error of locking into an error about this file: some shared file systems do not support locks.
    #[must_use]
    pub fn no_locks(path: &Path, error: std::io::Error) -> Error {
        if error.kind() == ErrorKind::Unsupported {
            Error::new(path, format!("{error}: the file system has no locks; name a folder on a disk of this machine"))
        } else {
            Error::io(path)(error)
        }
    }

    /// Turns a JSON error into an error about this file, for `map_err`; the line moves from the message to its field.
    pub fn json(path: &Path) -> impl FnOnce(serde_json::Error) -> Error {
        move |error| {
            let text = error.to_string();
            let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
            match u64::try_from(error.line()) {
                Ok(line) if line > 0 => Error::at(path, line, message),
                _ => Error::new(path, message),
            }
        }
    }
}

/// An operating system error as text, with a fix if one is known for its kind.
#[must_use]
pub fn with_cure(error: &std::io::Error) -> String {
    let cure = match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => "free some space and resume: finished work is kept",
        ErrorKind::FileTooLarge => "raise the file size limit and resume: finished work is kept",
        ErrorKind::ReadOnlyFilesystem => "make it writable, or name another place",
        ErrorKind::NotFound => "name an existing path, or create it",
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => "a file is in the place of a folder; name another place",
        ErrorKind::IsADirectory => "it is a folder; name a file",
        ErrorKind::PermissionDenied => "name another place, or get permission to use it",
        _ => return error.to_string(),
    };
    format!("{error}; {cure}")
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        // Other libraries quote the text that they found, including line breaks.
        let words: Vec<&str> = self.message.split_whitespace().collect();
        write!(f, ": {}", words.join(" "))
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_one_line_whatever_it_quotes() {
        let error = Error::at(Path::new("run/summary.csv"), 13, "unknown variant `\nmine,a\r\n`, expected `ok`");
        assert_eq!(error.to_string(), "run/summary.csv:13: unknown variant ` mine,a `, expected `ok`");
        assert_eq!(Error::new(Path::new("my run/a  b"), "gone").to_string(), "my run/a  b: gone");
    }
}
