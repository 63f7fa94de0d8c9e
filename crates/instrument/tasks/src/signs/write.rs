//! Answers as a CSV file, one line for each query; turns in the plane also as a picture.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use predicament_predicates::{Dimension, QuerySet, Question, Scene, Sign, Vertex};

use crate::output;

/// The maximum number of triangles drawn: more would cover each other.
const DRAWN: usize = 10_000;

/// Writes `signs.csv`: the query as findings name it, and its sign as -1, 0 or 1. For up to 10,000 `orient2d` queries
/// of points in the plane, it also writes their triangles as `triangles.svg` and `triangles.geojson`, and the exact
/// vertices.
pub(super) fn write(
    scene: &Scene,
    queries: &QuerySet,
    answers: &[Sign],
    folder: &Path,
) -> std::io::Result<Vec<PathBuf>> {
    let path = folder.join("signs.csv");
    let mut text = String::from("query,sign\n");
    for (at, sign) in answers.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = writeln!(text, "\"{}\",{}", queries.question().query(queries.args(at)), sign.as_i8());
    }
    std::fs::write(&path, text)?;
    let mut files = vec![path];
    let are_turns = matches!(queries.question(), Question::Orient2d(_)) && scene.dimension() == Dimension::Two;
    if are_turns && queries.len() <= DRAWN {
        let triangles: Vec<Vec<Vec<Vertex>>> = (0..queries.len()).map(|at| vec![queries.args(at).to_vec()]).collect();
        files.extend(output::plane(scene, &triangles, folder, "triangles")?);
        files.push(output::vertices(scene, triangles.into_iter().flatten().flatten(), folder)?);
    }
    Ok(files)
}
