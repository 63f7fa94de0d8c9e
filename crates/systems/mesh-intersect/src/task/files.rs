//! Files of results in doubles.

use std::path::{Path, PathBuf};

use predicament_predicates::{Scene, Vertex};
use serde_json::json;

use super::settled::{Result, Settled};
use predicament_tasks::output;

/// Writes a mesh for each operation, and `rounding.json` with the statistics of the limit and of rounding for each.
///
/// # Errors
/// The error of the file system.
pub(super) fn settled(settled: &Settled, folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut counts = serde_json::Map::new();
    for (operation, result) in settled.by_operation() {
        let closed = &result.rounded.closed;
        let scene = Scene::from_points3(&closed.points).map_err(std::io::Error::other)?;
        let face = |triangle: &[u32; 3]| triangle.map(|v| Vertex::input(v as usize)).to_vec();
        let faces: Vec<Vec<Vertex>> = closed.triangles.iter().map(face).collect();
        files.extend(output::mesh(&scene, &faces, folder, operation.name())?);
        counts.insert(operation.name().to_owned(), told(result));
    }
    let path = folder.join("rounding.json");
    std::fs::write(&path, format!("{}\n", serde_json::Value::Object(counts)))?;
    files.push(path);
    Ok(files)
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
