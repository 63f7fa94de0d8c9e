//! Answers as a CSV file, one line for each query; turns in the plane also as triangles.

use predicament_predicates::{Dimension, QuerySet, Question, Scene, Sign, Vertex};

use crate::output::{self, Files};

/// The maximum number of triangles written by default: more would cover each other.
const DRAWN: usize = 10_000;

/// Offers `signs.csv`: the query as findings name it, and its sign as -1, 0 or 1. For `orient2d` queries of points in
/// the plane, it also offers their triangles as `triangles.svg`, `triangles.geojson` and `triangles.wkt`, and the exact
/// vertices; for more than 10,000 queries only on request.
pub(super) fn write(
    scene: &Scene,
    queries: &QuerySet,
    answers: &[Sign],
    files: &mut Files,
) -> Result<(), output::Error> {
    files.write("signs.csv", |out| {
        writeln!(out, "query,sign")?;
        for (at, sign) in answers.iter().enumerate() {
            writeln!(out, "\"{}\",{}", queries.question().query(queries.args(at)), sign.as_i8())?;
        }
        Ok(())
    })?;
    let are_turns = matches!(queries.question(), Question::Orient2d(_)) && scene.dimension() == Dimension::Two;
    if !are_turns {
        return Ok(());
    }
    let all = 0..queries.len();
    let triangles = |files: &mut Files| {
        let triangle = |at: usize| vec![queries.args(at).to_vec()];
        output::plane(files, scene, "triangles", all.clone().map(triangle))?;
        output::vertices(files, scene, all.flat_map(|at| -> Vec<Vertex> { queries.args(at).to_vec() }))
    };
    if queries.len() <= DRAWN { triangles(files) } else { files.all_on_request(triangles) }
}
