//! A plot for each knob: scenes that are answered against a promise, by position, the mean of all tasks.

use predicament_report::{Curve, Curves, curves};

use super::{Knob, Stressed};
use crate::{Error, File};

/// The plots of knobs with anything to draw.
pub(super) fn all(stressed: &Stressed) -> Result<Vec<File>, Error> {
    let mut files = Vec::new();
    for knob in Knob::ALL {
        let curve = |(backend, _): &(String, bool)| {
            let points = knob.positions().iter().filter_map(|&position| {
                let is = |row: &&crate::compare::Measure| {
                    row.kind == knob.name()
                        && row.backend == *backend
                        && row.measure == "wrong scenes"
                        && row.family == position.to_string()
                };
                let values: Vec<f64> = stressed.measures.iter().filter(is).map(|row| row.value).collect();
                let count = predicament_records::approximately(values.len() as u64);
                // On a logarithmic axis: of a position that is at rest nothing is drawn.
                let at = f64::from(if knob == Knob::Noise { position + 1076 } else { position.abs() });
                (!values.is_empty() && at > 0.0).then(|| (at, values.iter().sum::<f64>() / count))
            });
            Curve { name: backend.clone(), points: points.collect() }
        };
        let drawn = |curve: &Curve| curve.points.iter().any(|(_, y)| *y > 0.0);
        let lines: Vec<Curve> = stressed.backends.iter().map(curve).filter(drawn).collect();
        let x = format!("{}: {}", knob.name(), knob.unit());
        let y = "scenes in 1000 answered against the promise".into();
        let svg = curves(&Curves { x, y, curves: lines }).map_err(Error::format)?;
        files.extend(svg.map(|svg| File::new(format!("stress-{}.svg", knob.name()), svg)));
    }
    Ok(files)
}
