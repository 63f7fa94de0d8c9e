//! Converts the oracle's outcomes and the scenes' plans to rows of a run folder.

use predicament_exact::Precision;
use predicament_formats::ImportNotes;
use predicament_oracle::expect::Expectations;
use predicament_predicates::PredicateKind;
use predicament_records::{
    AnswerRow, DecimalsRow, Error, FindingRow, ImportRow, PlannedScene, PrecisionRow, RunWriter, SampledRow, StageRow,
    Status, SummaryRow,
};
use predicament_tasks::{Agreement, AnswerLine, Class, ClassCounts, Finding, Outcome, finding_id, ids};

use crate::judged::JudgedRow;

/// Writes all rows of one scene and backend, and returns the summary row.
pub fn record(
    writer: &mut RunWriter,
    scene: &PlannedScene,
    backend: &str,
    outcome: &Outcome,
    expectations: &Expectations,
    level: &str,
) -> Result<SummaryRow, Error> {
    let summary = summary(scene, backend, outcome, expectations, level);
    writer.write(std::slice::from_ref(&summary))?;
    writer.write(&findings(scene, backend, outcome))?;
    writer.write(&stages(scene, backend, outcome))?;
    writer.append(&outcome.rows)?;
    writer.write(&JudgedRow::of(scene, backend, outcome))?;
    writer.write(&decimals(scene, backend, outcome))?;
    if !outcome.answers.is_empty() {
        writer.write(&answers(scene, backend, outcome))?;
    }
    let sampled = outcome.sampled.iter().map(|truth_of| SampledRow::new(scene, backend, truth_of));
    writer.write(&sampled.collect::<Vec<_>>())?;
    Ok(summary)
}

/// The status of a row that another process wrote.
pub fn status(
    scene: &PlannedScene,
    backend: &str,
    row: &SummaryRow,
    expectations: &Expectations,
    level: &str,
) -> Status {
    let mut counts = ClassCounts::default();
    for class in Class::ALL {
        counts.add(class, row.count(class));
    }
    expectations.status(&scene.suite, &scene.scene, backend, level, &counts)
}

/// The summary row of one scene and backend.
fn summary(
    scene: &PlannedScene,
    backend: &str,
    outcome: &Outcome,
    expectations: &Expectations,
    level: &str,
) -> SummaryRow {
    let status = expectations.status(&scene.suite, &scene.scene, backend, level, &outcome.counts);
    let mut row = SummaryRow::new(scene, backend, outcome.queries, status);
    for each in Class::ALL {
        *row.count_mut(each) = outcome.counts.get(each);
    }
    row
}

/// The rows of the kept findings.
fn findings(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<FindingRow> {
    outcome.findings.iter().map(|of| finding(scene, backend, of, finding_id(&scene.scene_id, backend, of))).collect()
}

/// The row of a finding.
pub fn finding(scene: &PlannedScene, backend: &str, finding: &Finding, finding_id: String) -> FindingRow {
    let [suite, scene, scene_id, task] = scene.labels();
    FindingRow {
        finding_id,
        suite,
        scene,
        scene_id,
        task,
        backend: backend.to_owned(),
        class: finding.class,
        check: finding.check.clone(),
        query: finding.query_text(),
        got: finding.got.clone(),
        truth: finding.truth.clone(),
        log2_relative_det: finding.log2_relative_det,
        distance_over_l: finding.distance_over_l,
        stage: finding.stage.unwrap_or_default().to_owned(),
    }
}

/// The row about the decimals that were written, if the scene has a truth of decimals.
fn decimals(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<DecimalsRow> {
    let row = |agreement: Agreement| {
        let Agreement { answers, doubles, written, ties, ties_found } = agreement;
        DecimalsRow { answers, doubles, written, ties, ties_found, ..DecimalsRow::new(scene, backend) }
    };
    outcome.agreement.map(row).into_iter().collect()
}

/// The rows of all answers.
fn answers(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<AnswerRow> {
    let row = |line: &AnswerLine| {
        let [suite, scene, scene_id, task] = scene.labels();
        AnswerRow {
            suite,
            scene,
            scene_id,
            task,
            query: line.query as u64,
            args: ids(&line.args),
            backend: backend.to_owned(),
            answer: line.answer.clone(),
            exact: line.exact.clone(),
            class: line.class,
            stage: line.stage.to_owned(),
        }
    };
    outcome.answers.iter().map(row).collect()
}

/// The rows of the stages that decided at least one answer.
fn stages(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<StageRow> {
    let row = |&(stage, settled): &(&str, u64)| StageRow {
        task: scene.task.clone(),
        family: scene.family.clone(),
        backend: backend.to_owned(),
        stage: stage.to_owned(),
        settled,
    };
    outcome.stages.iter().map(row).collect()
}

/// The row with the changes made while reading a scene, if there are any.
pub fn imported(scene: &PlannedScene, notes: &ImportNotes) -> Option<ImportRow> {
    let row = ImportRow {
        rounded: notes.rounded as u64,
        extra_coordinates: notes.extra_coordinates as u64,
        repeated_points: notes.repeated_points as u64,
        degenerate_rings: notes.degenerate_rings as u64,
        degenerate_faces: notes.degenerate_faces as u64,
        empty_regions: notes.empty_regions as u64,
        ..ImportRow::new(scene)
    };
    (!notes.is_clean()).then_some(row)
}

/// The row of a scene's precision plan.
pub fn precision(scene: &PlannedScene, plan: &Precision) -> PrecisionRow {
    let arithmetic = |predicate: PredicateKind| {
        let choice = plan.choices.iter().find(|choice| choice.predicate == predicate);
        choice.map(|choice| choice.arithmetic.name().to_owned()).unwrap_or_default()
    };
    PrecisionRow::new(scene, [plan.lowest, plan.bits], arithmetic)
}
