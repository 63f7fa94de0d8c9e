//! Compiled estimates of the shipped predicates, so that these need no interpreter.

#[rustfmt::skip] // the generator writes it
#[allow(clippy::pedantic, clippy::let_and_return)]
mod written;

use crate::{CATALOGUE, Definition};

/// The compiled estimate of a predicate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compiled {
    /// The value in doubles; NaN for other numbers of points or coordinates.
    pub(crate) estimate: fn(&[&[f64]]) -> f64,
    /// The value in doubles, and the magnitude that it must exceed for its sign to be certain.
    pub(crate) bounded: fn(&[&[f64]]) -> [f64; 2],
}

impl Compiled {
    /// The compiled estimate of a definition about points of so many coordinates; `None` if it is not that of a shipped
    /// predicate.
    pub(crate) fn of(definition: &Definition, dimension: usize) -> Option<Compiled> {
        let entry = CATALOGUE.iter().find(|entry| entry.name == definition.name)?;
        let shipped = entry.definition();
        let is_same =
            (&shipped.text, &shipped.points, entry.dimension) == (&definition.text, &definition.points, dimension);
        if is_same { written::named(entry.name) } else { None }
    }
}
