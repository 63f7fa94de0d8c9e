//! A table that rows are added to, whatever its format.

use crate::error::WriteError;
use crate::value::Value;

/// A table that rows are added to. The same rows give the same bytes.
pub(crate) trait Sink {
    /// Adds a row: its cells as text, and what they say.
    fn push(&mut self, cells: &[&str], values: &[Value<'_>]) -> Result<(), WriteError>;

    /// Writes what is left.
    fn finish(self: Box<Self>) -> Result<(), WriteError>;
}
