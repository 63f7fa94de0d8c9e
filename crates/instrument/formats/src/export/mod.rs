//! Writers of meshes: OFF, OBJ, PLY and STL, so that the [readers](crate::mesh) get every bit back.
//!
//! Anything that a format cannot hold is refused, never rounded or dropped. Decimals are written with all their digits,
//! since the readers accept other decimals only with rounding on. STL stores triangles of coordinates only: it would
//! lose vertices in no face, and the distinction of two vertices at one place. Binary STL stores singles. The STL
//! reader numbers the vertices in the order of their occurrence.

mod error;
mod obj;
mod off;
mod ply;
mod stl;

use std::io::Write;

use predicament_mesh::half_edge::IndexedFaces;

use crate::bits::lowest_bit;

pub use error::ExportError;

/// A file format for meshes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeshFormat {
    /// OFF in ASCII.
    Off,
    /// The OBJ format.
    Obj,
    /// PLY in ASCII, coordinates as doubles.
    PlyAscii,
    /// PLY in binary, little-endian, coordinates as doubles.
    PlyBinary,
    /// STL in ASCII.
    StlAscii,
    /// STL in binary, coordinates as singles.
    StlBinary,
}

impl MeshFormat {
    /// All formats.
    pub const ALL: [MeshFormat; 6] = [
        MeshFormat::Off,
        MeshFormat::Obj,
        MeshFormat::PlyAscii,
        MeshFormat::PlyBinary,
        MeshFormat::StlAscii,
        MeshFormat::StlBinary,
    ];

    /// The file name extension of the format.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            MeshFormat::Off => ".off",
            MeshFormat::Obj => ".obj",
            MeshFormat::PlyAscii | MeshFormat::PlyBinary => ".ply",
            MeshFormat::StlAscii | MeshFormat::StlBinary => ".stl",
        }
    }
}

/// Writes points and faces, in many small writes; use a buffered writer.
///
/// # Errors
/// [`ExportError`] if the readers would refuse the faces, if the format cannot hold the mesh (nothing is written then),
/// or if writing fails.
pub fn write_mesh(
    out: &mut impl Write,
    format: MeshFormat,
    points: &[[f64; 3]],
    faces: &IndexedFaces,
) -> Result<(), ExportError> {
    check(points, faces)?;
    match format {
        MeshFormat::Off => off::write(out, points, faces)?,
        MeshFormat::Obj => obj::write(out, points, faces)?,
        MeshFormat::PlyAscii => ply::write(out, points, faces, ply::Encoding::Ascii)?,
        MeshFormat::PlyBinary => ply::write(out, points, faces, ply::Encoding::Binary)?,
        MeshFormat::StlAscii => stl::ascii(out, points, faces)?,
        MeshFormat::StlBinary => stl::binary(out, points, faces)?,
    }
    Ok(())
}

/// Refuses meshes that no format can hold.
fn check(points: &[[f64; 3]], faces: &IndexedFaces) -> Result<(), ExportError> {
    if [points.len(), faces.len()].iter().any(|&count| i32::try_from(count).is_err()) {
        return Err(ExportError::TooMany);
    }
    if let Some(vertex) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
        return Err(ExportError::NotFinite { vertex });
    }
    let mut last_face = vec![usize::MAX; points.len()];
    for (face, corners) in faces.iter().enumerate() {
        if corners.len() < 3 {
            return Err(ExportError::TooFewCorners { face, corners: corners.len() });
        }
        for &corner in corners {
            let Some(last) = last_face.get_mut(corner as usize) else {
                return Err(ExportError::NoSuchVertex { face, corner, vertices: points.len() });
            };
            if std::mem::replace(last, face) == face {
                return Err(ExportError::RepeatedVertex { face, vertex: corner });
            }
        }
    }
    Ok(())
}

/// The exact decimal of a finite double without trailing zeros: as many places as its lowest bit needs.
fn decimal(x: f64) -> String {
    let places = lowest_bit(x).map_or(0, |lowest| usize::try_from(-lowest).unwrap_or(0));
    format!("{x:.places$}")
}

/// The coordinates of a point, separated by blanks.
fn decimals(point: &[f64; 3]) -> String {
    point.map(decimal).join(" ")
}
