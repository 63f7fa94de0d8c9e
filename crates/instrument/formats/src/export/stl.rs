//! The writer of STL files, in ASCII and in binary.
//!
//! Normals are written as zeros, which readers take as not given: a unit normal would be rounded.

use std::collections::HashMap;
use std::io::Write;

use predicament_mesh::half_edge::IndexedFaces;

use super::{ExportError, decimals};

/// The text before the number of triangles in a binary file; it must not begin with the word `solid`.
const TITLE: &[u8; 80] = b"triangles, binary, normals not given                                            ";

/// Writes ASCII STL, with coordinates as decimals.
pub(super) fn ascii(out: &mut impl Write, points: &[[f64; 3]], faces: &IndexedFaces) -> Result<(), ExportError> {
    let triangles = triangles(points, faces)?;
    writeln!(out, "solid")?;
    for corners in triangles {
        writeln!(out, "facet normal 0 0 0\nouter loop")?;
        for corner in corners {
            writeln!(out, "vertex {}", decimals(&points[corner as usize]))?;
        }
        writeln!(out, "endloop\nendfacet")?;
    }
    writeln!(out, "endsolid")?;
    Ok(())
}

/// Writes binary STL; all coordinates must be singles.
pub(super) fn binary(out: &mut impl Write, points: &[[f64; 3]], faces: &IndexedFaces) -> Result<(), ExportError> {
    let triangles = triangles(points, faces)?;
    let mut singles = Vec::with_capacity(points.len());
    for (vertex, point) in points.iter().enumerate() {
        let [Some(x), Some(y), Some(z)] = point.map(single) else {
            return Err(ExportError::NoSingle { vertex });
        };
        singles.push([x, y, z]);
    }
    let count = u32::try_from(triangles.len()).map_err(|_| ExportError::TooMany)?;
    out.write_all(TITLE)?;
    out.write_all(&count.to_le_bytes())?;
    for corners in triangles {
        // The normal, the corners, two bytes for attributes.
        out.write_all(&[0; 12])?;
        for corner in corners {
            singles[corner as usize].iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))?;
        }
        out.write_all(&[0; 2])?;
    }
    Ok(())
}

/// The triangles, if all faces are triangles, all vertices are in faces, and no two vertices coincide.
fn triangles(points: &[[f64; 3]], faces: &IndexedFaces) -> Result<Vec<[u32; 3]>, ExportError> {
    let mut triangles = Vec::with_capacity(faces.len());
    let mut is_used = vec![false; points.len()];
    for (face, corners) in faces.iter().enumerate() {
        let triangle = corners.try_into().map_err(|_| ExportError::NoTriangle { face, corners: corners.len() })?;
        triangles.push(triangle);
        corners.iter().for_each(|&corner| is_used[corner as usize] = true);
    }
    if let Some(vertex) = is_used.iter().position(|is_used| !is_used) {
        return Err(ExportError::Unused { vertex });
    }
    let mut places = HashMap::with_capacity(points.len());
    for (vertex, point) in points.iter().enumerate() {
        // -0 and +0 are the same place.
        if let Some(first) = places.insert(point.map(|x| (x + 0.0).to_bits()), vertex) {
            return Err(ExportError::OnePlace { vertices: [first, vertex] });
        }
    }
    Ok(triangles)
}

/// The single equal to a double, if there is one.
fn single(x: f64) -> Option<f32> {
    #[allow(clippy::cast_possible_truncation)] // an inexact single is refused
    let single = x as f32;
    (f64::from(single).to_bits() == x.to_bits()).then_some(single)
}
