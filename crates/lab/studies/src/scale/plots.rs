//! The plots: time and memory of an element over the size.

use predicament_report::{Curve, Curves, curves};

use super::Row;
use crate::{Error, File};

/// The plots `scale-time` and `scale-memory`.
pub(super) fn all(rows: &[Row]) -> Result<Vec<File>, Error> {
    let time = plot(rows, "scale-time", "nanoseconds an element", Row::nanoseconds)?;
    // An answer in memory that the process has already takes no more: it is drawn as a tenth of a byte.
    let bytes = |row: &Row| if row.bytes.is_nan() { f64::NAN } else { row.bytes_each()[0].max(0.1) };
    let memory = plot(rows, "scale-memory", "bytes an element", bytes)?;
    Ok([time, memory].concat())
}

fn plot(rows: &[Row], name: &str, y: &str, of: impl Fn(&Row) -> f64) -> Result<Vec<File>, Error> {
    let lines = rows.chunk_by(|a, b| a.task == b.task && a.backend == b.backend).filter_map(|rows| {
        let points = rows.iter().map(|row| (row.count(), of(row))).filter(|(_, y)| *y > 0.0);
        let points: Vec<_> = points.collect();
        (!points.is_empty()).then(|| Curve::new(format!("{}, {}", rows[0].task, rows[0].backend), points))
    });
    let lines: Vec<Curve> = lines.collect();
    if lines.is_empty() {
        return Ok(Vec::new());
    }
    let drawn = curves(&Curves { x: "elements".into(), y: y.into(), curves: lines, ..Curves::default() });
    Ok(File::plot(name, drawn.map_err(Error::format)?))
}
