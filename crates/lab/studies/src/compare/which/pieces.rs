//! The results for meshes that are cut, and for closed curves that are merged.

use crate::folder::FolderError;
use serde::Deserialize;

use super::files::Files;
use crate::compare::Share;
use crate::compare::words::{counted, percents};
use predicament_records::format::{significant, thousands};

/// Columns of `cut.csv`.
#[derive(Deserialize)]
struct Cut {
    backend: String,
    declined: Option<String>,
    tetrahedra: u64,
    cut: u64,
    inconsistent: u64,
    lost: f64,
    checked: u64,
    off: u64,
    slivers: u64,
}

/// The results for tetrahedra that are cut by registered contacts alone: a line for each backend.
pub(super) fn cut(files: &Files) -> Result<String, FolderError> {
    let rows: Vec<Cut> = files.cuts()?;
    let mut lines = Vec::new();
    for backend in names(rows.iter().map(|row| row.backend.as_str())) {
        let (done, declined): (Vec<&Cut>, Vec<&Cut>) = rows
            .iter()
            .filter(|row| row.backend == backend)
            .partition(|row| row.declined.as_deref().is_none_or(str::is_empty));
        let sum = |get: fn(&Cut) -> u64| done.iter().map(|row| get(row)).sum::<u64>();
        let inconsistent = Share { count: sum(|row| row.inconsistent), of: sum(|row| row.tetrahedra) };
        let off = Share { count: sum(|row| row.off), of: sum(|row| row.checked) };
        let lost = done.iter().map(|row| row.lost).sum::<f64>();
        let lost = if lost == 0.0 {
            "no volume is lost".to_owned()
        } else {
            format!("a volume of {} cubes is lost", significant(lost, 2))
        };
        let declines =
            if declined.is_empty() { String::new() } else { format!("; declines {} scenes", declined.len()) };
        lines.push(format!(
            "* `{backend}`, {} scenes: {} tetrahedra are inconsistent, {lost}, {} of {} checked tetrahedra are off ({}), {} slivers in {} cut tetrahedra{declines}.",
            done.len(),
            counted(inconsistent),
            thousands(off.count),
            thousands(off.of),
            percents(off),
            thousands(sum(|row| row.slivers)),
            thousands(sum(|row| row.cut)),
        ));
    }
    Ok(lines.join("\n"))
}

/// Columns of `parity.csv`.
#[derive(Deserialize)]
struct Plane {
    pairs_for: String,
    backend: String,
    pairs: u64,
    declined: u64,
    odd_some: u64,
}

/// Columns of `parity-space.csv`.
#[derive(Deserialize)]
struct Space {
    pairs_for: String,
    backend: String,
    pairs: u64,
    declined: u64,
    loose: u64,
}

/// The counts of broken curves: a line for each backend.
///
/// It counts closed curves that cross an odd number of times, and closed surfaces whose curves of intersection have
/// loose ends.
pub(super) fn parity(files: &Files) -> Result<String, FolderError> {
    let plane: Vec<Plane> = files.parity()?;
    let space: Vec<Space> = files.parity_space()?;
    let mut lines = Vec::new();
    let plane = plane.iter().map(|row| {
        let share = Share { count: row.odd_some, of: row.pairs - row.declined };
        ("pairs of closed polygons cross an odd number of times", [&row.backend, &row.pairs_for], share)
    });
    let space = space.iter().map(|row| {
        let share = Share { count: row.loose, of: row.pairs - row.declined };
        ("pairs of closed surfaces meet in curves with loose ends", [&row.backend, &row.pairs_for], share)
    });
    // The counts of recipes are added up.
    let mut sums: Vec<(&str, [&String; 2], Share)> = Vec::new();
    for (what, of, share) in plane.chain(space) {
        match sums.iter_mut().find(|(other, key, _)| *other == what && *key == of) {
            Some((_, _, sum)) => *sum = Share { count: sum.count + share.count, of: sum.of + share.of },
            None => sums.push((what, of, share)),
        }
    }
    for (what, [backend, precision], share) in sums.iter().filter(|(.., share)| share.of > 0) {
        lines.push(format!(
            "* `{backend}`, pairs for tolerances in {precision}: {} {what} ({}).",
            counted(*share),
            percents(*share)
        ));
    }
    Ok(lines.join("\n"))
}

fn names<'r>(all: impl Iterator<Item = &'r str>) -> Vec<&'r str> {
    let mut names: Vec<&str> = Vec::new();
    for name in all {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}
