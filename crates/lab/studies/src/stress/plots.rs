//! The plots for each knob by position.
//!
//! They show the scenes of all tasks whose answers break a promise, and the time relative to the time at rest.

use predicament_report::{Curve, Curves, XAxis, curves};
use predicament_tasks::Knob;

use super::Stressed;
use crate::compare::Share;
use crate::{Error, File};

/// The plots of knobs with anything to draw.
pub(super) fn all(stressed: &Stressed) -> Result<Vec<File>, Error> {
    let mut files = Vec::new();
    for knob in Knob::ALL {
        let curve = |(backend, _): &(String, bool)| {
            let shares = knob.positions().iter().filter_map(|&position| {
                let is = |row: &&crate::compare::Measure| {
                    row.kind == knob.name()
                        && row.backend == *backend
                        && row.measure == "wrong scenes"
                        && row.family == position.to_string()
                };
                let of_tasks = stressed.measures.iter().filter(is).map(Share::of_row);
                let all = of_tasks.reduce(|a, b| Share { count: a.count + b.count, of: a.of + b.of })?;
                Some((drawn_at(knob, position)?, all))
            });
            let shares: Vec<(f64, Share)> = shares.collect();
            let points = shares.iter().filter_map(|(at, share)| Some((*at, 1000.0 * share.value()?)));
            let bars = shares.iter().filter(|(_, share)| share.count > 0).map(|(at, share)| {
                let [low, high] = share.interval();
                (*at, 1000.0 * low, 1000.0 * high)
            });
            Curve::new(backend.clone(), sorted(points)).bars(bars)
        };
        let drawn = |curve: &Curve| curve.points.iter().any(|(_, y)| *y > 0.0);
        let lines: Vec<Curve> = stressed.backends.iter().map(curve).filter(drawn).collect();
        let x = format!("{}: {}", knob.name(), knob.unit());
        let y = "wrong scenes in 1000, with 95 % intervals".into();
        let picture = curves(&Curves { x, y, curves: lines, spread: XAxis::Linear }).map_err(Error::format)?;
        files.extend(File::plot(format!("stress-{}", knob.name()), picture));
        files.extend(time(stressed, knob)?);
    }
    Ok(files)
}

/// The place of a position on the axis; `None` for no noise on an axis of exponents.
fn drawn_at(knob: Knob, position: i32) -> Option<f64> {
    (knob != Knob::Noise || position > -1075).then(|| f64::from(position))
}

/// Points from left to right: some knobs turn in both directions.
fn sorted(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = points.collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The time relative to that at rest, the geometric mean of the tasks with this position.
fn time(stressed: &Stressed, knob: Knob) -> Result<Vec<File>, Error> {
    let of = |backend: &str| -> Vec<&crate::compare::Measure> {
        let is =
            |row: &&crate::compare::Measure| row.kind == knob.name() && row.backend == backend && row.measure == "time";
        stressed.measures.iter().filter(is).collect()
    };
    let curve = |(backend, _): &(String, bool)| {
        let own = of(backend);
        let at = |task: &str, position: i32| {
            own.iter().find(|row| row.task == task && row.family == position.to_string()).map(|row| row.value)
        };
        let rest = knob.positions()[0];
        let mut tasks: Vec<&str> = own.iter().map(|row| row.task.as_str()).collect();
        tasks.dedup();
        let points = knob.positions().iter().filter_map(|&position| {
            let over = tasks.iter().filter_map(|task| Some(at(task, position)? / at(task, rest)?));
            let mean = predicament_records::geometric_mean(over)?;
            Some((drawn_at(knob, position)?, mean))
        });
        Curve::new(backend.clone(), sorted(points))
    };
    let lines: Vec<Curve> = stressed.backends.iter().map(curve).filter(|curve| !curve.points.is_empty()).collect();
    let x = format!("{}: {}", knob.name(), knob.unit());
    let picture = curves(&Curves { x, y: "time / time at rest".into(), curves: lines, spread: XAxis::Linear })
        .map_err(Error::format)?;
    Ok(File::plot(format!("stress-{}-time", knob.name()), picture))
}
