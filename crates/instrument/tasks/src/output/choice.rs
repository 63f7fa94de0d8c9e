//! The files that a user chooses of an answer.

use std::collections::BTreeSet;

use super::Error;

/// The names of the files that are wanted.
pub(super) type Wanted = BTreeSet<String>;

/// The formats and parts of an answer that a user names; everything that is written by default if both are empty.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Choice {
    /// File name extensions without a dot: `geojson`.
    pub formats: Vec<String>,
    /// File names without extensions: `union`.
    pub parts: Vec<String>,
}

/// The request that causes a file to be written.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum When {
    /// No request: the file is written unless other files are chosen.
    Always,
    /// The user names the file's format or part.
    Named,
    /// The user names the file's format.
    Format,
}

/// A file that an answer has.
pub(super) struct Offer {
    pub(super) name: String,
    pub(super) when: When,
    /// The remark if the file is written only when its format is named.
    pub(super) note: Option<String>,
}

impl Offer {
    /// The part and the format.
    fn split(&self) -> [&str; 2] {
        self.name.rsplit_once('.').map_or([&self.name, ""], |(part, format)| [part, format])
    }
}

impl Choice {
    /// The wanted files, and remarks about files that wait for a request.
    ///
    /// # Errors
    /// [`Error`] if no file has a format or a part that the user names.
    pub(super) fn of(&self, offers: Vec<Offer>) -> Result<(Wanted, Vec<String>), Error> {
        let mut formats = Vec::new();
        for format in &self.formats {
            let known = offers.iter().map(|offer| offer.split()[1]);
            formats.push(Error::known("format", format, format.trim_start_matches('.'), known)?);
        }
        let mut parts = Vec::new();
        for part in &self.parts {
            parts.push(Error::known("part", part, part, offers.iter().map(|offer| offer.split()[0]))?);
        }
        // A part that has no file by default is named for all of its files.
        let is_late = |part: &str| offers.iter().all(|offer| offer.split()[0] != part || offer.when != When::Always);
        let fits = |offer: &Offer| {
            let [part, format] = offer.split();
            let is_named = |names: &[String], name: &str| names.iter().any(|named| named == name);
            if !parts.is_empty() && !is_named(&parts, part) || !formats.is_empty() && !is_named(&formats, format) {
                return Fit::Other;
            }
            match offer.when {
                When::Always => Fit::Wanted,
                _ if !formats.is_empty() => Fit::Wanted,
                When::Named if !parts.is_empty() && is_late(part) => Fit::Wanted,
                When::Named | When::Format => Fit::Waiting,
            }
        };
        let (mut wanted, mut notes) = (Wanted::new(), Vec::new());
        for offer in &offers {
            match fits(offer) {
                Fit::Wanted => drop(wanted.insert(offer.name.clone())),
                Fit::Waiting => notes.extend(offer.note.clone()),
                Fit::Other => {}
            }
        }
        let is_written = |at: usize, name: &String| {
            offers.iter().any(|offer| offer.split()[at] == name && wanted.contains(&offer.name))
        };
        if let Some(format) = formats.iter().find(|format| !is_written(1, format)) {
            let of = offers.iter().filter(|offer| offer.split()[1] == format).map(|offer| offer.split()[0]);
            return Err(Error::none("format", format, of));
        }
        if let Some(part) = parts.iter().find(|part| !is_written(0, part)) {
            let of = offers.iter().filter(|offer| offer.split()[0] == part).map(|offer| offer.split()[1]);
            return Err(Error::none("part", part, of));
        }
        Ok((wanted, notes))
    }
}

/// The relation of a file to a choice.
enum Fit {
    Wanted,
    /// The file is written only if its format is named.
    Waiting,
    Other,
}
