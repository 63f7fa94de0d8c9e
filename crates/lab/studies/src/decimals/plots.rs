//! The plots: the share of right answers by digits, one plot for each place.

use predicament_records::approximately;
use predicament_report::{Curve, Curves, XAxis, curves};

use super::Answered;
use super::row::{columns, sum};
use crate::{Error, File};

/// A plot for each place, over all predicates and figures.
pub(super) fn all(rows: &[Answered]) -> Result<Vec<File>, Error> {
    let mut places: Vec<&str> = rows.iter().map(|row| row.place.as_str()).collect();
    places.dedup();
    let mut files = Vec::new();
    for place in places {
        let here: Vec<&Answered> = rows.iter().filter(|row| row.place == place).collect();
        let drawn = curves(&lines(place, &here)).map_err(Error::format)?;
        files.extend(File::plot(format!("decimals-{place}"), drawn));
    }
    Ok(files)
}

fn lines(place: &str, rows: &[&Answered]) -> Curves {
    let mut digits: Vec<u32> = rows.iter().map(|row| row.digits).collect();
    digits.sort_unstable();
    digits.dedup();
    let curve = |backend: String| {
        let point = |&digits: &u32| {
            let at = sum(rows.iter().copied().filter(|row| row.digits == digits && row.column() == backend));
            let share = approximately(at.written) / approximately(at.answers.max(1));
            (at.answers > 0 && at.written > 0).then(|| (f64::from(digits), share))
        };
        let points: Vec<_> = digits.iter().filter_map(point).collect();
        Curve::new(backend, points)
    };
    Curves {
        x: format!("digits behind the point ({place})"),
        y: "share of answers that are right about the decimals".into(),
        curves: columns(rows).into_iter().map(curve).collect(),
        spread: XAxis::Linear,
    }
}
