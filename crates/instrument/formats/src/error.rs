//! Errors about files, on one line: the place, the problem, and the fix.

use std::fmt;

use crate::decimals::ends;

/// The party that has to act on an error; the tool's exit code depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ErrorKind {
    /// The command names something that does not exist (exit code 2).
    Usage,
    /// A suite, a data file or the cache is invalid (exit code 104).
    Corpus,
}

/// A position in a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Position {
    /// A line of a text, counted from 1.
    Line(usize),
    /// A byte of a binary file, counted from 0; in a packed file, counted after unpacking.
    Byte(usize),
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Position::Line(line) => write!(f, "line {line}"),
            Position::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// An error with its place and its fix.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CorpusError {
    /// The party that has to act.
    pub kind: ErrorKind,
    /// The file as the user knows it, or the requested thing if there is no file.
    pub file: String,
    /// The position in the file, if the error is about one place.
    pub position: Option<Position>,
    /// The problem.
    pub message: String,
    /// The fix.
    pub cure: String,
}

impl CorpusError {
    /// An error about a file as a whole.
    #[must_use]
    pub fn file(file: impl Into<String>, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        CorpusError {
            kind: ErrorKind::Corpus,
            file: file.into(),
            position: None,
            message: message.into(),
            cure: cure.into(),
        }
    }

    /// An error about something that the user requested and that does not exist.
    #[must_use]
    pub fn usage(what: impl Into<String>, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        CorpusError { kind: ErrorKind::Usage, ..CorpusError::file(what, message, cure) }
    }

    /// Sets the error's position to a line.
    #[must_use]
    pub fn at_line(self, line: usize) -> CorpusError {
        self.at(Some(Position::Line(line)))
    }

    /// Sets the error's position to a byte of a binary file, counted from 0.
    #[must_use]
    pub fn at_byte(self, byte: usize) -> CorpusError {
        self.at(Some(Position::Byte(byte)))
    }

    /// Sets the error's position; `None` is for errors about the file as a whole.
    #[must_use]
    pub fn at(self, position: Option<Position>) -> CorpusError {
        CorpusError { position, ..self }
    }

    /// The line in the file, counted from 1, if the error is at a line.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self.position {
            Some(Position::Line(line)) => Some(line),
            Some(Position::Byte(_)) | None => None,
        }
    }

    /// Moves the error to the line of another file that refers to this file; the message then names this file.
    #[must_use]
    pub fn named_by(self, file: &str, line: usize) -> CorpusError {
        let message = format!("{}: {}", self.place(), self.message);
        CorpusError { message, ..CorpusError { file: file.to_owned(), ..self }.at_line(line) }
    }

    /// The file, and the line or the byte if known.
    fn place(&self) -> String {
        match self.position {
            Some(Position::Line(line)) => format!("{}:{line}", self.file),
            Some(Position::Byte(byte)) => format!("{}: at byte {byte}", self.file),
            None => self.file.clone(),
        }
    }
}

/// The maximum length of a message, in characters: messages of other libraries quote the input.
const MOST: usize = 500;

/// The text on one line: messages of other libraries may span lines, but ours must not.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl fmt::Display for CorpusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.place(), ends(&one_line(&self.message), MOST), one_line(&self.cure))
    }
}

impl std::error::Error for CorpusError {}
