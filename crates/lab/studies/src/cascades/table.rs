//! The page of the study: the failures of each method, as Markdown.

use std::fmt::Write as _;

use predicament_records::format::significant;
use predicament_report::text::{in_order, markdown};

use super::{Cascades, Followed, Measured, Sample};

/// A table for each cascade, and the first failures.
pub(super) fn page(study: &Cascades, measured: &Measured) -> String {
    let mut page = format!(
        "{} steps, measured after {} of them; seed {}; times in microseconds per step\n",
        study.steps,
        study.samples.min(study.steps),
        study.common.seed
    );
    for cascade in in_order(measured.followed.iter().map(|one| one.cascade)) {
        let all: Vec<&Followed> = measured.followed.iter().filter(|one| one.cascade == cascade).collect();
        let heads = [
            "method",
            "steps",
            "edges",
            "crossings",
            "touches",
            "inverted",
            "turned",
            "wrong points",
            "area error",
            "bits",
            "constructed",
            "held",
            "time",
        ];
        let rows = all.iter().map(|one| row(measured, one)).collect();
        markdown(&mut page, cascade.name(), 1, heads.map(ToOwned::to_owned).to_vec(), rows);
        let mut told = false;
        for one in all {
            for line in sentences(one) {
                let _ = writeln!(page, "{}* {}: {line}", if told { "" } else { "\n" }, one.method);
                told = true;
            }
        }
    }
    page
}

fn row(measured: &Measured, one: &Followed) -> Vec<String> {
    let Some(last) = one.samples.last() else {
        return std::iter::once(one.method.to_string()).chain(std::iter::repeat_n("-".to_owned(), 12)).collect();
    };
    let worst = |of: fn(&Sample) -> usize| one.samples.iter().map(of).max().unwrap_or(0).to_string();
    let turned: Option<usize> = one.samples.iter().map(|sample| sample.turned).sum();
    let errors = one.samples.iter().filter_map(|sample| measured.area_error(one.cascade, sample));
    let error = errors.fold(0.0, f64::max);
    #[allow(clippy::cast_precision_loss)] // few samples
    let time = one.samples.iter().map(|sample| sample.nanoseconds).sum::<f64>() / one.samples.len() as f64 / 1e3;
    vec![
        one.method.to_string(),
        last.step.to_string(),
        last.edges.to_string(),
        worst(|sample| sample.defects.crossings),
        worst(|sample| sample.defects.touches),
        worst(|sample| sample.defects.inverted),
        turned.map_or_else(|| "-".to_owned(), |turned| turned.to_string()),
        worst(|sample| sample.lost),
        if error == 0.0 { "0".to_owned() } else { format!("{error:.1e}") },
        one.samples.iter().map(|sample| sample.bits).max().unwrap_or(0).to_string(),
        last.constructed.to_string(),
        one.samples.iter().map(|sample| sample.held).max().unwrap_or(0).to_string(),
        significant(time, 3),
    ]
}

/// Remarks that the numbers do not show.
fn sentences(one: &Followed) -> Vec<String> {
    let first = |is_so: fn(&Sample) -> bool| one.samples.iter().find(|sample| is_so(sample)).map(|sample| sample.step);
    let mut all = Vec::new();
    if let Some(step) = first(|sample| sample.defects.crossings > 0) {
        all.push(format!("edges of the result cross, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.defects.inverted > 0) {
        all.push(format!("a loop is turned over, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.lost > 0) {
        all.push(format!("points are on the wrong side, first seen after step {step}"));
    }
    if let Some(radius) = one.samples.last().map(|sample| sample.thickness).filter(|radius| *radius > 0.0) {
        all.push(format!("in the end the thickest primitive has the radius {radius:.1e}"));
    }
    all.extend(one.broken.map(|(step, broken)| format!("step {step} breaks the rule: {}", broken.rule())));
    all.extend(one.ended.as_ref().map(|(step, why)| format!("step {step} cannot be done: {why}")));
    all
}
