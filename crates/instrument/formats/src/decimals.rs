//! The reading of a scene's decimals: lossless or refused, or rounded if the suite requests it.

use std::cell::{Cell, RefCell};

use crate::Kept;
use crate::coordinate::{self, CoordinateError};

/// The maximum number of coordinates in a scene: 2 GiB of doubles.
pub const MOST_COORDINATES: usize = 1 << 28;

/// The reader of one scene's decimals. It refuses decimals that no double is printed as; with `round = true` it takes
/// their nearest doubles and counts them.
#[derive(Debug, Default)]
pub struct Decimals {
    round: bool,
    read: Cell<usize>,
    rounded: Cell<usize>,
    /// The texts that were read, if they are kept.
    kept: Option<RefCell<Kept>>,
}

impl Decimals {
    /// A reader that rounds decimals that no double is printed as, or refuses them.
    #[must_use]
    pub fn new(round: bool) -> Decimals {
        Decimals { round, ..Decimals::default() }
    }

    /// The same reader, which keeps the texts if `keeps`: see [`Decimals::kept`].
    #[must_use]
    pub fn keeping(self, keeps: bool) -> Decimals {
        Decimals { kept: keeps.then(RefCell::default), ..self }
    }

    /// True if the texts are kept.
    pub(crate) fn keeps(&self) -> bool {
        self.kept.is_some()
    }

    /// The texts that were read so far; none if they are not kept.
    #[must_use]
    pub fn kept(&self) -> Kept {
        self.kept.as_ref().map(|kept| kept.borrow().clone()).unwrap_or_default()
    }

    /// True if decimals are rounded.
    #[must_use]
    pub fn round(&self) -> bool {
        self.round
    }

    /// The number of decimals rounded so far.
    #[must_use]
    pub fn rounded(&self) -> usize {
        self.rounded.get()
    }

    /// The double that a text denotes.
    ///
    /// # Errors
    /// [`CoordinateError`] if the text is not a number, if no double is printed as it and rounding is off, or if it
    /// would be more than the [`MOST_COORDINATES`]th.
    pub fn read(&self, text: &str) -> Result<f64, CoordinateError> {
        self.count(1)?;
        let read = self.or_nearest(coordinate::read(text));
        if let (Some(kept), Ok(x)) = (&self.kept, &read) {
            kept.borrow_mut().keep(*x, text);
        }
        read
    }

    /// The single that a text denotes, as a double; for values declared as singles.
    ///
    /// # Errors
    /// As [`read`](Decimals::read).
    pub fn read_single(&self, text: &str) -> Result<f64, CoordinateError> {
        self.count(1)?;
        self.or_nearest(coordinate::read_single(text).map(f64::from))
    }

    /// The number that was read; for inexact text, the nearest number if rounding is on, and its count grows.
    fn or_nearest(&self, read: Result<f64, CoordinateError>) -> Result<f64, CoordinateError> {
        match read {
            Err(CoordinateError::Inexact { nearest }) if self.round => {
                self.rounded.set(self.rounded.get() + 1);
                Ok(nearest)
            }
            other => other,
        }
    }

    /// Counts coordinates that are read; an error if the scene has too many.
    pub(crate) fn count(&self, more: usize) -> Result<(), CoordinateError> {
        self.read.set(self.read.get() + more);
        if self.read.get() > MOST_COORDINATES { Err(CoordinateError::TooMany) } else { Ok(()) }
    }
}

/// The kind of place where a coordinate is written, which determines the fix in errors.
#[derive(Clone, Copy, Debug)]
pub enum Place<'f> {
    /// A file that `corpus fmt` can rewrite.
    Tidied(&'f str),
    /// Some columns of such a file, as `--columns` names them.
    Columns(&'f str, &'f str),
    /// Another data file.
    Data,
}

/// The message about a coordinate error, and its fix.
#[must_use]
pub fn explain(place: Place<'_>, text: &str, error: &CoordinateError) -> (String, String) {
    let text = shown(text);
    match error {
        CoordinateError::Malformed => {
            (format!("`{text}` is not a number"), "write a decimal or a hex float such as 0x1.8p+1".into())
        }
        CoordinateError::NotFinite => (format!("coordinate `{text}` is not finite"), "remove the point".into()),
        CoordinateError::Overflow => {
            (format!("coordinate `{text}` is beyond the largest double"), "scale the scene by a power of two".into())
        }
        CoordinateError::Underflow => (
            format!("coordinate `{text}` is not zero but below half the smallest double"),
            "write 0 or scale the scene by a power of two".into(),
        ),
        CoordinateError::TooManyBits => (
            format!("hex float `{text}` has more bits than a double"),
            "keep 53 bits, the lowest not below 2^-1074".into(),
        ),
        CoordinateError::TooLong { bytes } => (
            format!("a number of {bytes} bytes: `{text}`"),
            format!("write at most {}: every double has a shorter decimal", coordinate::MOST_BYTES),
        ),
        CoordinateError::TooMany => {
            (format!("a scene of over {MOST_COORDINATES} coordinates"), "divide the scene".into())
        }
        CoordinateError::Inexact { .. } => {
            let cure = match place {
                Place::Tidied(file) => {
                    format!(
                        "run `predicament corpus fmt {file}` and use the file that it writes, or write `round = true` in the scene"
                    )
                }
                Place::Columns(file, columns) => format!(
                    "run `predicament corpus fmt {file} --columns {columns}` and use the file that it writes, or write `round = true` in the scene"
                ),
                Place::Data => "write `round = true` in the scene to read the nearest double".into(),
            };
            (format!("decimal {text} has digits that no double holds"), cure)
        }
    }
}

/// The text for use in a message: shortened if long, with control characters escaped.
#[must_use]
pub fn shown(text: &str) -> String {
    const MOST: usize = 60;
    let mut shown = String::new();
    for (at, c) in text.chars().enumerate() {
        if at == MOST {
            shown.push('…');
            break;
        }
        if c.is_control() { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    shown
}

/// A text shortened to at most `most` characters: the beginning and the end of a longer one.
#[must_use]
pub(crate) fn ends(text: &str, most: usize) -> String {
    let length = text.chars().count();
    if length <= most {
        return text.to_owned();
    }
    let half = most / 2;
    text.chars().take(half).chain(['…']).chain(text.chars().skip(length - half)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_double_is_refused_or_counted() {
        let exact = Decimals::new(false);
        assert_eq!(exact.read("0.5"), Ok(0.5));
        assert_eq!(exact.read("0.1000000000000000001"), Err(CoordinateError::Inexact { nearest: 0.1 }));
        assert_eq!(exact.rounded(), 0);
        let nearest = Decimals::new(true);
        assert_eq!((nearest.read("0.5"), nearest.rounded()), (Ok(0.5), 0));
        assert_eq!((nearest.read("0.1000000000000000001"), nearest.rounded()), (Ok(0.1), 1));
        for (text, error) in [
            ("1e400", CoordinateError::Overflow),
            ("1e-400", CoordinateError::Underflow),
            ("nan", CoordinateError::NotFinite),
            ("0x1.00000000000008p+0", CoordinateError::TooManyBits),
            ("x", CoordinateError::Malformed),
        ] {
            assert_eq!(nearest.read(text), Err(error), "{text}: rounding cures no other error");
        }
        assert_eq!(nearest.rounded(), 1);
    }

    #[test]
    fn singles_are_rounded_once() {
        let exact = Decimals::new(false);
        assert_eq!(exact.read_single("0.5"), Ok(0.5));
        assert_eq!(exact.read_single("0x1p-3"), Ok(0.125));
        let tenth = f64::from(0.1_f32);
        assert_eq!(exact.read_single("0.1"), Ok(tenth));
        // A double that is not a single.
        let double = format!("{:.60}", 0.1_f64);
        assert_eq!(exact.read_single(&double), Err(CoordinateError::Inexact { nearest: tenth }));
        let nearest = Decimals::new(true);
        assert_eq!((nearest.read_single("0.1000000001"), nearest.read_single(&double)), (Ok(tenth), Ok(tenth)));
        assert_eq!(nearest.rounded(), 2);
        assert_eq!(nearest.read_single("1e39"), Err(CoordinateError::Overflow));
        assert_eq!(nearest.read_single("1e-60"), Err(CoordinateError::Underflow));
    }

    #[test]
    fn there_are_only_so_many() {
        let decimals = Decimals { read: Cell::new(MOST_COORDINATES - 1), ..Decimals::default() };
        assert_eq!(decimals.read("1"), Ok(1.0));
        assert_eq!(decimals.read("1"), Err(CoordinateError::TooMany));
    }

    #[test]
    fn messages_stay_short_and_printable() {
        assert_eq!(shown("a\0b\u{1b}[1m"), "a\\u{0}b\\u{1b}[1m");
        assert_eq!(shown(&"9".repeat(100)), format!("{}…", "9".repeat(60)));
        assert_eq!(ends("abcdé", 5), "abcdé");
        assert_eq!(ends("abcdéf", 4), "ab…éf");
    }
}
