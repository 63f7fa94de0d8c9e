//! Typed values of cells.

use crate::error::WrongCell;
use predicament_records::{Kind, moment};

/// A column of an export. Its name may come from a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Typed {
    pub name: String,
    pub kind: Kind,
    pub is_optional: bool,
}

/// The value of a cell.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Value<'t> {
    Null,
    Text(&'t str),
    Int64(i64),
    Float64(f64),
    Bool(bool),
    /// Microseconds since the start of 1970.
    Timestamp(i64),
}

impl Typed {
    /// The value of a cell in this column.
    ///
    /// # Errors
    /// [`WrongCell`] if the column cannot have it.
    pub fn value<'t>(&self, cell: &'t str) -> Result<Value<'t>, WrongCell> {
        if cell.is_empty() && self.is_optional {
            return Ok(Value::Null);
        }
        let wrong = |wanted| WrongCell { cell: cell.to_owned(), column: self.name.clone(), wanted };
        match self.kind {
            Kind::Text => Ok(Value::Text(cell)),
            Kind::Int64 => {
                cell.parse().map(Value::Int64).map_err(|_| wrong("a whole number from -2^63 up to 2^63 - 1"))
            }
            Kind::Float64 => cell.parse().map(Value::Float64).map_err(|_| wrong("a number")),
            Kind::Bool => cell.parse().map(Value::Bool).map_err(|_| wrong("`true` or `false`")),
            Kind::Timestamp => {
                let seconds = moment::seconds(cell).and_then(|seconds| i64::try_from(seconds).ok());
                let seconds = seconds.ok_or_else(|| wrong("a moment like 2026-01-31T23:59:59Z"))?;
                Ok(Value::Timestamp(seconds * 1_000_000))
            }
        }
    }
}
