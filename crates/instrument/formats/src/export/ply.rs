//! The writer of PLY files, in ASCII and in binary.

use std::io::{self, Write};

use predicament_mesh::half_edge::IndexedFaces;

use super::decimals;

/// The encoding of numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    /// Little-endian.
    Binary,
}

/// Writes coordinates as doubles, and corners as the list `vertex_indices` of 32-bit integers. The length of the list
/// is a byte, as in most programs, unless a face has more corners.
pub(super) fn write(
    out: &mut impl Write,
    points: &[[f64; 3]],
    faces: &IndexedFaces,
    encoding: Encoding,
) -> io::Result<()> {
    let name = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::Binary => "binary_little_endian",
    };
    let is_short = faces.iter().all(|corners| u8::try_from(corners.len()).is_ok());
    let length = if is_short { "uchar" } else { "uint" };
    writeln!(out, "ply\nformat {name} 1.0\nelement vertex {}", points.len())?;
    writeln!(out, "property double x\nproperty double y\nproperty double z\nelement face {}", faces.len())?;
    writeln!(out, "property list {length} int vertex_indices\nend_header")?;
    for point in points {
        match encoding {
            Encoding::Ascii => writeln!(out, "{}", decimals(point))?,
            Encoding::Binary => point.iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))?,
        }
    }
    for corners in faces.iter() {
        match (encoding, u8::try_from(corners.len())) {
            (Encoding::Ascii, _) => write!(out, "{}", corners.len())?,
            (Encoding::Binary, Ok(length)) if is_short => out.write_all(&[length])?,
            // A face has at most as many corners as there are vertices.
            (Encoding::Binary, _) => {
                let length = u32::try_from(corners.len()).map_err(io::Error::other)?;
                out.write_all(&length.to_le_bytes())?;
            }
        }
        match encoding {
            Encoding::Ascii => {
                corners.iter().try_for_each(|corner| write!(out, " {corner}"))?;
                writeln!(out)?;
            }
            Encoding::Binary => corners.iter().try_for_each(|corner| out.write_all(&corner.to_le_bytes()))?,
        }
    }
    Ok(())
}
