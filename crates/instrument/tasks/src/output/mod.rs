//! Answers as files for other programs, with exact vertices, and drawings.
//!
//! A task offers [`Files`], and the user's [`Choice`] says which of them are made. Formats for meshes and maps hold
//! doubles, or decimals that are read as doubles: there a constructed vertex is rounded to the nearest. Beside them
//! `vertices.json` has the exact coordinates and the definition of every vertex.

mod canvas;
mod choice;
mod each;
mod error;
mod files;
mod placed;
mod plane;
mod space;
mod vertices;

pub use canvas::Canvas;
pub use choice::Choice;
pub use each::Each;
pub use error::Error;
pub use files::{Files, Written, write};
pub use placed::{Placed, rounded_points};
pub use plane::{collection, plane, table};
pub use space::mesh;
pub use vertices::{all_vertices, vertices};

use choice::Wanted;
use predicament_judge::{Points, nearest};
use predicament_predicates::Vertex;

/// The doubles nearest to a vertex's coordinates.
///
/// # Errors
/// If its lines and planes do not meet in a single point.
fn rounded(points: &Points, v: Vertex) -> std::io::Result<Vec<f64>> {
    match v.construction() {
        None => Ok(points.scene().point(v).to_vec()),
        Some(_) => Ok(exactly(points, v)?.iter().map(nearest).collect()),
    }
}

/// The exact coordinates of a vertex.
///
/// # Errors
/// If its lines and planes do not meet in a single point.
fn exactly(points: &Points, v: Vertex) -> std::io::Result<Vec<rug::Rational>> {
    let point = points.point(v).map(std::borrow::Cow::into_owned);
    point.ok_or_else(|| std::io::Error::other(format!("the answer has the vertex {v}, which is not a point")))
}
