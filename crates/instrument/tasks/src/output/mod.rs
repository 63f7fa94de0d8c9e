//! Answers as files that other programs read, their vertices exactly, and drawings.
//!
//! Formats for meshes and maps hold doubles, or decimals that are read as doubles: a constructed vertex is rounded
//! there to the nearest. Beside them `vertices.json` has every vertex as it is, and what it was constructed from.

mod canvas;
mod placed;
mod plane;
mod space;
mod vertices;

pub use canvas::Canvas;
pub use placed::{Placed, rounded_points};
pub use plane::plane;
pub use space::mesh;
pub use vertices::vertices;

use predicament_judge::{Points, nearest};
use predicament_predicates::Vertex;

/// The doubles that are nearest to a vertex's coordinates.
///
/// # Errors
/// Where its lines and planes meet in no single point.
fn rounded(points: &Points, v: Vertex) -> std::io::Result<Vec<f64>> {
    match v.construction() {
        None => Ok(points.scene().point(v).to_vec()),
        Some(_) => Ok(exactly(points, v)?.iter().map(nearest).collect()),
    }
}

/// The exact coordinates of a vertex.
///
/// # Errors
/// Where its lines and planes meet in no single point.
fn exactly(points: &Points, v: Vertex) -> std::io::Result<Vec<rug::Rational>> {
    let point = points.point(v).map(std::borrow::Cow::into_owned);
    point.ok_or_else(|| std::io::Error::other(format!("{v} is no point, and in the answer")))
}
