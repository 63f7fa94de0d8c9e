//! The scenes of each position as a suite, so that a break point can be kept.
//!
//! A scene is written as a scene of its family with explicit points: its content does not depend on the knob.

use std::fmt::Write as _;
use std::path::Path;

use predicament_predicates::Scene;

use super::scenes::Position;
use crate::coordinate::coordinate;
use crate::{Error, File};

/// A suite for each position of each knob, with the scenes of all tasks.
///
/// # Errors
/// [`Error::Unfit`] if a scene cannot be made or the folder has no path.
pub(super) fn all(folder: &Path, positions: &[Position], seed: u64, scenes: u32) -> Result<Vec<File>, Error> {
    let folder = std::path::absolute(folder).map_err(Error::unfit)?;
    let mut suites: Vec<(String, String)> = Vec::new();
    for position in positions {
        let name = format!("{}_{}.toml", position.knob.name(), position.at);
        let at = suites.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
            suites.push((name, head(position)));
            suites.len() - 1
        });
        for seed in (0..scenes).map(|at| seed + u64::from(at)) {
            suites[at].1.push_str(&table(position, seed)?);
        }
    }
    Ok(suites.into_iter().map(|(name, text)| File::new(folder.join(name).display().to_string(), text)).collect())
}

fn head(position: &Position) -> String {
    let (knob, at) = (position.knob, position.at);
    format!(
        "title = \"Stress: {} at {at}\"\ndescription = \"Scenes of `predicament study stress`. {} Position: {}.\"\n",
        knob.name(),
        knob.about(),
        knob.unit()
    )
}

fn table(position: &Position, seed: u64) -> Result<String, Error> {
    let loaded = position.scene(seed)?;
    let name = format!("{}-{}-{seed}", position.task, position.input.of.kind.name());
    Ok(format!("\n{}coordinates = [\n{}]\n", position.input.table(&name, seed), places(&loaded.scene)))
}

/// The points, one per line, without loss.
fn places(scene: &Scene) -> String {
    let mut rows = String::new();
    for point in scene.coordinates().chunks(scene.dimension().count()) {
        let cells: Vec<String> = point.iter().map(|&x| coordinate(x).to_string()).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(rows, "  [{}],", cells.join(", "));
    }
    rows
}
