//! The page of the study: the results of each cascade, as Markdown.

use std::fmt::Write as _;

use predicament_records::format::significant;
use predicament_report::text::{in_order, markdown};

use super::{Followed, Measured, MeshCascades, Sample};

/// A table for each cascade, and the first failures.
pub(super) fn page(study: &MeshCascades, measured: &Measured) -> String {
    let mut page = format!(
        "{} steps, measured after {} of them; seed {}; times in microseconds per step\n",
        study.steps,
        study.samples.min(study.steps),
        study.common.seed
    );
    for cascade in in_order(measured.followed.iter().map(|one| one.cascade)) {
        let all: Vec<&Followed> = measured.followed.iter().filter(|one| one.cascade == cascade).collect();
        let heads = [
            "backend",
            "steps",
            "triangles",
            "most",
            "volume",
            "true",
            "open",
            "flat",
            "crossing",
            "wrong points",
            "constructed",
            "cleared",
            "moved",
            "flaws",
            "cut",
            "passes",
            "left",
            "time",
        ];
        let rows = all.iter().map(|one| row(one)).collect();
        markdown(&mut page, cascade.name(), 1, heads.map(ToOwned::to_owned).to_vec(), rows);
        for (at, (one, line)) in
            all.iter().flat_map(|one| sentences(one).into_iter().map(move |line| (one, line))).enumerate()
        {
            let _ = writeln!(page, "{}* {}: {line}", if at == 0 { "\n" } else { "" }, one.backend);
        }
    }
    page
}

fn row(one: &Followed) -> Vec<String> {
    let Some(last) = one.samples.last() else {
        return std::iter::once(one.backend.clone()).chain(std::iter::repeat_n("-".to_owned(), 17)).collect();
    };
    let worst = |of: fn(&Sample) -> usize| one.samples.iter().map(of).max().unwrap_or(0).to_string();
    #[allow(clippy::cast_precision_loss)] // few samples
    let time = one.samples.iter().map(|sample| sample.nanoseconds).sum::<f64>() / one.samples.len() as f64 / 1e3;
    let is_known = one.samples.iter().any(|sample| sample.truth.is_some());
    let right = one.samples.iter().filter(|sample| sample.is_true()).count();
    vec![
        one.backend.clone(),
        last.step.to_string(),
        last.triangles.to_string(),
        worst(|sample| sample.triangles),
        significant(last.volume.to_f64(), 6),
        if is_known { format!("{right} of {}", one.samples.len()) } else { "-".to_owned() },
        worst(|sample| sample.open),
        worst(|sample| sample.flat),
        worst(|sample| sample.crossing),
        worst(|sample| sample.wrong),
        last.done.constructed.to_string(),
        last.done.cleared.to_string(),
        last.done.moved.to_string(),
        last.done.flaws.to_string(),
        last.done.cut.to_string(),
        last.done.passes.to_string(),
        last.done.left.to_string(),
        significant(time, 3),
    ]
}

/// Remarks that the numbers do not show.
fn sentences(one: &Followed) -> Vec<String> {
    let first = |is_so: fn(&Sample) -> bool| one.samples.iter().find(|sample| is_so(sample)).map(|sample| sample.step);
    let mut all = Vec::new();
    if let Some(step) = first(|sample| !sample.is_true()) {
        all.push(format!("volume, area or triangles are wrong, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.open > 0) {
        all.push(format!("the surface is open, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.crossing > 0) {
        all.push(format!("triangles of the result cross, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.wrong > 0) {
        all.push(format!("points are on the wrong side, first seen after step {step}"));
    }
    if let Some(step) = first(|sample| sample.done.left > 0) {
        all.push(format!(
            "rounding has left triangles that are turned over, folded or crossed, first seen after step {step}"
        ));
    }
    if let Some(done) = one.samples.last().map(|last| last.done).filter(|done| done.resolved > 0) {
        all.push(format!(
            "{} results with flaws were resolved and rounded again, {} times at most; no point moved farther than {} by these in all",
            done.resolved,
            done.passes,
            significant(done.farthest, 3)
        ));
    }
    all.extend(one.ended.as_ref().map(|(step, why)| format!("step {step} cannot be done: {why}")));
    all
}
