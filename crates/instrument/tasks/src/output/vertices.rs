//! Exact vertices as JSON.

use std::collections::BTreeSet;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use predicament_judge::{Points, nearest};
use predicament_predicates::{Scene, Vertex};
use serde_json::json;

use super::exactly;

/// Writes `vertices.json`: an array with an object for each vertex, input vertices first, each once.
///
/// `vertex` is the id that the answer's other files use, `exact` the coordinates as fractions in lowest terms, and
/// `nearest` the doubles nearest to them. `constructed_from` is the definition of a constructed vertex, as `LPI(1 9, 2
/// 5 8)` (null for input vertices). Vertices that define a listed vertex are listed as well.
///
/// # Errors
/// The error of the file system.
pub fn vertices(scene: &Scene, vertices: impl IntoIterator<Item = Vertex>, folder: &Path) -> std::io::Result<PathBuf> {
    let points = Points::of(scene);
    let path = folder.join("vertices.json");
    let mut file = BufWriter::new(std::fs::File::create(&path)?);
    let mut separator = "[\n";
    for v in with_definitions(scene, vertices) {
        let point = exactly(&points, v)?;
        let object = json!({
            "vertex": v.to_string(),
            "exact": point.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "nearest": point.iter().map(nearest).collect::<Vec<_>>(),
            "constructed_from": scene.construction(v).map(ToString::to_string),
        });
        write!(file, "{separator}{object}")?;
        separator = ",\n";
    }
    writeln!(file, "{}", if separator == "[\n" { "[]" } else { "\n]" })?;
    file.flush()?;
    Ok(path)
}

/// The vertices and all vertices that define them.
fn with_definitions(scene: &Scene, vertices: impl IntoIterator<Item = Vertex>) -> BTreeSet<Vertex> {
    let mut all = BTreeSet::new();
    let mut open: Vec<Vertex> = vertices.into_iter().collect();
    while let Some(v) = open.pop() {
        if all.insert(v) {
            open.extend(scene.construction(v).into_iter().flat_map(|definition| definition.flats().flatten().copied()));
        }
    }
    all
}
