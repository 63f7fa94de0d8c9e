//! The writer of a table in any format.

use crate::error::WriteError;
use crate::value::Value;

/// A table to which rows are added. The same rows give the same bytes.
pub(crate) trait Sink {
    /// Adds a row: its cells as text, and their values.
    fn push(&mut self, cells: &[&str], values: &[Value<'_>]) -> Result<(), WriteError>;

    /// Writes the remaining rows.
    fn finish(self: Box<Self>) -> Result<(), WriteError>;
}
