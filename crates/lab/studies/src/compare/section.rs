//! The comparison in a report: the ranking, plots, and the long table after them.

use std::path::Path;

use predicament_report::{Block, Section, Tone};

use super::measure::read;
use super::{Promise, details, ranking};
use crate::folder::{FolderError, plots_in, rows_of};

/// The main file of this study's folder.
pub(super) const FILE: &str = "compare.csv";
/// The file with the promises of the backends.
pub(super) const PROMISES: &str = "promises.csv";

const ID: &str = "compare";
const TITLE: &str = "Which backend for what";

/// The section of a report without a comparison: instructions to make one in this folder.
#[must_use]
pub fn missing(folder: &Path) -> Section {
    let lead = "The folders of these runs do not contain a comparison of backends. This command makes one; every later report then shows its table:";
    let command = format!("predicament study compare --out {}", folder.display());
    Section { id: ID, title: TITLE, lead: lead.to_owned(), blocks: vec![Block::Command(command)] }
}

/// The section of a report from a folder that the study has written; `None` if the folder has no such file.
///
/// # Errors
/// [`FolderError`] with the file, and the wrong line.
pub fn section(folder: &Path) -> Result<Option<Section>, FolderError> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(None);
    }
    let measures = read(&path)?;
    let promises = folder.join(PROMISES);
    // Earlier versions did not write promises.
    let promises: Vec<Promise> = if promises.exists() { rows_of(&promises, "compare")? } else { Vec::new() };
    let mut blocks = vec![
        Block::Table(ranking::table(&measures, &promises)),
        Block::Note(format!("{} {}", ranking::MEANING, ranking::rule(&measures)), Tone::Muted),
    ];
    blocks.extend(plots_in(folder, "error-time", "Errors against time, over the inputs of each backend")?);
    blocks.extend(curves(folder)?);
    blocks.push(Block::Table(details::table(&measures, None, Some(&path))));
    blocks.push(Block::Note(details::MEANING.to_owned(), Tone::Muted));
    blocks.extend(plots_in(
        folder,
        "conditioning",
        "Wrong answers per million by degeneracy of the query; shaded: zeros within a band, which the promise allows",
    )?);
    Ok(Some(Section {
        id: ID,
        title: TITLE,
        lead: format!(
            "Backends of all philosophies on the same scenes, best first. The order is by the share of scenes that are neither wrong nor left undone, then by time. Each number comes from rows of {}, which also have its interval and its denominator.",
            path.display()
        ),
        blocks,
    }))
}

/// The plots of a comparison of backends that differ in one parameter.
///
/// The plots are in the folder `curves` beside the folder of the comparison.
fn curves(folder: &Path) -> Result<Vec<Block>, FolderError> {
    let beside = folder.with_file_name("curves");
    if !beside.join(FILE).exists() {
        return Ok(Vec::new());
    }
    let plots = plots_in(
        &beside,
        "error-time",
        "One parameter turned: errors against time, over the inputs that all backends of a curve answered",
    )?;
    let renamed = |block: Block| match block {
        Block::Plot { picture, file, alt } => Block::Plot { picture, file: format!("curves-{file}").into(), alt },
        other => other,
    };
    Ok(plots.into_iter().map(renamed).collect())
}
