//! The writer of OFF files.

use std::io::{self, Write};

use predicament_mesh::half_edge::IndexedFaces;

use super::decimals;

/// Writes the keyword, the counts (0 edges means not counted), the points, and the faces.
pub(super) fn write(out: &mut impl Write, points: &[[f64; 3]], faces: &IndexedFaces) -> io::Result<()> {
    writeln!(out, "OFF\n{} {} 0", points.len(), faces.len())?;
    for point in points {
        writeln!(out, "{}", decimals(point))?;
    }
    for corners in faces.iter() {
        write!(out, "{}", corners.len())?;
        for corner in corners {
            write!(out, " {corner}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}
