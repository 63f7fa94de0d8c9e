//! What a study has written, read back for a report.

use std::path::Path;

use predicament_report::{Block, Picture};
use serde::de::DeserializeOwned;

/// The rows of a table that `predicament COMMAND` writes.
///
/// # Errors
/// One line with the file, and the line that is wrong.
pub fn rows_of<T: DeserializeOwned>(path: &Path, command: &str) -> Result<Vec<T>, String> {
    let mut rows = csv::Reader::from_path(path).map_err(|why| format!("{}: {why}", path.display()))?;
    let row = |(at, row): (usize, Result<T, csv::Error>)| {
        // Under a header, from one on.
        row.map_err(|why| format!("{}:{}: {why}; write it anew with `predicament {command}`", path.display(), at + 2))
    };
    rows.deserialize().enumerate().map(row).collect()
}

/// The plots of a folder whose names are this, or begin with this and a dash, in their order.
///
/// # Errors
/// One line with the folder or the file, and why it can't be read.
pub fn plots_in(folder: &Path, name: &str, alt: &str) -> Result<Vec<Block>, String> {
    let failed = |path: &Path, why: std::io::Error| format!("{}: {why}", path.display());
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|why| failed(folder, why))? {
        let path = entry.map_err(|why| failed(folder, why))?.path();
        let (Some(stem), Some(extension)) = (path.file_stem(), path.extension()) else { continue };
        let stem = stem.to_string_lossy().into_owned();
        let is_it = stem == name || stem.strip_prefix(name).is_some_and(|rest| rest.starts_with('-'));
        if is_it && extension == "svg" {
            files.push((stem, path));
        }
    }
    files.sort();
    let plot = |(stem, path): (String, std::path::PathBuf)| {
        let svg = std::fs::read_to_string(&path).map_err(|why| failed(&path, why))?;
        let beside = path.with_extension("pdf");
        let pdf = match std::fs::read(&beside) {
            // Earlier versions wrote none.
            Err(why) if why.kind() == std::io::ErrorKind::NotFound => None,
            read => Some(read.map_err(|why| failed(&beside, why))?),
        };
        let picture = Picture { svg, pdf };
        Ok(Block::Plot { picture, file: format!("{stem}.svg").into(), alt: format!("{alt} ({stem})").into() })
    };
    files.into_iter().map(plot).collect()
}
