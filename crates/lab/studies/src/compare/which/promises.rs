//! The promises of backends, their cost, and the ranking.

use crate::folder::FolderError;
use predicament_report::{Cell, Table};

use super::files::Files;
use crate::compare::measure::FEATURES;
use crate::compare::ranking;
use crate::compare::words::{largest, short};

/// The promise of each backend, the smallest feature that it distinguishes, and the error of its contacts.
pub(super) fn promises(files: &Files) -> Result<String, FolderError> {
    let (measures, promises) = (files.measures()?, files.promises()?);
    let mut table = Table::new("").words(["backend", "promise", "proved"]).numbers([
        "smallest feature, 2D, L",
        "3D, L",
        "location, 99 %, L",
        "missed by, 99 %, L",
        "weight, 99 %",
    ]);
    for of in promises {
        let most = |measure: &str, unit: &str| {
            short(largest(&measures, &of.backend, |row| row.measure == measure && row.unit == unit))
        };
        let feature =
            |kind: &str| short(largest(&measures, &of.backend, |row| row.task == FEATURES && row.kind == kind));
        let cells = [
            feature("2D"),
            feature("3D"),
            most("location: 99 %", "L"),
            most("missed by: 99 %", "L"),
            most("weight: 99 %", "of one"),
        ];
        let words = [Cell::code(of.backend), Cell::from(of.promise), Cell::from(if of.proved { "yes" } else { "no" })];
        table.push(words.into_iter().chain(cells.map(Cell::from)).collect());
    }
    Ok(ranking::markdown(table))
}

/// The ranking: each backend over its own scenes, and its time over pairs with the reference.
pub(super) fn ranking(files: &Files) -> Result<String, FolderError> {
    let table = ranking::table(&files.measures()?, &files.promises()?);
    Ok(format!("{}\n\n{}", ranking::markdown(table), ranking::MEANING))
}

/// The backends in five columns.
pub(super) fn five(files: &Files) -> Result<String, FolderError> {
    Ok(ranking::markdown(ranking::short(&files.measures()?, &files.promises()?)))
}

/// The rule for comparing times, and the inputs that it leaves out.
pub(super) fn rule(files: &Files) -> Result<String, FolderError> {
    Ok(ranking::rule(&files.measures()?))
}
