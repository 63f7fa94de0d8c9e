//! The plots: the surviving share by size, and the errors of shallow crossings.

use predicament_report::{Bar, Curve, Curves, curves, ranges};

use super::{Feature, Location, Resolved, Survey};
use crate::{Error, File};

/// The plots `resolution` and, if anything was registered, `location`.
pub(super) fn all(measured: &Resolved) -> Result<Vec<File>, Error> {
    let bars: Vec<Bar> = measured.features.iter().map(bar).collect();
    let sizes = ranges(&bars, "size / L: from never survives to always survives", [-9, 0]);
    let mut files = File::plot("resolution", sizes.map_err(Error::format)?);
    let errors = curves(&lines(&measured.crossings)).map_err(Error::format)?;
    files.extend(File::plot("location", errors));
    Ok(files)
}

fn bar((feature, backend, survey): &(&Feature, String, Survey)) -> Bar {
    let name = format!("{}D {} ({})", feature.dimension.count(), feature.name, feature.tolerance);
    Bar { name, backend: backend.clone(), from: survey.lost(), to: survey.safe() }
}

fn lines(crossings: &[(String, Vec<Location>)]) -> Curves {
    let curve = |(backend, locations): &(String, Vec<Location>)| {
        let points = locations.iter().filter(|at| at.registered > 0).map(|at| (at.angle, at.worst));
        Curve::new(backend.clone(), points.collect::<Vec<_>>())
    };
    Curves {
        x: "angle between the edges, radians".into(),
        y: "largest distance along the edge / L".into(),
        curves: crossings.iter().map(curve).collect(),
        ..Curves::default()
    }
}
