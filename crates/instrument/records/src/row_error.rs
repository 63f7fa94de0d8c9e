//! Errors in the values of a row.

use crate::rows::MOST;

/// An error in the values of a row, beyond their types.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum RowError {
    /// A count that no run reaches.
    Count(u64),
    /// A number that is invalid in its column.
    Number {
        /// The column.
        column: &'static str,
        /// The number.
        value: f64,
        /// The kind of number in the column, with its article: `a time`.
        wanted: &'static str,
    },
    /// A column is empty.
    Empty {
        /// The column.
        column: &'static str,
    },
    /// Values that contradict each other; the message, in one line.
    Contradiction(&'static str),
}

impl RowError {
    /// Checks that a run can reach a count.
    ///
    /// # Errors
    /// [`RowError::Count`] if the count is too large.
    pub(crate) fn check_count(count: u64) -> Result<(), RowError> {
        if count > MOST { Err(RowError::Count(count)) } else { Ok(()) }
    }

    /// Checks that a column's number is a time.
    ///
    /// # Errors
    /// [`RowError::Number`] if the number is not finite and positive.
    pub(crate) fn check_time(column: &'static str, value: f64) -> Result<(), RowError> {
        if value.is_finite() && value > 0.0 {
            Ok(())
        } else {
            Err(RowError::Number { column, value, wanted: "a time" })
        }
    }
}

impl std::fmt::Display for RowError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            RowError::Count(count) => write!(f, "the count {count} is larger than any run can reach; restore the file"),
            RowError::Number { column, value, wanted } => write!(f, "{column} is {value}, which is not {wanted}"),
            RowError::Empty { column } => write!(f, "{column} is empty"),
            RowError::Contradiction(what) => f.write_str(what),
        }
    }
}

impl std::error::Error for RowError {}
