//! The page "which backend for what": its tables and sentences with figures, made from the files of studies.
//!
//! The page has marks (`<!-- predicament: which NAME -->`), and a report puts these parts between them. A part is made
//! from rows of files in the folder of a run, and holds for every run. A part whose file is missing is an error with
//! the file's name.

mod breaks;
mod conditioning;
mod curves;
mod files;
mod kinds;
mod pieces;
mod promises;
mod words;

use crate::folder::FolderError;
use std::path::Path;

use files::Files;

/// A function that makes a part.
type Make = fn(&Files) -> Result<String, FolderError>;

/// The prefix of all part names.
const PREFIX: &str = "which ";

/// The parts, in the order of the page.
const PARTS: [(&str, Make); 20] = [
    ("tree", |_| Ok(format!("```text\n{}```", super::tree::text()))),
    ("scenes", words::scenes),
    ("words", words::backends),
    ("promises", promises::promises),
    ("ranking", promises::ranking),
    ("short", promises::five),
    ("general", kinds::general),
    ("near", kinds::near),
    ("degenerate", kinds::degenerate),
    ("rule", promises::rule),
    ("curves", curves::curves),
    ("stages", curves::stages),
    ("conditioning", conditioning::wrong),
    ("bits", conditioning::bits),
    ("breaks", breaks::breaks),
    ("laws", breaks::laws),
    ("cut", pieces::cut),
    ("parity", pieces::parity),
    ("ablation", |files| crate::ablation::saved(&files.ablation()?)),
    ("sources", |files| Ok(crate::decimals::sources(&files.decimals()?))),
];

/// A part of the page, made from files that studies have written into the folder of a run; `None` for an unknown name.
///
/// Studies have folders there: `compare`, `curves` (a comparison of backends that differ in one parameter), `stress`,
/// `cut`, `parity`, `parity-space`, `decimals` and `ablation`.
///
/// # Errors
/// [`FolderError`] with the file that is missing or wrong, or with the known names.
#[must_use]
pub fn part(folder: &Path, name: &str) -> Option<Result<String, FolderError>> {
    let name = name.strip_prefix(PREFIX)?;
    let make = PARTS.iter().find(|(known, _)| *known == name).map(|(_, make)| make);
    Some(make.map_or_else(
        || {
            let known = PARTS.iter().map(|(name, _)| *name).collect();
            Err(FolderError::UnknownPart { name: format!("{PREFIX}{name}"), known })
        },
        |make| make(&Files::of(folder)).map(|text| text.trim().to_owned()),
    ))
}
