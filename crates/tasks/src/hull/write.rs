//! Hulls as files.

use std::path::{Path, PathBuf};

use predicament_predicates::Vertex;

/// `hull.json`: the indices of the vertices, and of those of each face.
pub(super) fn json(vertices: &[Vertex], faces: &[Vec<Vertex>], folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let indices = |list: &[Vertex]| list.iter().map(|v| v.index()).collect::<Vec<_>>();
    let faces: Vec<Vec<usize>> = faces.iter().map(|face| indices(face)).collect();
    let json = serde_json::json!({ "vertices": indices(vertices), "faces": faces });
    let path = folder.join("hull.json");
    std::fs::write(&path, format!("{json}\n"))?;
    Ok(vec![path])
}
