//! The writer of OBJ files.

use std::io::{self, Write};

use predicament_mesh::half_edge::IndexedFaces;

use super::decimals;

/// Writes points and faces, whose corners count from 1.
pub(super) fn write(out: &mut impl Write, points: &[[f64; 3]], faces: &IndexedFaces) -> io::Result<()> {
    for point in points {
        writeln!(out, "v {}", decimals(point))?;
    }
    for corners in faces.iter() {
        write!(out, "f")?;
        for &corner in corners {
            write!(out, " {}", u64::from(corner) + 1)?;
        }
        writeln!(out)?;
    }
    Ok(())
}
