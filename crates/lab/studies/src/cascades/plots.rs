//! Plots over the steps, for each cascade: area error, bits, time.

use predicament_report::text::in_order;
use predicament_report::{Curve, Curves, curves};

use super::{Followed, Measured, Sample};
use crate::{Error, File};

/// A plot: the suffix of the file's name, its title, and the value of a sample.
type Plot<'m> = (&'static str, &'static str, &'m dyn Fn(&Followed, &Sample) -> Option<f64>);

/// The plots that have a positive value.
pub(super) fn all(measured: &Measured) -> Result<Vec<File>, Error> {
    #[allow(clippy::cast_precision_loss)] // small counts
    let count = |n: usize| Some(n as f64);
    let plots: [Plot<'_>; 4] = [
        ("area", "area error / area", &|one, sample| measured.area_error(one.cascade, sample)),
        ("wrong", "crossings, inverted loops and wrong points", &|_, sample| {
            count(sample.defects.crossings + sample.defects.inverted + sample.lost)
        }),
        ("bits", "most bits of a coordinate", &|_, sample| Some(f64::from(sample.bits))),
        ("time", "microseconds per step", &|_, sample| Some(sample.nanoseconds / 1e3)),
    ];
    let mut files = Vec::new();
    for cascade in in_order(measured.followed.iter().map(|one| one.cascade)) {
        for (name, what, value) in &plots {
            let curve = |one: &Followed| {
                #[allow(clippy::cast_precision_loss)] // few steps
                let point = |sample: &Sample| Some((sample.step as f64, value(one, sample)?));
                Curve::new(one.method.to_string(), one.samples.iter().filter_map(point).collect::<Vec<_>>())
            };
            let of_cascade = measured.followed.iter().filter(|one| one.cascade == cascade);
            // A name in the legend requires a line.
            let drawn = |curve: &Curve| curve.points.iter().any(|(_, y)| *y > 0.0);
            let lines = of_cascade.map(curve).filter(drawn).collect();
            let picture = curves(&Curves { x: "step".into(), y: (*what).into(), curves: lines, ..Curves::default() })
                .map_err(Error::format)?;
            files.extend(File::plot(format!("{}-{name}", cascade.name()), picture));
        }
    }
    Ok(files)
}
