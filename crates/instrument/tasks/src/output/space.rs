//! Faces in space as OFF, OBJ and PLY.

use std::collections::BTreeMap;
use std::io::{BufWriter, Error, Write};
use std::path::{Path, PathBuf};

use predicament_formats::{ExportError, MeshFormat, write_mesh};
use predicament_judge::Points;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::{Scene, Vertex};

use super::rounded;

/// Writes `NAME.off`, `NAME.obj` and `NAME.ply` (binary) with the faces' vertices, in the order of their ids. A
/// constructed vertex is rounded to the nearest doubles, so two vertices may coincide.
///
/// # Errors
/// The error of the file system, or a face that these formats cannot hold: fewer than three corners, or a corner twice.
pub fn mesh(scene: &Scene, faces: &[Vec<Vertex>], folder: &Path, name: &str) -> std::io::Result<Vec<PathBuf>> {
    let points = Points::of(scene);
    let mut places: BTreeMap<Vertex, u32> = faces.iter().flatten().map(|&v| (v, 0)).collect();
    let mut coordinates = Vec::with_capacity(places.len());
    for (&v, place) in &mut places {
        *place = u32::try_from(coordinates.len()).map_err(Error::other)?;
        let point = rounded(&points, v)?;
        coordinates.push(<[f64; 3]>::try_from(point).map_err(|_| Error::other("a mesh is in space"))?);
    }
    let indexed: IndexedFaces = faces.iter().map(|face| face.iter().map(|v| places[v])).collect();
    [MeshFormat::Off, MeshFormat::Obj, MeshFormat::PlyBinary]
        .into_iter()
        .map(|format| {
            let path = folder.join(format!("{name}{}", format.extension()));
            let mut file = BufWriter::new(std::fs::File::create(&path)?);
            write_mesh(&mut file, format, &coordinates, &indexed).map_err(|why| match why {
                ExportError::Io(error) => error,
                why => {
                    // Nothing is written, and no empty file remains.
                    let _ = std::fs::remove_file(&path);
                    Error::other(format!("{name}{} can't hold the answer: {why}", format.extension()))
                }
            })?;
            file.flush()?;
            Ok(path)
        })
        .collect()
}
