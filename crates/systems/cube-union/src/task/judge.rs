//! The judgement of volume, area and edge length by two other methods.
//!
//! The whole union is measured in sections, which do not use vertices. The judge also measures as much as it can in
//! time (all cubes, or a box full of them), from the definition, in rationals, including the vertices. The two methods
//! have to agree. Backends run the algorithm by comparing coordinates, so errors of their sums come from their
//! treatment of equal coordinates. Backends that break ties have to find the perturbed union, and all others the union
//! of closed cubes.

use std::collections::BTreeMap;

use crate::algorithm::{self, Mass, ScaledCubes, cube_union};
use crate::checks::Measures;
use crate::truth::{Part, Truth, in_units};
use predicament_judge::cubes::{Shape, Vertices, shape};
use predicament_predicates::{PredicateKind, ZeroMeaning};
use rug::Rational;

use super::section::MassRow;
use super::{CubeUnion, Cubes, Union};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome};

/// A check: its name, and the found and the expected value in words.
type Checked = [String; 3];

/// The checks of a union, by the meaning of the backend's zeros. The perturbed union is expected of a backend that
/// breaks ties, and the union of closed cubes of any other.
fn checks(truth: &Truth, found: &Mass, zero: ZeroMeaning) -> Vec<Checked> {
    let is_perturbed = zero == ZeroMeaning::Never;
    let sums = if is_perturbed { &truth.measures } else { &truth.closed };
    let mut checks = vec![
        ["volume".to_owned(), found.volume.to_string(), sums.volume.to_string()],
        ["area".to_owned(), found.area.to_string(), sums.area.to_string()],
        ["edge length".to_owned(), found.edge_length.to_string(), sums.edge_length.to_string()],
    ];
    let mut check = |name: &str, found: String, expected: String| checks.push([name.to_owned(), found, expected]);
    if is_perturbed {
        if let Some(wanted) = truth.vertices {
            check("vertices", kinds(vertices(found)), kinds(wanted));
        }
        if found.vertices.euler_characteristic().is_none() {
            check("euler characteristic", all_kinds(&found.vertices), "a multiple of eight quarters".to_owned());
        }
    } else {
        let euler = found.vertices.of_the_union().map(|euler| euler.to_string());
        let got = euler.clone().unwrap_or_else(|| all_kinds(&found.vertices));
        match &truth.counted {
            Some(counted) => {
                check("vertices", shapes(&by_shape(&found.vertices)), shapes(&counted.vertices));
                check("euler characteristic", got, counted.euler_characteristic.to_string());
            }
            None if euler.is_none() => check("euler characteristic", got, "a multiple of eight eighths".to_owned()),
            None => {}
        }
    }
    checks
}

/// The failed checks.
fn failed(truth: &Truth, found: &Mass, zero: ZeroMeaning) -> Vec<Checked> {
    let mut checks = checks(truth, found, zero);
    checks.retain(|[_, found, truth]| found != truth);
    checks
}

/// The numbers of vertices by shape.
fn by_shape(of: &algorithm::Vertices) -> BTreeMap<Shape, u64> {
    of.by_octants().filter(|&(_, count)| count > 0).map(|(octants, count)| (shape(octants), count)).collect()
}

fn shapes(of: &BTreeMap<Shape, u64>) -> String {
    let words = |([octants, faces, edges], count): (&Shape, &u64)| {
        format!("{count} of {octants} octants with {faces} common faces and {edges} common edges")
    };
    if of.is_empty() { "none".to_owned() } else { of.iter().map(words).collect::<Vec<_>>().join(", ") }
}

fn all_kinds(of: &algorithm::Vertices) -> String {
    let words = |(name, count): (&str, u64)| format!("{count} {name}");
    of.by_name().filter(|&(_, count)| count > 0).map(words).collect::<Vec<_>>().join(", ")
}

fn measures(mass: &Mass) -> Measures {
    Measures { volume: mass.volume, area: mass.area, edge_length: mass.edge_length }
}

fn vertices(of: &Mass) -> Vertices {
    let algorithm::Vertices { corners, edge_faces, three_faces, .. } = of.vertices;
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
    let words = |[volume, area, edges]: [&Rational; 3], vertices: String| {
        format!("volume {volume}, area {area}, edges {edges}; {vertices}")
    };
    let (got, truth) = if asked.contract(PredicateKind::Compare).zero == ZeroMeaning::Never {
        let of = &part.measures;
        let truth = words([&of.volume, &of.area, &of.edge_length], kinds(of.vertices));
        (words(found.each_ref(), kinds(vertices(&union.mass))), truth)
    } else {
        let of = part.closed.as_ref()?;
        let euler =
            |of: Option<i128>| of.map_or("no Euler characteristic".to_owned(), |of| format!("characteristic {of}"));
        let vertices = [shapes(&by_shape(&union.mass.vertices)), euler(union.mass.vertices.of_the_union())].join("; ");
        let wanted = [shapes(&of.vertices), euler(Some(of.euler_characteristic.into()))].join("; ");
        (words(found.each_ref(), vertices), words([&of.volume, &of.area, &of.edge_length], wanted))
    };
    (got != truth).then(|| finding(got, truth))
}

/// The perturbed union by the algorithm that sorts cubes into cells and asks no session.
fn by_cells(case: &Case<'_, CubeUnion>, zero: ZeroMeaning) -> Option<Mass> {
    let cubes = ScaledCubes::of_scene(case.scene()).ok().filter(|_| zero == ZeroMeaning::Never)?;
    cube_union(&cubes.lowers, cubes.edge).ok()
}

/// Judges the mass properties found by a backend.
pub(super) fn judge(case: &Case<'_, CubeUnion>, asked: &Asked<'_>, found: &Union, outcome: &mut Outcome) {
    let found = &found.mass;
    let zero = asked.contract(PredicateKind::Compare).zero;
    for [check, got, truth] in failed(&case.truth, found, zero) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), got, truth));
    }
    let shortcut = asked.contract(PredicateKind::Compare).proved.then(|| by_cells(case, zero)).flatten();
    if let Some(wanted) = shortcut.filter(|other| other != found) {
        outcome.counts.add(Class::Topology, 1);
        let [got, truth] = [&wanted, found].map(|mass| format!("{mass:?}"));
        outcome.findings.push(Finding::plain(Class::Topology, "shortcut", Vec::new(), got, truth));
    }
    if let Some(finding) = case.truth.part.as_ref().and_then(|part| finding(part, asked)) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(finding);
    }
    if outcome.findings.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
    let [volume, area, edge_length] = case.truth.in_units(&measures(found));
    let expected = if zero == ZeroMeaning::Never { &case.truth.measures } else { &case.truth.closed };
    let [true_volume, limit_area, limit_edge_length] = case.truth.in_units(expected);
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
