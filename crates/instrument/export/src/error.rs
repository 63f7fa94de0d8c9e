//! The reasons why a row of a run folder is not in its table.

use std::path::PathBuf;

use parquet::errors::ParquetError;
use predicament_records::with_cure;

/// The reason why a table is not written.
#[derive(Debug)]
pub(crate) enum WriteError {
    Csv(csv::Error),
    Io(std::io::Error),
    Parquet(ParquetError),
    /// A value does not have its column's type.
    Type(String),
}

impl From<csv::Error> for WriteError {
    fn from(error: csv::Error) -> WriteError {
        WriteError::Csv(error)
    }
}

impl From<std::io::Error> for WriteError {
    fn from(error: std::io::Error) -> WriteError {
        WriteError::Io(error)
    }
}

impl From<ParquetError> for WriteError {
    fn from(error: ParquetError) -> WriteError {
        WriteError::Parquet(error)
    }
}

/// The message ends with a fix if the operating system reports the cause.
impl std::fmt::Display for WriteError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let of_system = match self {
            WriteError::Io(error) => Some(error),
            WriteError::Csv(error) => match error.kind() {
                csv::ErrorKind::Io(error) => Some(error),
                _ => None,
            },
            WriteError::Parquet(ParquetError::External(error)) => error.downcast_ref(),
            WriteError::Parquet(_) | WriteError::Type(_) => None,
        };
        match (of_system, self) {
            (Some(error), _) => f.write_str(&with_cure(error)),
            (None, WriteError::Csv(error)) => error.fmt(f),
            (None, WriteError::Io(error)) => error.fmt(f),
            (None, WriteError::Parquet(error)) => error.fmt(f),
            (None, WriteError::Type(value)) => write!(f, "{value} in a column of another type"),
        }
    }
}

/// A cell whose value its column cannot have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct WrongCell {
    pub cell: String,
    pub column: String,
    /// The kind of values that the column has.
    pub wanted: &'static str,
}

impl std::fmt::Display for WrongCell {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let WrongCell { cell, column, wanted } = self;
        write!(f, "`{cell}` in column `{column}` is not {wanted}")
    }
}

/// The reason why a line of a run folder is not in its table.
#[derive(Debug)]
pub(crate) enum LineError {
    /// The header of the file differs from the table's columns, which are given.
    Head(Vec<String>),
    /// The number of cells in the line differs from the table's number of columns.
    Cells {
        found: usize,
        columns: usize,
    },
    Cell(WrongCell),
    Write {
        place: PathBuf,
        error: WriteError,
    },
}

impl From<WrongCell> for LineError {
    fn from(cell: WrongCell) -> LineError {
        LineError::Cell(cell)
    }
}

impl std::fmt::Display for LineError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            LineError::Head(columns) => write!(f, "the columns must be {}", columns.join(",")),
            LineError::Cells { found, columns } => write!(f, "there are {found} cells for {columns} columns"),
            LineError::Cell(cell) => cell.fmt(f),
            LineError::Write { place, error } => write!(f, "{} can't be written: {error}", place.display()),
        }
    }
}
