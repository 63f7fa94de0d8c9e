//! The section about devices in a report.

use std::path::Path;

use predicament_records::format::significant;
use predicament_report::{Block, Cell, Section, Table, Tone};

use super::row::{Group, columns};
use super::table::MEANING;
use super::{FILE, Row};
use crate::folder::{FolderError, plots_in, rows_of};

/// The section of a report from a folder that the study has written; `None` if the folder has no such file.
///
/// # Errors
/// [`FolderError`] with the file and the reason.
pub fn section(folder: &Path) -> Result<Option<Section>, FolderError> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(None);
    }
    let rows: Vec<Row> = rows_of(&path, "ablation")?;
    let columns = columns(&rows);
    let mut table = Table::new("").words(["input"]).numbers(["inputs"]).numbers(columns.iter().copied());
    for group in Group::all(&rows) {
        let of = |column: &&str| {
            group.of(column).map_or_else(Cell::default, |(mean, [low, high])| {
                let [mean, low, high] = [mean, low, high].map(|x| significant(x, 3));
                Cell::from(mean).detail(format!("{low} to {high}"))
            })
        };
        let head = [Cell::from(group.name.as_str()), Cell::count(group.inputs() as u64)];
        table.push(head.into_iter().chain(columns.iter().map(of)).collect());
    }
    let mut blocks = vec![Block::Table(table), Block::Note(MEANING.to_owned(), Tone::Muted)];
    let unequal = rows.iter().filter(|row| row.answers == "unequal").count();
    if unequal > 0 {
        let note = format!("{unequal} rows have other answers without the device than with it.");
        blocks.push(Block::Note(note, Tone::Notable));
    }
    blocks.extend(plots_in(folder, "ablation", "Time without a device over the time of the whole")?);
    Ok(Some(Section {
        id: "ablation",
        title: "What each device saves",
        lead: format!(
            "Variants of `exact` lack one device each, and give the same answers. Each takes turns with the whole on the same scenes. The numbers are made from rows of {}, which also have the quartiles.",
            path.display()
        ),
        blocks,
    }))
}
