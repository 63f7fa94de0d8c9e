//! The plot: the ratios of each device, by the kind of scenes and the interface.

use predicament_report::{Bar, ranges};

use super::Row;
use super::row::{Group, columns};
use crate::{Error, File};

/// Bars from the smallest to the largest ratio of a device.
pub(super) fn all(rows: &[Row]) -> Result<Vec<File>, Error> {
    let columns = columns(rows);
    let bars: Vec<Bar> = Group::all(rows)
        .iter()
        .flat_map(|group| {
            columns.iter().filter_map(|column| {
                let (_, [low, high]) = group.of(column)?;
                let (name, backend) = (group.name.clone(), (*column).to_owned());
                Some(Bar { name, backend, from: Some(low), to: Some(high) })
            })
        })
        .collect();
    if bars.is_empty() {
        return Ok(Vec::new());
    }
    // Whole decades that hold all bars.
    let decade = |x: Option<f64>, round: fn(f64) -> f64| round(x.unwrap_or(1.0).log10());
    let low = bars.iter().map(|bar| decade(bar.from, f64::floor)).fold(0.0, f64::min);
    let high = bars.iter().map(|bar| decade(bar.to, f64::ceil)).fold(1.0, f64::max);
    #[allow(clippy::cast_possible_truncation)] // a few decades
    let drawn = ranges(&bars, "time without the device / time of the whole", [low as i32, high as i32]);
    Ok(File::plot("ablation", drawn.map_err(Error::format)?))
}
