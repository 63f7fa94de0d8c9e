//! The section about break points in a report.

use std::path::Path;

use predicament_report::{Block, Cell, Origin, Section, Table, Tone};
use predicament_tasks::Knob;

use super::table::{counts, place};
use super::{Asked, BreakPoint};
use crate::folder::{FolderError, plots_in, rows_of};

/// The main file of this study's folder.
const FILE: &str = "breaks.csv";

/// The section of a report from a folder that the study has written; `None` if the folder has no such file.
///
/// # Errors
/// [`FolderError`] with the file and the reason.
pub fn section(folder: &Path) -> Result<Option<Section>, FolderError> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(None);
    }
    let rows: Vec<BreakPoint> = rows_of(&path, "stress")?;
    let Asked { ways, backends, tasks } = Asked::of(&rows);
    let mut blocks = Vec::new();
    for [knob, way] in ways {
        let unit = Knob::ALL.iter().find(|of| of.name() == knob).map_or("", |knob| knob.unit());
        let down = if way == "down" { ", down" } else { "" };
        let rounds = rows.iter().find(|row| row.knob == knob).map_or("", |row| &row.rounds);
        let mut table = Table::new(format!("{knob}{down}: {unit}; rounds the scene: {rounds}"))
            .words(["task"])
            .numbers(["scenes"])
            .of(Origin::at(&path).keys(["task"]).across("backend").only("knob", knob).only("way", way))
            .numbers(backends.iter().copied());
        for task in &tasks {
            let of = |backend: &&str| {
                let is = |row: &&BreakPoint| {
                    row.task == *task && row.knob == knob && row.way == way && row.backend == *backend
                };
                rows.iter().find(is).map_or_else(Cell::default, |row| {
                    let tone = match (row.breaks_at, row.declines_at, row.holds_to) {
                        (Some(_), ..) => Tone::Notable,
                        (None, None, Some(_)) => Tone::Good,
                        (None, ..) => Tone::Muted,
                    };
                    Cell::from(place(row)).tone(tone).detail(counts(row).unwrap_or_default())
                })
            };
            let scenes = rows.iter().filter(|row| row.task == *task && row.knob == knob && row.way == way);
            let scenes = Cell::count(scenes.map(|row| row.scenes).max().unwrap_or(0));
            table.push([Cell::from(*task), scenes].into_iter().chain(backends.iter().map(of)).collect());
        }
        blocks.push(Block::Table(table));
        if down.is_empty() {
            blocks.extend(plots_in(
                folder,
                &format!("stress-{knob}"),
                &format!("Shares of wrong scenes, and times, as {knob} is turned"),
            )?);
        }
    }
    Ok(Some(Section {
        id: "stress",
        title: "Where backends break",
        lead: format!(
            "One knob is turned at a time. A cell has the position at which a backend first breaks its promise on a scene, and in parentheses the last position before; - if it never does; d if it \
             only declines; n/a if the knob does not fit the task. Below are the wrong scenes out of those answered there or, if none is wrong, the largest share that this number of scenes leaves possible. A knob that rounds the scene changes the true answers. Each cell is a row of {}.",
            path.display()
        ),
        blocks,
    }))
}
