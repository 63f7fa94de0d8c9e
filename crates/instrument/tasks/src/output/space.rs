//! Faces in space as OFF, OBJ, PLY and STL.

use std::collections::BTreeMap;
use std::io::Error as IoError;

use predicament_formats::{ExportError, MeshFormat, write_mesh};
use predicament_judge::Points;
use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::{Scene, Vertex};

use super::choice::When;
use super::{Error, Files, rounded};

/// The formats, with the request that each waits for.
const FORMATS: [(MeshFormat, When); 4] = [
    (MeshFormat::Off, When::Always),
    (MeshFormat::Obj, When::Always),
    (MeshFormat::PlyBinary, When::Always),
    (MeshFormat::StlAscii, When::Format),
];

/// Offers `NAME.off`, `NAME.obj` and `NAME.ply` (binary), and by its format `NAME.stl` (ASCII), with the faces'
/// vertices, in the order of their ids. A constructed vertex is rounded to the nearest doubles, so two vertices may
/// coincide. A mesh without faces is written with a remark.
///
/// # Errors
/// [`Error`] for a face that a format cannot hold: fewer than three corners, or a corner twice; in STL also more than
/// three corners, or two vertices at one place. Otherwise as [`Files::write`].
pub fn mesh<F>(files: &mut Files, scene: &Scene, name: &str, faces: F) -> Result<(), Error>
where
    F: ExactSizeIterator<Item = Vec<Vertex>> + Clone,
{
    let mut made: Option<Indexed> = None;
    let mut is_written = false;
    for (format, when) in FORMATS {
        is_written |= files.offer(&format!("{name}{}", format.extension()), when, None, |mut out| {
            if made.is_none() {
                made = Some(Indexed::of(scene, faces.clone())?);
            }
            let Some(Indexed { points, faces }) = &made else { return Ok(()) };
            write_mesh(&mut out, format, points, faces).map_err(|why| match why {
                ExportError::Io(error) => error,
                why => IoError::other(why),
            })
        })?;
    }
    if is_written && faces.len() == 0 {
        files.note(format!("the mesh {name} is empty: it has no faces"));
    }
    Ok(())
}

/// A mesh as files store it.
struct Indexed {
    points: Vec<[f64; 3]>,
    faces: IndexedFaces,
}

impl Indexed {
    fn of(scene: &Scene, faces: impl Iterator<Item = Vec<Vertex>> + Clone) -> std::io::Result<Indexed> {
        let exact = Points::of(scene);
        let mut places: BTreeMap<Vertex, u32> = faces.clone().flatten().map(|v| (v, 0)).collect();
        let mut points = Vec::with_capacity(places.len());
        for (&v, place) in &mut places {
            *place = u32::try_from(points.len()).map_err(IoError::other)?;
            let point = rounded(&exact, v)?;
            points.push(<[f64; 3]>::try_from(point).map_err(|_| IoError::other("a mesh is in space"))?);
        }
        let faces = faces.map(|face| face.into_iter().map(|v| places[&v]).collect::<Vec<u32>>()).collect();
        Ok(Indexed { points, faces })
    }
}
