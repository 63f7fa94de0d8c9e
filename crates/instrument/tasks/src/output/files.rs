//! The files of an answer: the files that there are, the files that are wanted, and their writer.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use predicament_records::{Beside, make_folder};
use serde::Serialize;

use super::choice::{Choice, Offer, When};
use super::{Error, Wanted};

/// The number of complete files that wait for the disk together.
const TOGETHER: usize = 32;

/// The files of one answer.
///
/// A task offers each file by its name, with a closure that makes it. The closure runs only if the file is wanted, so a
/// task does its work inside. A task runs twice: first to list its files, then to write the wanted ones.
pub struct Files {
    mode: Mode,
    /// Every file waits for a request of at least this kind.
    at_least: When,
    notes: Vec<String>,
}

enum Mode {
    /// Closures do not run.
    Listing(Vec<Offer>),
    Writing {
        folder: PathBuf,
        wanted: Wanted,
        /// Complete files that are not yet in their places.
        pending: Vec<Beside>,
        written: Vec<PathBuf>,
    },
}

/// The files that were written, and remarks about them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Written {
    /// The files, in the order in which the task offers them.
    pub files: Vec<PathBuf>,
    /// Remarks for the user, each a sentence without a full stop.
    pub notes: Vec<String>,
}

/// Writes the chosen files of an answer into a folder, which is made if a file is written. `offer` offers all files of
/// the answer; it is called twice.
///
/// A file appears in its place when it is complete.
///
/// # Errors
/// [`Error`] if the choice names what the answer does not have (then nothing is written), if a format cannot hold the
/// answer, or if the file system refuses.
pub fn write(
    folder: &Path,
    choice: &Choice,
    offer: impl Fn(&mut Files) -> Result<(), Error>,
) -> Result<Written, Error> {
    let mut listed = Files { mode: Mode::Listing(Vec::new()), at_least: When::Always, notes: Vec::new() };
    offer(&mut listed)?;
    let Mode::Listing(offers) = listed.mode else { unreachable!("a list stays a list") };
    let (wanted, mut notes) = choice.of(offers).map_err(|error| error.with(listed.notes))?;
    let folder = folder.to_owned();
    let mode = Mode::Writing { folder, wanted, pending: Vec::new(), written: Vec::new() };
    let mut files = Files { mode, at_least: When::Always, notes: Vec::new() };
    offer(&mut files)?;
    files.keep(1)?;
    notes.append(&mut files.notes);
    let Mode::Writing { written, .. } = files.mode else { unreachable!("a writer stays a writer") };
    Ok(Written { files: written, notes })
}

impl Files {
    /// Offers a file, such as `cells.csv`, that is written unless the user chooses others.
    ///
    /// # Errors
    /// [`Error`] if the closure fails, or the file system refuses.
    pub fn write(&mut self, name: &str, make: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), Error> {
        self.offer(name, When::Always, None, make).map(|_| ())
    }

    /// Offers a JSON file that is written unless the user chooses others.
    ///
    /// # Errors
    /// As [`write`](Files::write).
    pub fn json<T: Serialize>(&mut self, name: &str, make: impl FnOnce() -> T) -> Result<(), Error> {
        self.write(name, |out| {
            serde_json::to_writer(&mut *out, &make())?;
            writeln!(out)
        })
    }

    /// Offers a file that is written if the user names its format or its part.
    ///
    /// # Errors
    /// As [`write`](Files::write).
    pub fn on_request(
        &mut self,
        name: &str,
        make: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> Result<(), Error> {
        self.offer(name, When::Named, None, make).map(|_| ())
    }

    /// Offers a file that is written if the user names its format.
    ///
    /// # Errors
    /// As [`write`](Files::write).
    pub fn by_format(
        &mut self,
        name: &str,
        make: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> Result<(), Error> {
        self.offer(name, When::Format, None, make).map(|_| ())
    }

    /// Makes all files that `offer` offers wait for a request: see [`on_request`](Files::on_request).
    ///
    /// # Errors
    /// The error of `offer`.
    pub fn all_on_request(&mut self, offer: impl FnOnce(&mut Files) -> Result<(), Error>) -> Result<(), Error> {
        let before = self.at_least;
        self.at_least = before.max(When::Named);
        let done = offer(self);
        self.at_least = before;
        done
    }

    /// Adds the remark that an algorithm stopped at a rule that does not hold, if it did.
    pub fn broken(&mut self, rule: Option<impl std::fmt::Display>) {
        if let Some(rule) = rule {
            let why = "the backend's signs contradict each other, or the input is invalid";
            self.note(format!("the answer is incomplete: {rule}; {why}"));
        }
    }

    /// Adds a remark for the user: a sentence without a full stop.
    pub fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }

    /// Offers a file; returns true if it was written. The user gets the note if the file only waits for its format to
    /// be named.
    pub(super) fn offer(
        &mut self,
        name: &str,
        when: When,
        note: Option<String>,
        make: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> Result<bool, Error> {
        let when = when.max(self.at_least);
        let (folder, pending, written) = match &mut self.mode {
            Mode::Listing(offers) => {
                offers.push(Offer { name: name.to_owned(), when, note });
                return Ok(false);
            }
            Mode::Writing { wanted, .. } if !wanted.contains(name) => return Ok(false),
            Mode::Writing { folder, pending, written, .. } => (folder, pending, written),
        };
        make_folder(folder)?;
        let path = folder.join(name);
        let beside = Beside::new(&path)?;
        let mut out = BufWriter::new(beside.file());
        make(&mut out).and_then(|()| out.flush()).map_err(|error| Error::of(&path, name, error))?;
        drop(out);
        pending.push(beside);
        written.push(path);
        self.keep(TOGETHER)?;
        Ok(true)
    }

    /// Moves complete files to their places if there are this many.
    fn keep(&mut self, at_least: usize) -> Result<(), Error> {
        match &mut self.mode {
            Mode::Writing { pending, .. } if pending.len() >= at_least => Ok(Beside::keep(std::mem::take(pending))?),
            _ => Ok(()),
        }
    }
}
