//! Errors about files, on one line: the place, what is wrong, and the cure.

use std::fmt;

use crate::decimals::ends;

/// Who has to act on an error; the tool's exit code depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ErrorKind {
    /// The command names something that doesn't exist (exit code 2).
    Usage,
    /// A suite, a data file or the cache is not what it should be (exit code 104).
    Corpus,
}

/// A position in a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Position {
    /// A line of a text, counted from 1.
    Line(usize),
    /// A byte of a binary file, counted from 0; where the file is packed, of what is unpacked.
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

/// An error with its place and its cure.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CorpusError {
    /// Who has to act.
    pub kind: ErrorKind,
    /// The file as the user knows it, or what was asked for where there is no file.
    pub file: String,
    /// Where in the file, if it is about one place.
    pub position: Option<Position>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub cure: String,
}

impl CorpusError {
    /// Something is wrong with a file as a whole.
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

    /// The user asked for something that isn't there.
    #[must_use]
    pub fn usage(what: impl Into<String>, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        CorpusError { kind: ErrorKind::Usage, ..CorpusError::file(what, message, cure) }
    }

    /// The same error, at a line.
    #[must_use]
    pub fn at_line(self, line: usize) -> CorpusError {
        self.at(Some(Position::Line(line)))
    }

    /// The same error, at a byte of a binary file, counted from 0.
    #[must_use]
    pub fn at_byte(self, byte: usize) -> CorpusError {
        self.at(Some(Position::Byte(byte)))
    }

    /// The same error, at a position, or about the file as a whole.
    #[must_use]
    pub fn at(self, position: Option<Position>) -> CorpusError {
        CorpusError { position, ..self }
    }

    /// The line in the file, counted from 1, where the error is at one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self.position {
            Some(Position::Line(line)) => Some(line),
            Some(Position::Byte(_)) | None => None,
        }
    }

    /// The same error at the line of another file that names this one.
    #[must_use]
    pub fn named_by(self, file: &str, line: usize) -> CorpusError {
        let message = format!("{}: {}", self.place(), self.message);
        CorpusError { message, ..CorpusError { file: file.to_owned(), ..self }.at_line(line) }
    }

    /// The file, and the line or the byte where it is known.
    fn place(&self) -> String {
        match self.position {
            Some(Position::Line(line)) => format!("{}:{line}", self.file),
            Some(Position::Byte(byte)) => format!("{}: at byte {byte}", self.file),
            None => self.file.clone(),
        }
    }
}

/// The longest message, in characters: those of other libraries quote what they have found.
const MOST: usize = 500;

/// Messages of other libraries may span lines; ours never do.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl fmt::Display for CorpusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.place(), ends(&one_line(&self.message), MOST), one_line(&self.cure))
    }
}

impl std::error::Error for CorpusError {}
