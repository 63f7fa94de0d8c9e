//! The judgement of volume, area and edge length by two other methods.
//!
//! The whole union is measured in sections, which do not use vertices. The judge also measures as much as it can in
//! time (all cubes, or a box full of them), from the definition, in rationals, including the vertices. The two methods
//! have to agree. Backends run the algorithm by comparing coordinates, so errors of their sums come from their
//! treatment of equal coordinates.

use crate::algorithm::{self, Mass};
use crate::checks::Measures;
use crate::truth::{Part, Truth, in_units};
use predicament_judge::cubes::Vertices;
use predicament_predicates::{PredicateKind, ZeroMeaning};
use rug::Rational;

use super::section::MassRow;
use super::{CubeUnion, Cubes, Union};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome};

/// The failed checks as [name, found, expected].
///
/// Vertices are compared only for sessions that break ties. Other sessions may find fewer vertices at equal
/// coordinates, as long as the sums are right.
fn failed(truth: &Truth, found: &Mass, zero: ZeroMeaning) -> Vec<[String; 3]> {
    let sums = &truth.measures;
    let mut checks = vec![
        ["volume".to_owned(), found.volume.to_string(), sums.volume.to_string()],
        ["area".to_owned(), found.area.to_string(), sums.area.to_string()],
        ["edge length".to_owned(), found.edge_length.to_string(), sums.edge_length.to_string()],
    ];
    if let Some(wanted) = truth.vertices.filter(|_| zero == ZeroMeaning::Never) {
        checks.push(["vertices".to_owned(), kinds(vertices(found)), kinds(wanted)]);
    }
    checks.retain(|[_, found, truth]| found != truth);
    if found.vertices.euler_characteristic().is_none() {
        let expected = "a multiple of eight quarters".to_owned();
        checks.push(["euler characteristic".to_owned(), kinds(vertices(found)), expected]);
    }
    checks
}

fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

fn vertices(of: &Mass) -> Vertices {
    let algorithm::Vertices { corners, edge_faces, three_faces } = of.vertices;
    Vertices { corners, edge_faces, three_faces }
}

fn kinds(of: Vertices) -> String {
    format!("{} corners, {} edge-face, {} three-face", of.corners, of.edge_faces, of.three_faces)
}

/// Compares the backend's union of only the cubes of a part with the judge's.
fn finding(part: &Part, asked: &Asked<'_>) -> Option<Finding> {
    let finding = |got: String, truth: String| Finding::plain(Class::Topology, "part", Vec::new(), got, truth);
    let content = Cubes { cubes: part.cubes };
    let union = match asked.backend.answer(&CubeUnion, &part.scene, &content) {
        Ok(union) => union,
        // The backend accepted the whole scene.
        Err(why) => return Some(finding(why.to_string(), format!("the union of {} cubes", part.cubes))),
    };
    let found = in_units(&measures(&union.mass), union.exponent);
    let truth = [&part.measures.volume, &part.measures.area, &part.measures.edge_length];
    let breaks_ties = asked.contract(PredicateKind::Compare).zero == ZeroMeaning::Never;
    let (got_vertices, true_vertices) = (vertices(&union.mass), part.measures.vertices);
    let same = found.each_ref() == truth && (!breaks_ties || got_vertices == true_vertices);
    let words = |[volume, area, edges]: [&Rational; 3], of: Vertices| {
        format!("volume {volume}, area {area}, edges {edges}; {}", kinds(of))
    };
    (!same).then(|| finding(words(found.each_ref(), got_vertices), words(truth, true_vertices)))
}

/// Judges the mass properties found by a backend.
pub(super) fn judge(case: &Case<'_, CubeUnion>, asked: &Asked<'_>, found: &Union, outcome: &mut Outcome) {
    let found = &found.mass;
    let zero = asked.contract(PredicateKind::Compare).zero;
    for [check, got, truth] in failed(&case.truth, found, zero) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, truth));
    }
    if let Some(finding) = case.truth.part.as_ref().and_then(|part| finding(part, asked)) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(finding);
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    let [volume, area, edge_length] = case.truth.in_units(&measures(found));
    let [true_volume, limit_area, limit_edge_length] = case.truth.in_units(&case.truth.measures);
    let loaded = case.loaded;
    outcome.row(&MassRow {
        suite: loaded.suite.clone(),
        scene: loaded.name.clone(),
        scene_id: loaded.id.clone(),
        backend: asked.backend.name(),
        cubes: case.content.cubes as u64,
        volume,
        true_volume,
        area,
        limit_area,
        edge_length,
        limit_edge_length,
        corners: found.vertices.corners,
        edge_faces: found.vertices.edge_faces,
        three_faces: found.vertices.three_faces,
    });
}
