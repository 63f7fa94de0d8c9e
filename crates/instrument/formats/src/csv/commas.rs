//! Decimal commas: `0,5` in a file whose cells are separated by semicolons.
//!
//! A comma may also separate thousands. It counts as a decimal comma if all decimals of the file use commas: then the
//! file does not have another decimal sign. The points of hex floats do not count.

use std::borrow::Cow;

use super::cells::Separator;
use crate::coordinate::{self, CoordinateError};
use crate::decimals::shown;
use crate::hexfloat;

/// The decimal signs in the numbers of a file so far.
#[derive(Default)]
pub(super) struct Commas {
    /// The first number with a comma, and its line.
    comma: Option<(String, usize)>,
    /// The first number with a point, and its line.
    point: Option<(String, usize)>,
}

impl Commas {
    /// The text of a number with a decimal comma replaced by a point. An error is a message and its cure.
    pub(super) fn number<'c>(
        &mut self,
        separator: Option<Separator>,
        cell: &'c str,
        line: usize,
    ) -> Result<Cow<'c, str>, (String, String)> {
        if separator != Some(Separator::Character(b';')) || hexfloat::looks_like(cell) {
            return Ok(Cow::Borrowed(cell));
        }
        let (has_comma, has_point) = (cell.contains(','), cell.contains('.'));
        if has_comma && has_point {
            let message = format!("`{}` has a comma and a point", shown(cell));
            return Err((message, "remove thousands separators, and use one decimal sign".to_owned()));
        }
        if !has_comma && !has_point {
            return Ok(Cow::Borrowed(cell));
        }
        let (own, other, [sign, other_sign]) = match has_comma {
            true => (&mut self.comma, &self.point, ["comma", "point"]),
            false => (&mut self.point, &self.comma, ["point", "comma"]),
        };
        if let Some((text, before)) = other {
            let message = format!(
                "`{}` has a {sign}, and `{text}` in line {before} has a {other_sign}: a comma may be a decimal comma \
                 or a thousands separator",
                shown(cell),
            );
            return Err((message, "write all decimals with points, or all with commas".to_owned()));
        }
        own.get_or_insert_with(|| (shown(cell), line));
        Ok(if has_comma { Cow::Owned(cell.replacen(',', ".", 1)) } else { Cow::Borrowed(cell) })
    }

    /// True if a number had a decimal comma.
    pub(super) fn are_decimal(&self) -> bool {
        self.comma.is_some()
    }
}

/// The cure for a cell that is not a number because it has a decimal comma.
pub(super) fn cure(separator: Option<Separator>, cell: &str) -> Option<String> {
    let is_number = |text: &str| coordinate::read(text) != Err(CoordinateError::Malformed);
    let is_cut = separator == Some(Separator::Character(b','))
        && cell.split_whitespace().nth(1).is_some()
        && cell.split_whitespace().all(is_number);
    let has_comma =
        separator != Some(Separator::Character(b';')) && cell.contains(',') && is_number(&cell.replace(',', "."));
    (is_cut || has_comma).then(|| {
        "decimal commas are supported only if `;` separates the cells; separate cells by `;`, or write decimal \
         points"
            .to_owned()
    })
}
