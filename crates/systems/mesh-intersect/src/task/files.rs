//! Files of results in doubles.

use predicament_predicates::{Scene, Vertex};
use serde::Serialize;
use serde_json::json;

use super::settled::{Result, Settled};
use crate::algorithm::overlay::Contacts;
use predicament_tasks::output::{self, Error, Files};

/// The file of pieces.
#[derive(Serialize)]
pub(super) struct Pieces<P> {
    pub broken: Option<&'static str>,
    pub pieces: P,
}

/// Offers a mesh for each operation, and `rounding.json` with the statistics of the limit and of rounding for each.
///
/// # Errors
/// As [`Files::write`].
pub(super) fn settled(settled: &Settled, files: &mut Files) -> std::result::Result<(), Error> {
    for (operation, result) in settled.by_operation() {
        let closed = &result.rounded.closed;
        let scene = Scene::from_points3(&closed.points).map_err(std::io::Error::other)?;
        let face = |triangle: &[u32; 3]| triangle.map(|v| Vertex::input(v as usize)).to_vec();
        output::mesh(files, &scene, operation.name(), closed.triangles.iter().map(face))?;
    }
    files.json("rounding.json", || {
        let counts = settled.by_operation().map(|(operation, result)| (operation.name().to_owned(), told(result)));
        serde_json::Value::Object(counts.collect())
    })
}

/// The points, segments and faces where two solids touch, by vertices, with the coordinates of input vertices. The file
/// of all vertices has the others.
pub(super) fn contacts(contacts: &Contacts, place: &dyn Fn(Vertex) -> Option<[f64; 3]>) -> serde_json::Value {
    let vertex = |v: Vertex| match place(v) {
        Some(point) => json!({ "vertex": v.to_string(), "point": point }),
        None => json!({ "vertex": v.to_string() }),
    };
    let faces = contacts.faces.iter().map(|face| {
        let triangles: Vec<_> = face.triangles.iter().map(|triangle| triangle.map(vertex)).collect();
        json!({ "triangle_of_first": face.of[0], "triangle_of_second": face.of[1], "triangles": triangles })
    });
    json!({
        "points": contacts.points.iter().map(|&v| vertex(v)).collect::<Vec<_>>(),
        "segments": contacts.segments.iter().map(|ends| ends.map(vertex)).collect::<Vec<_>>(),
        "faces": faces.collect::<Vec<_>>(),
    })
}

fn told(result: &Result) -> serde_json::Value {
    let (limit, rounding) = (result.counts, result.rounded.counts);
    json!({
        "triangles": result.rounded.closed.triangles.len(),
        "limit": {
            "triangles": result.solid.triangles.len(),
            "merged": limit.merged,
            "flat": limit.flat,
            "cancelled": limit.cancelled,
            "covered": limit.covered,
            "divided": limit.divided,
        },
        "rounding": {
            "moved": rounding.moved,
            "merged": rounding.merged,
            "collapsed": rounding.collapsed,
            "turned": rounding.turned,
            "folded": rounding.folded,
            "crossing": rounding.crossing,
            "mended": rounding.mended,
            "left": rounding.left,
        },
    })
}
