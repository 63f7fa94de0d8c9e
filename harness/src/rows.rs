//! From the oracle's outcomes and the scenes' plans to the rows of a run folder.

use predicament_algorithms::contacts::Level;
use predicament_exact::Precision;
use predicament_oracle::expect::Expectations;
use predicament_oracle::{Class, Finding, MassCounts, Outcome, finding_id};
use predicament_predicates::PredicateKind;
use predicament_report::{
    ContactRow, FindingRow, LocateRow, MassRow, PlannedScene, PrecisionRow, StageRow, SummaryRow,
};

/// The row of one scene and backend.
pub fn summary(
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
pub fn findings(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<FindingRow> {
    outcome.findings.iter().map(|finding| row(scene, backend, finding)).collect()
}

fn row(scene: &PlannedScene, backend: &str, finding: &Finding) -> FindingRow {
    FindingRow {
        finding_id: finding_id(&scene.scene_id, backend, finding),
        suite: scene.suite.clone(),
        scene: scene.scene.clone(),
        scene_id: scene.scene_id.clone(),
        task: scene.task.clone(),
        backend: backend.to_owned(),
        class: finding.class,
        check: finding.check.clone(),
        query: finding.query.clone(),
        got: finding.got.clone(),
        truth: finding.truth.clone(),
        log2_relative_det: finding.log2_relative_det,
        distance_over_l: finding.distance_over_l,
        stage: finding.stage.unwrap_or_default().to_owned(),
    }
}

/// The rows of the stages that settled something.
pub fn stages(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<StageRow> {
    let row = |&(stage, settled): &(&str, u64)| StageRow {
        task: scene.task.clone(),
        family: scene.family.clone(),
        backend: backend.to_owned(),
        stage: stage.to_owned(),
        settled,
    };
    outcome.stages.iter().map(row).collect()
}

/// The rows of a map.
pub fn locate(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<LocateRow> {
    let row = |counts: &predicament_oracle::LocateCounts| LocateRow {
        suite: scene.suite.clone(),
        scene: scene.scene.clone(),
        scene_id: scene.scene_id.clone(),
        backend: backend.to_owned(),
        surroundings: counts.surroundings.clone(),
        probes: counts.probes,
        in_none: counts.in_none,
        in_one: counts.in_one,
        in_many: counts.in_many,
        on_boundary: counts.on_boundary,
        violations: counts.violations,
    };
    outcome.locate.iter().map(row).collect()
}

/// The rows of two complexes.
pub fn contacts(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<ContactRow> {
    let row = |level: &Level| ContactRow {
        suite: scene.suite.clone(),
        scene: scene.scene.clone(),
        scene_id: scene.scene_id.clone(),
        task: scene.task.clone(),
        backend: backend.to_owned(),
        rank_a: level.ranks[0],
        rank_b: level.ranks[1],
        candidates: level.candidates,
        ended: level.ended,
        asked: level.asked,
        registered: level.registered,
    };
    outcome.contacts.iter().map(row).collect()
}

/// The row of a union of cubes.
pub fn masses(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<MassRow> {
    let row = |mass: MassCounts| {
        let ([volume, area, edge_length], [true_volume, true_area, true_edge_length]) = (mass.found, mass.truth);
        let [corners, edge_faces, three_faces] = mass.vertices;
        MassRow {
            suite: scene.suite.clone(),
            scene: scene.scene.clone(),
            scene_id: scene.scene_id.clone(),
            backend: backend.to_owned(),
            cubes: mass.cubes,
            volume,
            true_volume,
            area,
            true_area,
            edge_length,
            true_edge_length,
            corners,
            edge_faces,
            three_faces,
        }
    };
    outcome.mass.map(row).into_iter().collect()
}

/// The row of a scene's precision plan.
pub fn precision(scene: &PlannedScene, plan: &Precision) -> PrecisionRow {
    let arithmetic = |predicate: PredicateKind| {
        let choice = plan.choices.iter().find(|choice| choice.predicate == predicate);
        choice.map(|choice| choice.arithmetic.name().to_owned()).unwrap_or_default()
    };
    PrecisionRow {
        suite: scene.suite.clone(),
        scene: scene.scene.clone(),
        scene_id: scene.scene_id.clone(),
        lowest: plan.lowest,
        bits: plan.bits,
        orient2d: arithmetic(PredicateKind::Orient2d),
        orient3d: arithmetic(PredicateKind::Orient3d),
        incircle: arithmetic(PredicateKind::Incircle),
        insphere: arithmetic(PredicateKind::Insphere),
    }
}
