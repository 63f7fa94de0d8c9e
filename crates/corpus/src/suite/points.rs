//! The points of a scene: written out, from a CSV file, or a published fixture.

use std::path::Path;

use predicament_predicates::{Dimension, Scene, Sign};

use crate::coordinate;
use crate::document::{Field, explain};
use crate::{CorpusError, Task};

/// Points in a suite, one array each.
pub(super) fn read(field: &Field<'_, '_>) -> Result<(Dimension, Vec<f64>), CorpusError> {
    let points = field.items("an array of points, or { path = \"points.csv\" }")?;
    let mut dimension = None;
    let mut coordinates = Vec::with_capacity(points.len() * 3);
    for (index, point) in points.enumerate() {
        let row = point.items("a point: an array of coordinates")?;
        let expected = *dimension.get_or_insert(row.len());
        if row.len() != expected || !(2..=3).contains(&expected) {
            return Err(point.error(ragged(index, row.len(), expected), RAGGED_CURE));
        }
        for coordinate in row {
            coordinates.push(coordinate.coordinate()?);
        }
    }
    match dimension {
        Some(2) => Ok((Dimension::Two, coordinates)),
        Some(_) => Ok((Dimension::Three, coordinates)),
        None => Err(field.error("a scene without points", "write at least one query's points")),
    }
}

const RAGGED_CURE: &str = "give all points two or all three coordinates";

fn ragged(index: usize, found: usize, expected: usize) -> String {
    if (2..=3).contains(&expected) {
        format!("point {index} has {found} coordinates, the points before it {expected}")
    } else {
        format!("point {index} has {found} coordinates")
    }
}

/// Reads a data file beside a suite.
pub(super) fn read_text(path: &Path) -> Result<String, CorpusError> {
    std::fs::read_to_string(path).map_err(|error| unreadable(path, &error))
}

/// What is in a data file, whatever it is.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, CorpusError> {
    std::fs::read(path).map_err(|error| unreadable(path, &error))
}

fn unreadable(path: &Path, error: &std::io::Error) -> CorpusError {
    CorpusError::file(
        path.display().to_string(),
        format!("the data file can't be read: {}", error.kind()),
        "put the file there or correct `path`",
    )
}

/// A CSV file of points: one a line, coordinates separated by commas, no
/// header; blank lines and lines that start with `#` are skipped.
pub(super) fn read_csv(path: &Path) -> Result<(Dimension, Vec<f64>), CorpusError> {
    let file = path.display().to_string();
    let text = read_text(path)?;
    let mut dimension = None;
    let mut coordinates = Vec::new();
    let rows = text.lines().enumerate().filter(|(_, line)| !skipped(line));
    for (index, (at, line)) in rows.enumerate() {
        let error = |message: String, cure: String| CorpusError::file(&file, message, cure).at_line(at + 1);
        let cells: Vec<_> = line.split(',').map(str::trim).collect();
        let expected = *dimension.get_or_insert(cells.len());
        if cells.len() != expected || !(2..=3).contains(&expected) {
            return Err(error(ragged(index, cells.len(), expected), RAGGED_CURE.into()));
        }
        for cell in cells {
            let value = coordinate::exact(cell).map_err(|why| {
                let (message, cure) = explain(&file, cell, &why);
                error(message, cure)
            })?;
            coordinates.push(value);
        }
    }
    match dimension {
        Some(2) => Ok((Dimension::Two, coordinates)),
        Some(_) => Ok((Dimension::Three, coordinates)),
        None => Err(CorpusError::file(file, "the file has no points", "write one point a line")),
    }
}

fn skipped(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with('#')
}

/// A table of the crate `robust` (the fixtures of Shewchuk's predicates):
/// a row is its number, the coordinates of one query's points, and the
/// expected sign, separated by blanks.
///
/// The rows have 17 significant digits, which name one double each; the
/// nearest is what their authors meant.
pub(super) fn read_fixture(file: &str, text: &str, task: Task) -> Result<(Scene, Vec<Sign>), CorpusError> {
    let Some(kind) = task.predicate().filter(|kind| kind.arity() > 2) else {
        return Err(CorpusError::file(
            file,
            format!("no fixture has rows for {task}"),
            "use orient2d, orient3d, incircle or insphere",
        ));
    };
    let dimension = match task {
        Task::Orient3d | Task::Insphere => Dimension::Three,
        _ => Dimension::Two,
    };
    let width = kind.arity() * dimension.count() + 2;
    let mut coordinates = Vec::new();
    let mut expected = Vec::new();
    for (at, line) in text.lines().enumerate().filter(|(_, line)| !skipped(line)) {
        let error = |message: String, cure: &str| CorpusError::file(file, message, cure).at_line(at + 1);
        let cells: Vec<_> = line.split_ascii_whitespace().collect();
        if cells.len() != width {
            let message = format!("a row of {} cells; {task} has {width}", cells.len());
            return Err(error(message, "fetch the file that the manifest names"));
        }
        for cell in &cells[1..width - 1] {
            let value = coordinate::nearest(cell).map_err(|why| {
                let (message, cure) = explain(file, cell, &why);
                error(message, &cure)
            })?;
            coordinates.push(value);
        }
        expected.push(match cells[width - 1] {
            "-1" => Sign::Negative,
            "0" => Sign::Zero,
            "1" => Sign::Positive,
            other => return Err(error(format!("`{other}` is no sign"), "a row ends in -1, 0 or 1")),
        });
    }
    let scene = Scene::new(dimension, coordinates)
        .map_err(|error| CorpusError::file(file, error.to_string(), "fetch the file that the manifest names"))?;
    Ok((scene, expected))
}
