//! Exact vertices as JSON.

use std::collections::BTreeSet;
use std::io::Write;

use predicament_judge::{Points, nearest};
use predicament_predicates::{Scene, Vertex};
use serde_json::json;

use super::choice::When;
use super::{Error, Files, exactly};

/// The file's name.
const NAME: &str = "vertices.json";

/// Offers `vertices.json`: an array with an object for each vertex, input vertices first, each once. Without
/// constructed vertices it is written only on request: the coordinates of input vertices are in the input.
///
/// `vertex` is the id that the answer's other files use, `exact` the coordinates as fractions in lowest terms, and
/// `nearest` the doubles nearest to them. `constructed_from` is the definition of a constructed vertex, as `LPI(1 9, 2
/// 5 8)` (null for input vertices). Vertices that define a listed vertex are listed as well.
///
/// # Errors
/// As [`Files::write`].
pub fn vertices<V>(files: &mut Files, scene: &Scene, vertices: V) -> Result<(), Error>
where
    V: IntoIterator<Item = Vertex, IntoIter: Clone>,
{
    let vertices = vertices.into_iter();
    let when = if vertices.clone().any(Vertex::is_constructed) { When::Always } else { When::Named };
    files.offer(NAME, when, None, |out| list(out, scene, vertices)).map(|_| ())
}

/// Offers the same file for answers that are in no other file: it is written by default.
///
/// # Errors
/// As [`Files::write`].
pub fn all_vertices(files: &mut Files, scene: &Scene, vertices: impl IntoIterator<Item = Vertex>) -> Result<(), Error> {
    files.write(NAME, |out| list(out, scene, vertices))
}

fn list(out: &mut dyn Write, scene: &Scene, vertices: impl IntoIterator<Item = Vertex>) -> std::io::Result<()> {
    let points = Points::of(scene);
    let mut separator = "[\n";
    for v in with_definitions(scene, vertices) {
        let point = exactly(&points, v)?;
        let object = json!({
            "vertex": v.to_string(),
            "exact": point.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "nearest": point.iter().map(nearest).collect::<Vec<_>>(),
            "constructed_from": scene.construction(v).map(ToString::to_string),
        });
        write!(out, "{separator}{object}")?;
        separator = ",\n";
    }
    writeln!(out, "{}", if separator == "[\n" { "[]" } else { "\n]" })
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
