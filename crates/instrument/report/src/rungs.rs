//! The rungs of the backends' ladders, in order.

use crate::RunDir;

/// The rung of a stage, and its number there: `term 12` is number 12 of the rung `term`.
pub fn rung(stage: &str) -> (&str, Option<u64>) {
    let numbered = stage.rsplit_once(' ').and_then(|(rung, n)| Some((rung, Some(n.parse().ok()?))));
    numbered.unwrap_or((stage, None))
}

/// All rungs that occur, cheapest first: the rungs of the plans' ladders, then the others in the order of the files.
///
/// A scene lists only rungs that settled a query, so the files alone do not determine the order of rungs of different
/// scenes.
pub fn rungs(runs: &[RunDir]) -> Vec<&str> {
    let mut seen: Vec<&str> = Vec::new();
    for row in runs.iter().flat_map(|run| &run.stages) {
        let (rung, _) = rung(&row.stage);
        if !seen.contains(&rung) {
            seen.push(rung);
        }
    }
    let planned: Vec<&str> = runs.iter().flat_map(|run| &run.plan.ladder).map(String::as_str).collect();
    // The sort is stable.
    seen.sort_by_key(|rung| planned.iter().position(|other| other == rung).unwrap_or(planned.len()));
    seen
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_records::StageRow;

    #[test]
    fn only_a_number_after_a_space_is_one() {
        assert_eq!(rung("term 12"), ("term", Some(12)));
        for stage in ["term", "wide integer", "step-2", "term 1a", ""] {
            assert_eq!(rung(stage), (stage, None));
        }
    }

    #[test]
    fn a_rung_that_is_seen_late_still_finds_its_place() {
        let mut run = RunDir::open("../tasks/tests/data/timed").unwrap();
        let row = |stage: &str| StageRow {
            task: "orient2d".to_owned(),
            family: "near".to_owned(),
            backend: "sos".to_owned(),
            stage: stage.to_owned(),
            settled: 1,
        };
        run.stages =
            ["filter", "dyadic", "term 4", "term 12", "integer", "term 1", "double", "float"].map(row).to_vec().into();
        let runs = |ladder: &[&str]| {
            let mut run = run.clone();
            run.plan.ladder = ladder.iter().map(|&rung| rung.to_owned()).collect();
            [run]
        };
        let known = runs(&["compare", "double", "filter", "integer", "dyadic"]);
        assert_eq!(rungs(&known), ["double", "filter", "integer", "dyadic", "term", "float"]);
        // A plan without a ladder, as in older folders.
        assert_eq!(rungs(&runs(&[])), ["filter", "dyadic", "term", "integer", "double", "float"]);
    }
}
