//! Rows of numbers, written in a suite.

use predicament_predicates::Dimension;

use crate::CorpusError;
use crate::document::Field;

/// The kind of a list's rows: names and limits for reading and errors.
pub struct RowKind {
    /// The name of a row.
    pub name: &'static str,
    /// The allowed numbers of values in a row.
    pub widths: std::ops::RangeInclusive<usize>,
    /// The name of a row's numbers.
    pub numbers: &'static str,
    /// The fix for a row with another number of values.
    pub cure: &'static str,
}

/// The row kind of a point with two or three coordinates.
pub const POINT: RowKind = RowKind {
    name: "point",
    widths: 2..=3,
    numbers: "coordinates",
    cure: "give all points two or all three coordinates",
};

/// Rows of equal length, one after the other, and the line of each row.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Rows {
    /// The number of values in a row.
    pub width: usize,
    /// All numbers, row after row.
    pub numbers: Vec<f64>,
    /// The line of each row, from 1.
    pub lines: Vec<usize>,
}

impl RowKind {
    /// Compares the length of a row with the first row's, or the header's.
    pub(crate) fn check(&self, expected: &mut Option<usize>, index: usize, found: usize) -> Result<(), String> {
        let RowKind { name, numbers, widths, .. } = self;
        let before = *expected.get_or_insert(found);
        if !widths.contains(&before) {
            Err(format!("{name} {index} has {found} {numbers}"))
        } else if found == before {
            Ok(())
        } else if index == 0 {
            Err(format!("{name} {index} has {found} {numbers}, but there are {before} columns"))
        } else {
            Err(format!("{name} {index} has {found} {numbers}, but earlier {name}s have {before}"))
        }
    }
}

impl Rows {
    /// The rows as points.
    #[must_use]
    pub fn points(self) -> (Dimension, Vec<f64>) {
        (if self.width == 2 { Dimension::Two } else { Dimension::Three }, self.numbers)
    }
}

/// Reads points in a suite, one array each.
pub fn read_points(field: &Field<'_, '_>) -> Result<(Dimension, Vec<f64>), CorpusError> {
    read_rows(field, &POINT).map(Rows::points)
}

/// Reads rows of numbers in a suite, one array each.
pub fn read_rows(field: &Field<'_, '_>, kind: &RowKind) -> Result<Rows, CorpusError> {
    let RowKind { name, numbers: of, .. } = kind;
    let rows = field.items(&format!("an array of {name}s, or {{ path = \"{name}s.csv\" }}"))?;
    let mut width = None;
    let (mut numbers, mut lines) = (Vec::with_capacity(rows.len() * 3), Vec::with_capacity(rows.len()));
    for (index, row) in rows.enumerate() {
        let cells = row.items(&format!("a {name}: an array of {of}"))?;
        kind.check(&mut width, index, cells.len()).map_err(|message| row.error(message, kind.cure))?;
        for cell in cells {
            numbers.push(cell.coordinate()?);
        }
        lines.push(row.line());
    }
    let none = || field.error(format!("a scene without {name}s"), format!("write at least one {name}"));
    Ok(Rows { width: width.ok_or_else(none)?, numbers, lines })
}
